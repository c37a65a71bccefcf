/// Terrains for tests of the heuristics.
#pragma once

#include <span>
#include <vector>

#include "terrain/surface.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/point.hpp"

namespace support {

/// The surface over the points, vertex ids their indices. Requires: distinct places, not all collinear.
inline thalweg::detail::Surface surface_of(std::span<const thalweg::Point3> points) {
  std::vector<thalweg::Point2> places;
  std::vector<double> z;
  for (const thalweg::Point3& p : points) {
    places.push_back({p.x, p.y});
    z.push_back(p.z);
  }
  thalweg::Triangulation delaunay = thalweg::delaunay(places).value();
  return {std::move(places), std::move(z), std::move(delaunay)};
}

/// Two valleys, a dam between them: 0 is a pit that could drain to 1, was there not the edge 2 - 3. The pair
/// 0, 1 has useful order 1; both its triangles hold the other end of the dam. Around it a high rim.
///
///     5-------------4
///     |      2      |
///     |  0  dam  1  |
///     |      3      |
///     6-------------7
inline std::vector<thalweg::Point3> dammed_valley() {
  return {{-2, 0, 1},   {2, 0, 0},    {0, 1, 5},     {0, -1, 5},
          {50, 40, 10}, {-50, 40, 9}, {-50, -40, 8}, {50, -40, 7}};
}

}  // namespace support
