/// Terrains for tests of the heuristics.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "terrain/surface.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/point.hpp"

namespace support {

/// The surface over the points, vertex ids their indices. Requires: distinct places, not all collinear.
inline thalweg::detail::Surface surface_of(std::span<const thalweg::Point3> points) {
  thalweg::detail::Array<thalweg::Point2> places;
  thalweg::detail::Array<double> z;
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

/// Four pits around a crossing, west 0, east 1, north 2, south 3, with high walls on the diagonals. 1 is the
/// lowest. At order 3 the only ways out are 0 to 1 and 2 to 3, which cross; at order 5 each pit but 1 can
/// also drain around a corner: 0 to 3, 2 to 0, 3 to 1.
inline std::vector<thalweg::Point3> crossroads() {
  std::vector<thalweg::Point3> points = {{-3, 0, 1}, {3, 0.5, 0}, {0.25, 3, 1.5}, {0, -3, 0.25}};
  for (const double a : {2.0, 3.0, 4.0, 5.0, 20.0}) {
    for (const double x : {a, -a}) {
      for (const double y : {a, -a}) points.push_back({x, y, 9});
    }
  }
  return points;
}

}  // namespace support
