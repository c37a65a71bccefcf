/// What targets that look into triangulations share.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "fuzz_input.hpp"
#include "support/brute.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"
#include "thalweg/triangulation.hpp"

namespace fuzz {

using Corners = std::array<std::uint32_t, 3>;

inline std::vector<Corners> triangles_of(const thalweg::Triangulation& t) {
  std::vector<Corners> result;
  for (std::uint32_t f = 0; f < t.face_count(); ++f) {
    const auto [a, b, c] = t.corners(thalweg::FaceId(f));
    result.push_back({a.index(), b.index(), c.index()});
  }
  return result;
}

/// The triangles, each from its first corner, sorted.
inline std::vector<Corners> triangle_set(const thalweg::Triangulation& t) {
  std::vector<Corners> triangles = triangles_of(t);
  for (Corners& c : triangles) std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Whether h may be flipped: it has a quadrilateral, and that is strictly convex.
inline bool flippable(const thalweg::Triangulation& t, const std::vector<thalweg::Point2>& sites,
                      thalweg::HalfedgeId h) {
  if (!h.valid() || t.on_hull(h)) return false;
  const auto at = [&](thalweg::VertexId v) { return sites[v.index()]; };
  const thalweg::Point2 a = at(t.origin(h)), b = at(t.dest(h)), c = at(t.apex(h)), d = at(t.apex(t.twin(h)));
  return thalweg::orient2d(c, d, b) > 0 && thalweg::orient2d(d, c, a) > 0;
}

/// The points without those at the place of an earlier one; none if one is not finite.
inline std::vector<thalweg::Point2> distinct_sites(const std::vector<thalweg::Point2>& points) {
  std::vector<thalweg::Point2> sites;
  if (!all_finite(points)) return sites;
  for (const std::uint32_t row : support::distinct_rows(points)) sites.push_back(points[row]);
  return sites;
}

}  // namespace fuzz
