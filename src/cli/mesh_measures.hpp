/// What is measured of any mesh, whoever made it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::cli {

/// Inner edges that are not locally Delaunay. Requires: vertex v lies at sites[v].
std::uint64_t count_non_delaunay(const Triangulation& mesh, std::span<const Point2> sites);

std::vector<Point2> places_of(std::span<const Point3> points);

}  // namespace thalweg::cli
