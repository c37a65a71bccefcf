/// Every method of removing pits over hostile terrains: triangulations of the right order and count, the laws
/// between the methods, and for few sites on the grid the true minimum. The first byte is the order.
#include <array>
#include <optional>
#include <vector>

#include "fuzz_input.hpp"
#include "oracle/enumeration.hpp"
#include "support/brute.hpp"
#include "thalweg/minimize.hpp"

namespace {

using support::Rows;
using thalweg::FaceId;
using thalweg::Method;
using thalweg::Minimized;
using thalweg::Point2;
using thalweg::Point3;
using thalweg::VertexId;

struct Terrain {
  std::vector<Point3> points;
  std::vector<Point2> places;
  Rows rows;
};

void print_elevations(const Terrain& terrain) {
  std::fputs("elevations = {", stderr);
  for (const Point3& p : terrain.points) std::fprintf(stderr, "%a, ", p.z);
  std::fputs("}\n", stderr);
}

void check(bool holds, const char* law, const Terrain& terrain) {
  if (!holds) print_elevations(terrain);
  fuzz::check(holds, law, terrain.places);
}

/// The pits by definition, over rows that are vertices: `z` may differ from the rows where they are merged.
std::uint32_t pits_of(const Terrain& terrain, const thalweg::Triangulation& t) {
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
    count += !t.isolated(VertexId(v)) && root(v) == v && !drains[v] ? 1 : 0;
  }
  return count;
}

void check_result(const Minimized& m, const Terrain& terrain, unsigned k) {
  check(!m.triangulation.find_fault(), "links are sound", terrain);
  check(m.sites == terrain.rows.size(), "a vertex a site", terrain);
  for (std::uint32_t f = 0; f < m.triangulation.face_count(); ++f) {
    const auto [a, b, c] = m.triangulation.corners(FaceId(f));
    check(thalweg::orient2d(terrain.places[a.index()], terrain.places[b.index()], terrain.places[c.index()]) >
              0,
          "faces turn left", terrain);
    const unsigned order =
        support::sites_in_circle(terrain.places, terrain.rows, a.index(), b.index(), c.index());
    check(order == m.face_orders[f] && order <= k, "orders are right, at most k", terrain);
  }
  check(m.pits.total == pits_of(terrain, m.triangulation), "pits are those of the definition", terrain);
  check(m.pits.total == m.pits.interior + m.pits.boundary, "pits are interior or boundary", terrain);
  check(m.pits.total <= m.delaunay_pits.total, "no more pits than before", terrain);
  check(m.lower_bound <= m.pits.total, "the bound is below the result", terrain);
  check(m.certified == (m.lower_bound == m.pits.total), "certified is bound == pits", terrain);
  check(m.remaining.size() == m.pits.total, "remaining pits are listed", terrain);
}

Minimized run(const Terrain& terrain, Method method, unsigned k, thalweg::Counter counter) {
  thalweg::MinimizeOptions options;
  options.order = k;
  options.method = method;
  options.threads = 1;
  options.duplicates = thalweg::DuplicatePolicy::first;
  options.counter = counter;
  auto result = thalweg::minimize_pits(terrain.points, options);
  check(static_cast<bool>(result), "what Delaunay can do the methods can", terrain);
  check_result(*result, terrain, k);
  return std::move(*result);
}

/// The fewest pits by looking at every triangulation; nothing if there are too many or the oracle cannot.
std::optional<unsigned> fewest(const Terrain& terrain, unsigned k) {
  constexpr std::size_t kMost = 8;
  if (terrain.rows.size() > kMost) return std::nullopt;
  std::vector<Point3> sites;
  for (const std::uint32_t row : terrain.rows) {
    const Point3& p = terrain.points[row];
    if (p.x != std::floor(p.x) || p.y != std::floor(p.y) || std::abs(p.x) > 1e6 || std::abs(p.y) > 1e6)
      return std::nullopt;
    sites.push_back(p);
  }
  const auto s = oracle::sites_of(std::span<const Point3>(sites));
  std::vector<double> z;
  for (const oracle::Site& site : s) z.push_back(site.z);
  const oracle::Enumeration all(s);
  return all.fewest_pits(oracle::Relief(z))[std::min(k, all.most_order())];
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::uint8_t choice = input.byte();
  const unsigned k = choice % 8;
  const auto counter = choice >= 128 ? thalweg::Counter::voronoi : thalweg::Counter::crawl;
  Terrain terrain{fuzz::take_terrain(input, 13), {}, {}};
  for (const Point3& p : terrain.points) terrain.places.push_back({p.x, p.y});
  const auto delaunay =
      thalweg::minimize_pits(terrain.points, {.order = k, .method = Method::delaunay, .threads = 1});
  const bool finite =
      fuzz::all_finite(terrain.places) && std::all_of(terrain.points.begin(), terrain.points.end(),
                                                      [](const Point3& p) { return std::isfinite(p.z); });
  terrain.rows = finite ? support::distinct_rows(terrain.places) : Rows();
  check(static_cast<bool>(delaunay) == (finite && !support::all_collinear(terrain.places, terrain.rows)),
        "an error where one is due, only there", terrain);
  if (!delaunay) return 0;
  const Minimized flip = run(terrain, Method::flip, k, counter),
                  hull = run(terrain, Method::hull, k, counter);
  const Minimized best = run(terrain, Method::best, k, counter),
                  exact = run(terrain, Method::exact, k, counter);
  check(best.pits.total <= std::min(flip.pits.total, hull.pits.total), "best is best", terrain);
  check(exact.pits.total <= best.pits.total && exact.certified, "exact ends with a proof", terrain);
  for (const Minimized* m : {&flip, &hull, &best}) {
    check(m->lower_bound <= exact.pits.total, "bounds are below the minimum", terrain);
  }
  if (const auto true_minimum = fewest(terrain, k)) {
    check(exact.pits.total == *true_minimum, "exact is the fewest of all triangulations", terrain);
  }
  return 0;
}
