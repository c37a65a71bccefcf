/// CGAL's Delaunay triangulation, kept out of the other translation units: its headers take long and warn.
#pragma once

#include <cstddef>
#include <span>

#include "thalweg/point.hpp"

namespace peers {

/// Triangulates with exact predicates, spatial sort included.
std::size_t cgal_face_count(std::span<const thalweg::Point2> points);

}  // namespace peers
