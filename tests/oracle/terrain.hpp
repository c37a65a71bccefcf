/// Pits and the reach bound by definition, and the optimum by looking at every triangulation.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "oracle/order.hpp"

namespace oracle {

struct Pit {
  std::vector<std::uint32_t> vertices;  ///< ascending
  bool boundary = false;
  friend auto operator<=>(const Pit&, const Pit&) = default;
};

/// The pits of a graph on sites 0 .. n-1: components of equal z without an edge to lower ground, by their
/// first vertex. `on_hull` may be empty.
inline std::vector<Pit> pits_of_graph(std::span<const double> z, std::span<const Pair> edges,
                                      std::span<const bool> on_hull = {}) {
  const std::size_t n = z.size();
  std::vector<std::vector<std::uint32_t>> neighbors(n);
  for (const auto& [u, v] : edges) {
    neighbors[u].push_back(v);
    neighbors[v].push_back(u);
  }
  std::vector<bool> seen(n, false);
  std::vector<Pit> result;
  for (std::uint32_t start = 0; start < n; ++start) {
    if (seen[start]) continue;
    Pit pit;
    bool drains = false;
    std::vector<std::uint32_t> stack = {start};
    seen[start] = true;
    while (!stack.empty()) {
      const std::uint32_t u = stack.back();
      stack.pop_back();
      pit.vertices.push_back(u);
      if (!on_hull.empty() && on_hull[u]) pit.boundary = true;
      for (const std::uint32_t v : neighbors[u]) {
        if (z[v] < z[u]) drains = true;
        if (z[v] == z[u] && !seen[v]) {
          seen[v] = true;
          stack.push_back(v);
        }
      }
    }
    std::sort(pit.vertices.begin(), pit.vertices.end());
    if (!drains) result.push_back(pit);
  }
  std::sort(result.begin(), result.end());
  return result;
}

inline std::vector<Pair> edges_of(std::span<const Tri> triangles) {
  std::set<Pair> edges;
  for (const Tri& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
  }
  return {edges.begin(), edges.end()};
}

inline std::vector<double> elevations(std::span<const Site> s) {
  std::vector<double> z;
  for (const Site& p : s) z.push_back(p.z);
  return z;
}

/// The pits of a terrain over all the sites.
inline std::vector<Pit> pits(std::span<const Site> s, std::span<const Tri> triangles) {
  const auto hull = std::make_unique<bool[]>(s.size());
  for (const auto& [u, v] : hull_edges(s)) hull[u] = hull[v] = true;
  return pits_of_graph(elevations(s), edges_of(triangles), std::span<const bool>(hull.get(), s.size()));
}

/// The reach bound: pits of the graph of all pairs of useful order at most k.
inline std::size_t reach_bound(std::span<const Site> s, unsigned k) {
  std::vector<Pair> edges;
  for (const OrderedPair& pair : useful_pairs(s, k)) edges.emplace_back(pair.u, pair.v);
  return pits_of_graph(elevations(s), edges).size();
}

/// A triangle with its smallest vertex first; sorted lists of these compare triangulations.
inline Tri rotated(Tri t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

inline std::vector<Tri> normal_form(std::span<const Tri> triangles) {
  std::vector<Tri> result;
  for (const Tri& t : triangles) result.push_back(rotated(t));
  std::sort(result.begin(), result.end());
  return result;
}

/// Some triangulation of the sites: maximal sets of non-crossing open pairs are triangulations, so pairs are
/// taken greedily; the triangles are then the empty three-cycles. Requires: distinct, not all collinear.
inline std::vector<Tri> any_triangulation(std::span<const Site> s) {
  const auto n = static_cast<std::uint32_t>(s.size());
  std::vector<Pair> edges;
  std::set<Pair> joined;
  for (std::uint32_t u = 0; u < n; ++u) {
    for (std::uint32_t v = u + 1; v < n; ++v) {
      const bool clear = std::none_of(edges.begin(), edges.end(), [&](const Pair& e) {
        return cross(s[u], s[v], s[e.first], s[e.second]);
      });
      if (!clear || !is_open_pair(s, u, v)) continue;
      edges.emplace_back(u, v);
      joined.emplace(u, v);
    }
  }
  std::vector<Tri> result;
  for (const auto& [u, v] : edges) {
    for (std::uint32_t w = v + 1; w < n; ++w) {
      if (!joined.count({u, w}) || !joined.count({v, w}) || turn(s[u], s[v], s[w]) == 0) continue;
      const Tri t = turn(s[u], s[v], s[w]) > 0 ? Tri{u, v, w} : Tri{u, w, v};
      const bool empty = std::none_of(s.begin(), s.end(), [&](const Site& p) {
        return turn(s[t[0]], s[t[1]], p) > 0 && turn(s[t[1]], s[t[2]], p) > 0 &&
               turn(s[t[2]], s[t[0]], p) > 0;
      });
      if (empty) result.push_back(t);
    }
  }
  return normal_form(result);
}

/// Every triangulation of the sites, by walking the flip graph, which is connected (Lawson 1972). For about
/// ten sites at most.
inline std::set<std::vector<Tri>> all_triangulations(std::span<const Site> s) {
  std::set<std::vector<Tri>> seen = {any_triangulation(s)};
  std::vector<std::vector<Tri>> stack = {*seen.begin()};
  while (!stack.empty()) {
    const std::vector<Tri> current = std::move(stack.back());
    stack.pop_back();
    std::map<Pair, std::uint32_t> apex;  // directed edge -> triangle
    for (std::uint32_t i = 0; i < current.size(); ++i) {
      for (std::size_t j = 0; j < 3; ++j) apex[{current[i][j], current[i][(j + 1) % 3]}] = i;
    }
    for (const auto& [edge, face] : apex) {
      const auto other = apex.find({edge.second, edge.first});
      if (edge.first > edge.second || other == apex.end()) continue;
      const auto [a, b] = edge;
      const auto across = [a = a, b = b](const Tri& t) {
        return *std::find_if(t.begin(), t.end(), [=](auto v) { return v != a && v != b; });
      };
      const std::uint32_t c = across(current[face]), d = across(current[other->second]);
      if (!cross(s[edge.first], s[edge.second], s[c], s[d])) continue;
      std::vector<Tri> next = current;
      next[face] = {d, c, edge.first};
      next[other->second] = {c, d, edge.second};
      next = normal_form(next);
      if (seen.insert(next).second) stack.push_back(std::move(next));
    }
  }
  return seen;
}

/// Entry k: the fewest pits of any triangulation of order at most k, for k = 0 .. max(n - 3, 0).
inline std::vector<std::size_t> fewest_pits(std::span<const Site> s) {
  std::vector<std::size_t> best(std::max<std::size_t>(s.size(), 3) - 2, s.size());
  for (const std::vector<Tri>& triangles : all_triangulations(s)) {
    unsigned order = 0;
    for (const Tri& t : triangles) order = std::max(order, triangle_order(s, t));
    const std::size_t count = pits_of_graph(elevations(s), edges_of(triangles)).size();
    for (std::size_t k = order; k < best.size(); ++k) best[k] = std::min(best[k], count);
  }
  return best;
}

}  // namespace oracle
