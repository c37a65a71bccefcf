/// Everything in the library, floor by floor.
#pragma once

#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/drainage.hpp"
#include "thalweg/hard_instances.hpp"
#include "thalweg/id.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/pits.hpp"
#include "thalweg/point.hpp"
#include "thalweg/predicates.hpp"
#include "thalweg/result.hpp"
#include "thalweg/triangulation.hpp"
#include "thalweg/useful_order.hpp"
#include "thalweg/validate.hpp"
#include "thalweg/version.hpp"
#include "thalweg/voronoi_counter.hpp"
