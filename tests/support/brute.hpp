/// Orders by definition for any doubles, from the library's predicates alone, which have an oracle of their
/// own: every site is looked at, every time. Sites are the rows in `rows`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/predicates.hpp"

namespace support {

using Rows = std::vector<std::uint32_t>;

/// The first row at each place.
inline Rows distinct_rows(std::span<const thalweg::Point2> points) {
  Rows rows;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (std::find(points.begin(), points.begin() + i, points[i]) == points.begin() + i) rows.push_back(i);
  }
  return rows;
}

inline bool all_collinear(std::span<const thalweg::Point2> points, const Rows& rows) {
  return rows.size() < 3 || std::all_of(rows.begin(), rows.end(), [&](std::uint32_t r) {
           return thalweg::orient2d(points[rows[0]], points[rows[1]], points[r]) == 0;
         });
}

/// Sites strictly inside the circle through a, b, c, which turn left.
inline unsigned sites_in_circle(std::span<const thalweg::Point2> points, const Rows& rows, std::uint32_t a,
                                std::uint32_t b, std::uint32_t c) {
  return static_cast<unsigned>(std::count_if(rows.begin(), rows.end(), [&](std::uint32_t r) {
    return thalweg::incircle(points[a], points[b], points[c], points[r]) > 0;
  }));
}

/// Whether r lies on the open segment uv: on its line, and between by (x, y).
inline bool lies_between(thalweg::Point2 u, thalweg::Point2 v, thalweg::Point2 r) {
  if (thalweg::orient2d(u, v, r) != 0) return false;
  const auto less = [](thalweg::Point2 a, thalweg::Point2 b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  return (less(u, r) && less(r, v)) || (less(v, r) && less(r, u));
}

/// The useful order of the pair of rows; nothing if a site lies between.
inline std::optional<unsigned> useful_order_of(std::span<const thalweg::Point2> points, const Rows& rows,
                                               std::uint32_t u, std::uint32_t v) {
  const auto between = [&](std::uint32_t r) { return lies_between(points[u], points[v], points[r]); };
  if (std::any_of(rows.begin(), rows.end(), between)) return std::nullopt;
  const auto side = [&](std::uint32_t a, std::uint32_t b) {
    std::optional<std::uint32_t> best;
    for (const std::uint32_t r : rows) {
      if (thalweg::orient2d(points[a], points[b], points[r]) <= 0) continue;
      if (!best || thalweg::incircle(points[a], points[b], points[*best], points[r]) > 0) best = r;
    }
    return best ? sites_in_circle(points, rows, a, b, *best) : 0u;
  };
  return std::max(side(u, v), side(v, u));
}

}  // namespace support
