/// Order-k Voronoi diagrams by definition: every circle through three sites, every site tested against it.
///
/// Ties by really lifting the sites: coordinates stretched by 2^200, the i-th largest of four sites in (x, y)
/// lifted by 2^(120 - 40 i). For coordinates below 2^15 a determinant that is not 0 outweighs every lift, and
/// a lift those of smaller sites.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "oracle/exact_predicates.hpp"
#include "oracle/plane.hpp"

namespace oracle {

/// Whether d is inside the circle through a, b, c (counter-clockwise) of the lifted sites.
inline bool in_lifted_circle(const Site& a, const Site& b, const Site& c, const Site& d) {
  if (const int inside = in_circle(a, b, c, d); inside != 0) return inside > 0;
  const std::array<Site, 4> points = {a, b, c, d};
  std::array<mpz_class, 4> x, y, lift;
  for (std::size_t i = 0; i < 4; ++i) {
    mp_bitcnt_t larger = 0;
    for (const Site& p : points) {
      if (std::max(std::abs(p.x), std::abs(p.y)) >= (1 << 15)) throw std::invalid_argument("too large");
      larger += p.x > points[i].x || (p.x == points[i].x && p.y > points[i].y);
    }
    x[i] = mpz_class(static_cast<long>(points[i].x - d.x)) << 200;
    y[i] = mpz_class(static_cast<long>(points[i].y - d.y)) << 200;
    lift[i] = x[i] * x[i] + y[i] * y[i] + (mpz_class(1) << (120 - 40 * larger));
  }
  for (std::size_t i = 0; i < 3; ++i) lift[i] -= lift[3];
  const mpz_class det = lift[0] * (x[1] * y[2] - x[2] * y[1]) + lift[1] * (x[2] * y[0] - x[0] * y[2]) +
                        lift[2] * (x[0] * y[1] - x[1] * y[0]);
  return sgn(det) > 0;
}

using SiteSet = std::vector<std::uint32_t>;

/// What meets where, named by sites: all sets ascending.
struct Voronoi {
  std::set<SiteSet> cells;
  std::set<SiteSet> vertices;                   ///< triples
  std::set<std::pair<SiteSet, SiteSet>> edges;  ///< cells that share an edge, the smaller first
};

inline SiteSet with(SiteSet set, std::initializer_list<std::uint32_t> more) {
  set.insert(set.end(), more);
  std::sort(set.begin(), set.end());
  return set;
}

/// The diagram of order k of sites not all on one line, k less than their number.
inline Voronoi voronoi(std::span<const Site> s, std::size_t k) {
  Voronoi result;
  const auto n = static_cast<std::uint32_t>(s.size());
  const auto meet = [&](const std::array<SiteSet, 3>& cells) {
    for (std::size_t i = 0; i < 3; ++i) {
      result.cells.insert(cells[i]);
      result.edges.insert(std::minmax(cells[i], cells[(i + 1) % 3]));
    }
  };
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      for (std::uint32_t c = a + 1; c < n; ++c) {
        if (c == b || turn(s[a], s[b], s[c]) <= 0) continue;
        SiteSet inside;
        for (std::uint32_t d = 0; d < n; ++d) {
          if (d != a && d != b && d != c && in_lifted_circle(s[a], s[b], s[c], s[d])) inside.push_back(d);
        }
        if (inside.size() + 1 == k) meet({with(inside, {a}), with(inside, {b}), with(inside, {c})});
        if (inside.size() + 2 == k) meet({with(inside, {a, b}), with(inside, {b, c}), with(inside, {c, a})});
        if (inside.size() + 1 == k || inside.size() + 2 == k) result.vertices.insert(with({}, {a, b, c}));
      }
    }
  }
  return result;
}

/// The k nearest points, nearest first, equal distances by (x, y). Any doubles.
inline std::vector<std::uint32_t> k_nearest(std::span<const thalweg::Point2> points, thalweg::Point2 q,
                                            std::size_t k) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), order.end(),
                    [&](std::uint32_t i, std::uint32_t j) {
                      const thalweg::Point2 a = points[i], b = points[j];
                      if (const int sign = oracle::compare_distance(q, a, b); sign != 0) return sign < 0;
                      return a.x < b.x || (a.x == b.x && a.y < b.y);
                    });
  order.resize(k);
  return order;
}

}  // namespace oracle
