/// What the targets of the methods share: a hostile terrain, and what every result has to be.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "fuzz_input.hpp"
#include "oracle/enumeration.hpp"
#include "support/brute.hpp"
#include "thalweg/minimize.hpp"

namespace fuzz {

using thalweg::Method;
using thalweg::Minimized;
using thalweg::Point2;
using thalweg::Point3;

/// The input of a target that removes pits: its first byte is the order and the counter.
struct Terrain {
  Terrain(Input& input, std::size_t most) {
    const std::uint8_t choice = input.byte();
    order = choice % 8;
    if (choice >= 128) counter = thalweg::Counter::voronoi;
    points = take_terrain(input, most);
    for (const Point3& p : points) places.push_back({p.x, p.y});
    const bool finite =
        all_finite(places) && std::ranges::all_of(points, [](const Point3& p) { return std::isfinite(p.z); });
    if (finite) rows = support::distinct_rows(places);
  }

  /// Whether there is a terrain over the points.
  bool legal() const { return !support::all_collinear(places, rows); }

  thalweg::MinimizeOptions options(Method method, unsigned k) const {
    thalweg::MinimizeOptions result;
    result.order = k;
    result.method = method;
    result.threads = 1;
    result.duplicates = thalweg::DuplicatePolicy::first;
    result.counter = counter;
    result.keep_trail = true;
    return result;
  }

  unsigned order = 0;
  thalweg::Counter counter = thalweg::Counter::crawl;
  std::vector<Point3> points;
  std::vector<Point2> places;
  support::Rows rows;
};

inline void print_elevations(const Terrain& terrain) {
  std::fputs("elevations = {", stderr);
  for (const Point3& p : terrain.points) std::fprintf(stderr, "%a, ", p.z);
  std::fputs("}\n", stderr);
}

inline void check(bool holds, const char* law, const Terrain& terrain) {
  if (!holds) print_elevations(terrain);
  check(holds, law, std::span<const Point2>(terrain.places));
}

/// The pits by definition, over rows that are vertices: `z` may differ from the rows where they are merged.
inline std::uint32_t pits_of(const Terrain& terrain, const thalweg::Triangulation& t) {
  std::vector<std::uint32_t> group(terrain.points.size());
  for (std::uint32_t v = 0; v < group.size(); ++v) group[v] = v;
  const auto root = [&](std::uint32_t v) {
    while (group[v] != v) v = group[v];
    return v;
  };
  std::vector<bool> drains(group.size(), false);
  for (const bool lower : {false, true}) {
    for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
      const std::uint32_t u = t.origin(thalweg::HalfedgeId(i)).index();
      const std::uint32_t v = t.dest(thalweg::HalfedgeId(i)).index();
      const double a = terrain.points[u].z, b = terrain.points[v].z;
      if (!lower && a == b) group[root(u)] = root(v);
      if (lower && a != b) drains[root(a > b ? u : v)] = true;
    }
  }
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < group.size(); ++v) {
    count += !t.isolated(thalweg::VertexId(v)) && root(v) == v && !drains[v] ? 1 : 0;
  }
  return count;
}

/// Faces turn left and are of order <= k, the border leaves no site out, and there are as many faces as that
/// takes: the convex hull is covered once.
inline void check_faces(const Minimized& m, const Terrain& terrain, unsigned k) {
  const thalweg::Triangulation& t = m.triangulation;
  const auto place = [&](thalweg::VertexId v) { return terrain.places[v.index()]; };
  check(!t.find_fault(), "links are sound", terrain);
  std::size_t border = 0;
  for (std::uint32_t f = 0; f < t.face_count(); ++f) {
    const auto [a, b, c] = t.corners(thalweg::FaceId(f));
    check(thalweg::orient2d(place(a), place(b), place(c)) > 0, "faces turn left", terrain);
    const unsigned order =
        support::sites_in_circle(terrain.places, terrain.rows, a.index(), b.index(), c.index());
    check(order == m.face_orders[f] && order <= k, "orders are right, at most k", terrain);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const thalweg::HalfedgeId h = thalweg::Triangulation::halfedge(thalweg::FaceId(f), i);
      if (!t.on_hull(h)) continue;
      ++border;
      for (const Point2 p : terrain.places) {
        check(thalweg::orient2d(place(t.origin(h)), place(t.dest(h)), p) >= 0, "no site is left out",
              terrain);
      }
    }
  }
  check(t.face_count() + 2 + border == 2 * terrain.rows.size(), "the hull is covered once", terrain);
}

inline void check_result(const Minimized& m, const Terrain& terrain, unsigned k) {
  check_faces(m, terrain, k);
  check(m.sites == terrain.rows.size(), "a vertex a site", terrain);
  check(m.pits.total == pits_of(terrain, m.triangulation), "pits are those of the definition", terrain);
  check(m.pits.total == m.pits.interior + m.pits.boundary, "pits are interior or boundary", terrain);
  check(m.pits.total <= m.delaunay_pits.total, "no more pits than before", terrain);
  check(m.lower_bound <= m.pits.total, "the bound is below the result", terrain);
  check(m.certified == (m.lower_bound == m.pits.total), "certified is bound == pits", terrain);
  check(m.remaining.size() == m.pits.total, "remaining pits are listed", terrain);
}

/// The result of the method at order k, looked at. Requires: terrain.legal().
inline Minimized run(const Terrain& terrain, Method method, unsigned k) {
  auto result = thalweg::minimize_pits(terrain.points, terrain.options(method, k));
  check(static_cast<bool>(result), "what Delaunay can do the methods can", terrain);
  check_result(*result, terrain, k);
  return std::move(*result);
}

/// Where an error is due there is one; otherwise the result of the method. Empty for an error.
inline std::optional<Minimized> run_if_legal(const Terrain& terrain, Method method) {
  if (terrain.legal()) return run(terrain, method, terrain.order);
  check(!thalweg::minimize_pits(terrain.points, terrain.options(method, terrain.order)),
        "an error where one is due", terrain);
  return std::nullopt;
}

/// The fewest pits by looking at every triangulation; nothing for more sites than `most`, or coordinates that
/// are too much for the oracle.
inline std::optional<unsigned> fewest_pits(const Terrain& terrain, std::size_t most) {
  if (terrain.rows.size() > most) return std::nullopt;
  std::vector<Point3> sites;
  std::vector<double> z;
  for (const std::uint32_t row : terrain.rows) {
    const Point3& p = terrain.points[row];
    if (p.x != std::floor(p.x) || p.y != std::floor(p.y) || std::abs(p.x) > 1e6 || std::abs(p.y) > 1e6)
      return std::nullopt;
    sites.push_back(p);
    z.push_back(p.z);
  }
  const oracle::Enumeration all(oracle::sites_of(std::span<const Point3>(sites)));
  return all.fewest_pits(oracle::Relief(z))[std::min(terrain.order, all.most_order())];
}

/// The fewest pits of up to `most` sites are not less than the bound of a result, and not more than its pits.
inline void check_against_fewest(const Minimized& m, const Terrain& terrain, std::size_t most) {
  const auto fewest = fewest_pits(terrain, most);
  check(!fewest || (m.lower_bound <= *fewest && *fewest <= m.pits.total),
        "the minimum is between bound and result", terrain);
}

}  // namespace fuzz
