/// The plane in integers: signs by 128-bit arithmetic, everything by definition. Shares no code with src/.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "thalweg/point.hpp"

namespace oracle {

__extension__ using Wide = __int128;

/// A site with integer coordinates. Requires: |x|, |y| < 2^29, so that no sign below can overflow:
/// differences are below 2^30, areas below 2^61, and the terms of incircle below 3 * 2^61 * 2^61 < 2^124.
struct Site {
  std::int64_t x = 0;
  std::int64_t y = 0;
  double z = 0;
};

using Tri = std::array<std::uint32_t, 3>;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

inline std::int64_t integer(double value) {
  const auto result = static_cast<std::int64_t>(value);
  if (static_cast<double>(result) != value || std::abs(result) >= (std::int64_t{1} << 29)) {
    throw std::invalid_argument("the oracle takes small integers only");
  }
  return result;
}

inline std::vector<Site> sites_of(std::span<const thalweg::Point3> points) {
  std::vector<Site> result;
  for (const auto& p : points) result.push_back({integer(p.x), integer(p.y), p.z});
  return result;
}

inline std::vector<Site> sites_of(std::span<const thalweg::Point2> points) {
  std::vector<Site> result;
  for (const auto& p : points) result.push_back({integer(p.x), integer(p.y), 0});
  return result;
}

inline int sign(Wide value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// Twice the signed area of abc.
inline std::int64_t area(const Site& a, const Site& b, const Site& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

inline int turn(const Site& a, const Site& b, const Site& c) {
  return sign(area(a, b, c));
}

/// +1 if d is strictly inside the circle through a, b, c, 0 if on it, -1 if outside, whichever way abc turns.
inline int in_circle(const Site& a, const Site& b, const Site& c, const Site& d) {
  const Wide ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
  const Wide a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const Wide det = a2 * (bx * cy - by * cx) - b2 * (ax * cy - ay * cx) + c2 * (ax * by - ay * bx);
  return sign(det) * turn(a, b, c);
}

/// Whether p lies on the segment ab without its ends.
inline bool on_open_segment(const Site& a, const Site& b, const Site& p) {
  if (turn(a, b, p) != 0) return false;
  const std::int64_t along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
  const std::int64_t length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
  return along > 0 && along < length;
}

/// Whether the open segments ab and cd have exactly one common point, inside both.
inline bool cross(const Site& a, const Site& b, const Site& c, const Site& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// Whether the segment uv joins two sites with none between them.
inline bool is_open_pair(std::span<const Site> s, std::uint32_t u, std::uint32_t v) {
  return std::none_of(s.begin(), s.end(), [&](const Site& p) { return on_open_segment(s[u], s[v], p); });
}

inline bool all_collinear(std::span<const Site> s) {
  for (std::size_t i = 2; i < s.size(); ++i) {
    for (std::size_t j = 1; j < i; ++j) {
      if (turn(s[0], s[j], s[i]) != 0) return false;
    }
  }
  return true;
}

/// The directed edges of the convex hull, through every site on it, by definition: pairs with no site between
/// them and none on the right.
inline std::vector<Pair> hull_edges(std::span<const Site> s) {
  std::vector<Pair> result;
  const auto n = static_cast<std::uint32_t>(s.size());
  for (std::uint32_t u = 0; u < n; ++u) {
    for (std::uint32_t v = 0; v < n; ++v) {
      if (u == v || (s[u].x == s[v].x && s[u].y == s[v].y)) continue;
      const bool right_empty =
          std::none_of(s.begin(), s.end(), [&](const Site& p) { return turn(s[u], s[v], p) < 0; });
      if (right_empty && is_open_pair(s, u, v)) result.emplace_back(u, v);
    }
  }
  return result;
}

/// Twice the area of the convex hull. Sites may coincide.
inline std::int64_t hull_area(std::span<const Site> s) {
  std::vector<Site> distinct;
  for (const Site& p : s) {
    if (std::none_of(distinct.begin(), distinct.end(),
                     [&](const Site& q) { return p.x == q.x && p.y == q.y; })) {
      distinct.push_back(p);
    }
  }
  if (all_collinear(distinct)) return 0;
  std::int64_t sum = 0;
  for (const auto& [u, v] : hull_edges(distinct)) sum += area(distinct[0], distinct[u], distinct[v]);
  return sum;
}

/// Whether two counter-clockwise triangles share area: no side of either has the other on its right.
inline bool share_area(std::span<const Site> s, const Tri& a, const Tri& b) {
  const auto separates = [&](const Tri& t, const Tri& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::all_of(other.begin(), other.end(),
                      [&](std::uint32_t v) { return turn(s[t[i]], s[t[(i + 1) % 3]], s[v]) <= 0; })) {
        return true;
      }
    }
    return false;
  };
  return !separates(a, b) && !separates(b, a);
}

/// Whether the triangles are a counter-clockwise triangulation of distinct sites: all in range and turning
/// left, no two sharing area, together as large as the hull, every site a corner and none inside a side.
inline bool is_triangulation(std::span<const Site> s, std::span<const Tri> triangles) {
  std::vector<bool> used(s.size(), false);
  std::int64_t sum = 0;
  for (const Tri& t : triangles) {
    for (const std::uint32_t v : t) {
      if (v >= s.size()) return false;
      used[v] = true;
    }
    if (area(s[t[0]], s[t[1]], s[t[2]]) <= 0) return false;
    sum += area(s[t[0]], s[t[1]], s[t[2]]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_open_pair(s, t[i], t[(i + 1) % 3])) return false;
    }
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (!used[i]) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (s[i].x == s[j].x && s[i].y == s[j].y) return false;
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (share_area(s, triangles[i], triangles[j])) return false;
    }
  }
  return sum == hull_area(s);
}

}  // namespace oracle
