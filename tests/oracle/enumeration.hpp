/// All triangulations of at most eleven sites, fast enough for tens of thousands of sets: a triangulation is
/// one word with a bit for each pair of sites. Shares no code with src/.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "oracle/plane.hpp"

namespace oracle {

/// A set of pairs of sites.
using EdgeSet = std::uint64_t;

inline constexpr unsigned kMostEnumerated = 11;  // 55 pairs
inline constexpr unsigned kNoOrder = std::numeric_limits<unsigned>::max();

/// The set that holds the pair u, v alone. Requires: u != v, both below kMostEnumerated.
inline EdgeSet edge(std::uint32_t u, std::uint32_t v) {
  if (u > v) std::swap(u, v);
  return EdgeSet{1} << (v * (v - 1) / 2 + u);
}

/// Elevations prepared for counting the pits of many edge sets.
class Relief {
 public:
  explicit Relief(std::span<const double> z) : size_(z.size()) {
    for (std::uint32_t v = 0; v < size_; ++v) {
      for (std::uint32_t u = 0; u < size_; ++u) {
        if (z[u] < z[v]) down_[v] |= edge(u, v);
        if (u < v && z[u] == z[v]) level_.emplace_back(u, v);
      }
    }
  }

  /// Components of equal elevation without an edge to lower ground.
  unsigned pits(EdgeSet edges) const {
    std::array<std::uint8_t, kMostEnumerated> group{};
    for (std::size_t v = 0; v < size_; ++v) group[v] = static_cast<std::uint8_t>(v);
    for (const auto& [u, v] : level_) {
      if ((edges & edge(u, v)) == 0 || group[u] == group[v]) continue;
      const std::uint8_t from = group[u], to = group[v];
      for (std::size_t w = 0; w < size_; ++w) group[w] = group[w] == from ? to : group[w];
    }
    unsigned groups = 0, drained = 0;
    for (std::size_t v = 0; v < size_; ++v) {
      groups |= 1u << group[v];
      if ((edges & down_[v]) != 0) drained |= 1u << group[v];
    }
    return static_cast<unsigned>(std::popcount(groups & ~drained));
  }

 private:
  std::size_t size_;
  std::array<EdgeSet, kMostEnumerated> down_{};
  std::vector<std::pair<std::uint32_t, std::uint32_t>> level_;
};

/// Every triangulation of some sites, whatever their elevations.
class Enumeration {
 public:
  struct Entry {
    EdgeSet edges;
    unsigned order;  ///< the largest of its triangles
  };

  /// Requires: distinct sites, not all collinear, at most kMostEnumerated.
  explicit Enumeration(std::span<const Site> s) : sites_(s.begin(), s.end()) {
    if (s.size() > kMostEnumerated || all_collinear(s)) throw std::invalid_argument("cannot enumerate");
    find_triangles();
    find_flips();
    walk(any());
  }

  std::span<const Entry> all() const { return all_; }
  std::size_t size() const { return sites_.size(); }
  /// The largest order that any triangulation of so many sites can have.
  unsigned most_order() const { return static_cast<unsigned>(std::max<std::size_t>(size(), 3) - 3); }

  /// The triangulation with exactly these edges, if it is one.
  const Entry* find(EdgeSet edges) const {
    const auto it = place_.find(edges);
    return it == place_.end() ? nullptr : &all_[it->second];
  }

  /// Whether abc turns left and holds no other site, not even on its sides: what faces are.
  bool is_face(const Tri& t) const {
    const EdgeSet sides = sides_of(t);
    return turn(sites_[t[0]], sites_[t[1]], sites_[t[2]]) > 0 &&
           std::any_of(triangles_.begin(), triangles_.end(),
                       [&](const Entry& triangle) { return triangle.edges == sides; });
  }

  static EdgeSet sides_of(const Tri& t) { return edge(t[0], t[1]) | edge(t[1], t[2]) | edge(t[2], t[0]); }

  /// The least order of a triangulation that has all these edges; kNoOrder if there is none.
  unsigned least_order(EdgeSet edges) const {
    unsigned least = kNoOrder;
    for (const Entry& t : all_) {
      if ((t.edges & edges) == edges) least = std::min(least, t.order);
    }
    return least;
  }

  /// All pairs that some triangulation of order at most k has.
  EdgeSet useful(unsigned k) const {
    EdgeSet result = 0;
    for (const Entry& t : all_) result |= t.order <= k ? t.edges : 0;
    return result;
  }

  /// Whether the open segments of two pairs cross.
  bool crossing(Pair p, Pair q) const {
    return cross(sites_[p.first], sites_[p.second], sites_[q.first], sites_[q.second]);
  }

