/// Orders by definition: every site is looked at, every time.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "oracle/plane.hpp"

namespace oracle {

/// The number of sites strictly inside the circle through three sites that are not collinear.
inline unsigned triangle_order(std::span<const Site> s, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  unsigned count = 0;
  for (const Site& p : s) count += in_circle(s[a], s[b], s[c], p) > 0 ? 1u : 0u;
  return count;
}

inline unsigned triangle_order(std::span<const Site> s, const Tri& t) {
  return triangle_order(s, t[0], t[1], t[2]);
}

/// A site left of uv whose circle through u and v has no site left of uv strictly inside; nothing if no site
/// is left of uv. Of several, which must all be cocircular with u and v, the first.
inline std::optional<std::uint32_t> nearest_left(std::span<const Site> s, std::uint32_t u, std::uint32_t v) {
  std::optional<std::uint32_t> best;
  for (std::uint32_t p = 0; p < s.size(); ++p) {
    if (turn(s[u], s[v], s[p]) <= 0) continue;
    if (!best || in_circle(s[u], s[v], s[*best], s[p]) > 0) best = p;
  }
  return best;
}

/// The useful order of the pair; nothing if a site lies between. Requires: u != v, sites not all collinear.
inline std::optional<unsigned> useful_order(std::span<const Site> s, std::uint32_t u, std::uint32_t v) {
  if (!is_open_pair(s, u, v)) return std::nullopt;
  unsigned order = 0;
  if (const auto left = nearest_left(s, u, v)) order = std::max(order, triangle_order(s, u, v, *left));
  if (const auto right = nearest_left(s, v, u)) order = std::max(order, triangle_order(s, v, u, *right));
  return order;
}

/// A pair u < v with its useful order.
struct OrderedPair {
  std::uint32_t u, v;
  unsigned order;
  friend auto operator<=>(const OrderedPair&, const OrderedPair&) = default;
};

/// Every pair of useful order at most k, sorted.
inline std::vector<OrderedPair> useful_pairs(std::span<const Site> s, unsigned k) {
  std::vector<OrderedPair> result;
  for (std::uint32_t u = 0; u < s.size(); ++u) {
    for (std::uint32_t v = u + 1; v < s.size(); ++v) {
      const auto order = useful_order(s, u, v);
      if (order && *order <= k) result.push_back({u, v, *order});
    }
  }
  return result;
}

}  // namespace oracle
