/// Judges a Delaunay triangulation with the exact arithmetic of tests/oracle, and point sets that are hard on
/// it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "oracle/exact_predicates.hpp"
#include "support/point_sets.hpp"
#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace support {

/// The edge from u to v between the triangles with apices c and d: whether the perturbation keeps it. The
/// lexicographically largest of four cocircular sites is lifted out of the circle, so it must not be an end
/// of the diagonal.
inline bool keeps_edge(Point2 u, Point2 v, Point2 c, Point2 d) {
  const int inside = oracle::incircle(u, v, c, d);
  if (inside != 0) return inside < 0;
  const Point2 largest_end = lexicographic(u, v) ? v : u;
  const Point2 largest_apex = lexicographic(c, d) ? d : c;
  return lexicographic(largest_end, largest_apex);
}

/// What is wrong with `t` as the canonical Delaunay triangulation of `points`, or "".
inline std::string fault_of(const std::vector<Point2>& points, const thalweg::Triangulation& t) {
  using thalweg::HalfedgeId;
  if (t.vertex_count() != points.size()) return "vertex count";
  if (auto fault = t.find_fault()) return *fault;
  const auto at = [&](thalweg::VertexId v) { return points[v.index()]; };
  std::uint32_t hull = 0;
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const Point2 u = at(t.origin(h)), v = at(t.dest(h)), c = at(t.apex(h));
    if (i % 3 == 0 && oracle::orient2d(u, v, c) <= 0) return "a triangle that is not counter-clockwise";
    if (!t.on_hull(h)) {
      if (t.twin(h) > h && !keeps_edge(u, v, c, at(t.apex(t.twin(h))))) return "an edge that is not Delaunay";
      continue;
    }
    ++hull;
    if (oracle::orient2d(u, v, at(t.dest(t.outgoing(t.dest(h))))) < 0) return "a hull that is not convex";
  }
  std::set<std::pair<double, double>> distinct;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const bool first = distinct.insert({points[i].x + 0.0, points[i].y + 0.0}).second;
    if (t.isolated(thalweg::VertexId(i)) == first) return first ? "a site left out" : "a duplicate used";
  }
  if (t.face_count() != 2 * distinct.size() - 2 - hull) return "too few or too many triangles";
  return "";
}

/// The triangles as coordinates, so that triangulations of permuted rows can be compared.
inline std::set<std::array<std::pair<double, double>, 3>> triangle_set(const std::vector<Point2>& points,
                                                                       const thalweg::Triangulation& t) {
  std::set<std::array<std::pair<double, double>, 3>> result;
  for (std::uint32_t f = 0; f < t.face_count(); ++f) {
    std::array<std::pair<double, double>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2 p = points[t.corners(thalweg::FaceId(f))[i].index()];
      corners[i] = {p.x + 0.0, p.y + 0.0};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert(corners);
  }
  return result;
}

}  // namespace support