  /// Entry k: the fewest pits of any triangulation of order at most k, for k = 0 .. most_order().
  std::vector<unsigned> fewest_pits(const Relief& relief) const {
    std::vector<unsigned> fewest(most_order() + std::size_t{1}, static_cast<unsigned>(size()));
    for (const Entry& t : all_) fewest[t.order] = std::min(fewest[t.order], relief.pits(t.edges));
    for (std::size_t k = 1; k < fewest.size(); ++k) fewest[k] = std::min(fewest[k], fewest[k - 1]);
    return fewest;
  }

 private:
  struct Flip {
    EdgeSet quad, one, other;  // four sides, and the two diagonals
  };

  const Site& at(std::uint32_t v) const { return sites_[v]; }

  bool is_empty_triangle(const Tri& t) const {
    for (std::uint32_t p = 0; p < size(); ++p) {
      if (p == t[0] || p == t[1] || p == t[2]) continue;
      const int a = turn(at(t[0]), at(t[1]), at(p)), b = turn(at(t[1]), at(t[2]), at(p)),
                c = turn(at(t[2]), at(t[0]), at(p));
      if ((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0)) return false;
    }
    return true;
  }

  /// The triangles that hold no other site, those of the largest order first.
  void find_triangles() {
    for (std::uint32_t c = 2; c < size(); ++c) {
      for (std::uint32_t b = 1; b < c; ++b) {
        for (std::uint32_t a = 0; a < b; ++a) {
          if (turn(at(a), at(b), at(c)) == 0 || !is_empty_triangle({a, b, c})) continue;
          unsigned order = 0;
          for (const Site& p : sites_) order += in_circle(at(a), at(b), at(c), p) > 0 ? 1u : 0u;
          triangles_.push_back({sides_of({a, b, c}), order});
        }
      }
    }
    std::sort(triangles_.begin(), triangles_.end(),
              [](const Entry& s, const Entry& t) { return s.order > t.order; });
  }

  bool is_empty_triangle(EdgeSet sides) const {
    return std::any_of(triangles_.begin(), triangles_.end(),
                       [&](const Entry& t) { return t.edges == sides; });
  }

  /// The strictly convex quadrilaterals whose halves are empty, whichever diagonal cuts them.
  void find_flips() {
    for (std::uint32_t b = 1; b < size(); ++b) {
      for (std::uint32_t a = 0; a < b; ++a) {
        for (std::uint32_t d = 1; d < b; ++d) {
          for (std::uint32_t c = 0; c < d; ++c) {
            if (!cross(at(a), at(b), at(c), at(d))) continue;
            if (!is_empty_triangle(sides_of({a, b, c})) || !is_empty_triangle(sides_of({a, b, d}))) continue;
            flips_.push_back({edge(a, c) | edge(c, b) | edge(b, d) | edge(d, a), edge(a, b), edge(c, d)});
          }
        }
      }
    }
  }

  /// Maximal sets of non-crossing open pairs are triangulations.
  EdgeSet any() const {
    std::vector<Pair> pairs;
    EdgeSet result = 0;
    for (std::uint32_t v = 1; v < size(); ++v) {
      for (std::uint32_t u = 0; u < v; ++u) {
        const bool clear = std::none_of(pairs.begin(), pairs.end(), [&](const Pair& other) {
          return crossing({u, v}, other);
        });
        if (!clear || !is_open_pair(sites_, u, v)) continue;
        pairs.emplace_back(u, v);
        result |= edge(u, v);
      }
    }
    return result;
  }

  /// The empty triangles whose sides a triangulation has are its faces.
  unsigned order_of(EdgeSet edges) const {
    for (const Entry& t : triangles_) {
      if ((edges & t.edges) == t.edges) return t.order;
    }
    return 0;
  }

  /// The flip graph is connected, degenerate sites or not: Lawson's flips lead from any triangulation to a
  /// Delaunay triangulation, and those differ by flips in cocircular, hence convex, polygons.
  void walk(EdgeSet start) {
    const auto add = [&](EdgeSet edges) {
      if (place_.try_emplace(edges, static_cast<std::uint32_t>(all_.size())).second) {
        all_.push_back({edges, order_of(edges)});
      }
    };
    add(start);
    for (std::size_t head = 0; head < all_.size(); ++head) {
      const EdgeSet edges = all_[head].edges;
      for (const Flip& flip : flips_) {
        const EdgeSet found = edges & (flip.quad | flip.one | flip.other);
        if (found == (flip.quad | flip.one) || found == (flip.quad | flip.other)) {
          add(edges ^ flip.one ^ flip.other);
        }
      }
    }
  }

  std::vector<Site> sites_;
  std::vector<Entry> triangles_;
  std::vector<Flip> flips_;
  std::vector<Entry> all_;
  std::unordered_map<EdgeSet, std::uint32_t> place_;
};

}  // namespace oracle
