/// Everything in the library, floor by floor.
#pragma once

#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/drainage.hpp"
#include "thalweg/export.hpp"
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

/// Terrains without false pits: a geometry kernel of exact predicates, Delaunay triangulations and their
/// neighbours of higher order, and what to do with it about pits. Nothing in it prints, exits or throws, but
/// that std::bad_alloc passes, and std::length_error where an array outgrows 32-bit addresses. There is no
/// state but in objects, save what fresh memory has lately cost, on which no result depends; `const` is safe
/// for concurrent readers.
namespace thalweg {}
