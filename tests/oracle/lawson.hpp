/// The slow, obvious way to the canonical Delaunay triangulation of points with small integer coordinates:
/// insert the points in lexicographic order, each joined to all edges of the hull that it sees, then flip
/// until nothing changes.
///
/// Shares no code with src/: its own arithmetic (128-bit integers), its own tie rule (the perturbed
/// determinant, expanded term by term), triangles in a set. Source: Lawson 1977.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace oracle::lawson {

__extension__ using Int128 = __int128;

/// |x|, |y| <= 2^28, so that the determinants below fit.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

inline int sign(Int128 v) {
  return static_cast<int>(v > 0) - static_cast<int>(v < 0);
}

inline int orientation(GridPoint a, GridPoint b, GridPoint c) {
  return sign(Int128{b.x - a.x} * (c.y - a.y) - Int128{b.y - a.y} * (c.x - a.x));
}

/// The sign of the determinant of four rows (x, y, x^2 + y^2, 1); for a, b, c counter-clockwise, +1 means d
/// inside.
inline int circle_determinant(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  const auto minor = [](GridPoint p, GridPoint q, GridPoint r) {
    return Int128{q.x - p.x} * (r.y - p.y) - Int128{q.y - p.y} * (r.x - p.x);
  };
  const auto lift = [](GridPoint p) { return Int128{p.x} * p.x + Int128{p.y} * p.y; };
  return sign(lift(a) * minor(b, c, d) - lift(b) * minor(a, c, d) + lift(c) * minor(a, b, d) -
              lift(d) * minor(a, b, c));
}

/// The same, with the lift of the lexicographically largest point raised, then that of the second largest,
/// and so on.
inline int perturbed_circle(std::array<GridPoint, 4> p) {
  if (const int s = circle_determinant(p[0], p[1], p[2], p[3]); s != 0) return s;
  std::array<std::size_t, 4> by_size = {0, 1, 2, 3};
  std::sort(by_size.begin(), by_size.end(), [&](std::size_t i, std::size_t j) { return p[i] > p[j]; });
  for (const std::size_t raised : by_size) {
    std::array<GridPoint, 3> others;
    for (std::size_t i = 0, k = 0; i < 4; ++i) {
      if (i != raised) others[k++] = p[i];
    }
    const int cofactor = orientation(others[0], others[1], others[2]);
    if (cofactor != 0) return raised % 2 == 0 ? cofactor : -cofactor;
  }
  return 0;
}

/// Corners counter-clockwise, the lowest index first.
using IndexTriangle = std::array<std::size_t, 3>;

inline IndexTriangle rotated_to_lowest(IndexTriangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// The triangles over distinct points; none if all are collinear.
inline std::set<IndexTriangle> delaunay(const std::vector<GridPoint>& points) {
  std::vector<std::size_t> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return points[i] < points[j]; });

  std::map<std::pair<std::size_t, std::size_t>, std::size_t>
      apex;  // directed edge -> third corner on its left
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    apex[{a, b}] = c;
    apex[{b, c}] = a;
    apex[{c, a}] = b;
  };
  const auto remove = [&](std::size_t a, std::size_t b, std::size_t c) {
    apex.erase({a, b});
    apex.erase({b, c});
    apex.erase({c, a});
  };

  // A leading run on one line has no triangle: the first point off the line is joined to each of its edges.
  std::size_t run = std::min<std::size_t>(2, order.size());
  while (run < order.size() && orientation(points[order[0]], points[order[1]], points[order[run]]) == 0)
    ++run;
  if (run == order.size()) return {};
  for (std::size_t i = 0; i + 1 < run; ++i) {
    const std::size_t p = order[i], q = order[i + 1], r = order[run];
    if (orientation(points[p], points[q], points[r]) > 0) {
      add(p, q, r);
    } else {
      add(q, p, r);
    }
  }
  for (std::size_t i = run + 1; i < order.size(); ++i) {
    std::vector<std::pair<std::size_t, std::size_t>> seen;
    for (const auto& [edge, unused] : apex) {
      const auto [a, b] = edge;
      if (!apex.contains({b, a}) && orientation(points[a], points[b], points[order[i]]) < 0)
        seen.push_back(edge);
    }
    for (const auto& [a, b] : seen) add(b, a, order[i]);
  }

  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [edge, c] : std::map(apex)) {
      const auto [a, b] = edge;
      const auto here = apex.find({a, b});
      const auto there = apex.find({b, a});
      if (here == apex.end() || there == apex.end() || here->second != c) continue;
      const std::size_t d = there->second;
      if (perturbed_circle({points[a], points[b], points[c], points[d]}) <= 0) continue;
      remove(a, b, c);
      remove(b, a, d);
      add(c, d, b);
      add(d, c, a);
      changed = true;
    }
  }

  std::set<IndexTriangle> triangles;
  for (const auto& [edge, c] : apex) triangles.insert(rotated_to_lowest({edge.first, edge.second, c}));
  return triangles;
}

}  // namespace oracle::lawson
