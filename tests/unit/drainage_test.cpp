/// Flow paths and spill levels: small terrains by hand, many by definition.
#include "thalweg/drainage.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "oracle/exact_predicates.hpp"
#include "support/cloud.hpp"
#include "support/ids.hpp"
#include "support/surface.hpp"
#include "thalweg/delaunay.hpp"

namespace {

using namespace thalweg;
using support::Cloud;
using support::vertex;

Triangulation delaunay_of(const Cloud& cloud) {
  return delaunay(cloud.places()).value();
}

/// The sign of fall_a^2 dist_b^2 - fall_b^2 dist_a^2 in GMP's integers.
int steepness_by_gmp(Point3 from, Point3 a, Point3 b) {
  const int unit = oracle::common_exponent({{from.x, from.y}, {a.x, a.y}, {b.x, b.y}});
  const int z_unit =
      std::min({oracle::unit_exponent(from.z), oracle::unit_exponent(a.z), oracle::unit_exponent(b.z)});
  const auto fall = [&](Point3 to) {
    const mpz_class f = oracle::in_units(from.z, z_unit) - oracle::in_units(to.z, z_unit);
    return mpz_class(f * f);
  };
  const auto distance = [&](Point3 to) {
    return oracle::squared(oracle::exact_vector({from.x, from.y}, {to.x, to.y}, unit));
  };
  return sgn(mpz_class(fall(a) * distance(b) - fall(b) * distance(a)));
}

TEST(CompareSteepness, IsExactBeyondTheReachOfDoubles) {
  const Point3 from{0, 0, 1};
  EXPECT_EQ(compare_steepness(from, {1, 0, 0}, {2, 0, 0}), 1);
  EXPECT_EQ(compare_steepness(from, {1, 0, 0}, {2, 0, -1}), 0);
  EXPECT_EQ(compare_steepness(from, {3, 4, -4}, {5, 0, -4}), 0);
  EXPECT_EQ(compare_steepness(from, {3, 4, -4}, {std::nextafter(5.0, 6.0), 0, -4}), 1);
  EXPECT_EQ(compare_steepness(from, {3, 4, std::nextafter(-4.0, 0.0)}, {5, 0, -4}), -1);
  EXPECT_EQ(compare_steepness({0, 0, 1e308}, {1, 0, -1e308}, {2, 0, -1e308}), 1);
  EXPECT_EQ(compare_steepness({-1e308, 0, 1}, {1e308, 0, 0}, {1e308, 1e308, 0}), 1);
  EXPECT_EQ(compare_steepness({0, 0, 5e-324}, {1, 0, 0}, {1, 5e-324, 0}), 1);
  EXPECT_EQ(compare_steepness(from, {1, 0, 1}, {0, 1, 1}), 0);  // level ways are equally steep
  // As far away, but x * x + y * y is rounded otherwise.
  EXPECT_EQ(compare_steepness(from, {8362900, 392702530, 0}, {377454220, -108690050, 0}), 0);
}

RC_GTEST_PROP(CompareSteepness, AgreesWithGmp, ()) {
  const auto draw = [] {
    const int kind = *rc::gen::inRange(0, 4);
    const double whole = *rc::gen::inRange(-6, 7);
    if (kind == 0) return std::ldexp(whole, *rc::gen::inRange(-1000, 1000));
    if (kind == 1) return std::nextafter(whole, *rc::gen::element(-1e9, 1e9));
    return whole;
  };
  const auto point = [&] { return Point3{draw(), draw(), draw()}; };
  const Point3 from = point();
  Point3 a = point(), b = point();
  if (a.z > from.z) a.z = from.z;
  if (b.z > from.z) b.z = from.z;
  RC_PRE(a.x != from.x || a.y != from.y);
  RC_PRE(b.x != from.x || b.y != from.y);
  RC_ASSERT(compare_steepness(from, a, b) == steepness_by_gmp(from, a, b));
  RC_ASSERT(compare_steepness(from, b, a) == -steepness_by_gmp(from, a, b));
}

/// The flow of one vertex by the words of the header; `steps` are edges to the way out of its flat.
VertexId downstream_by_definition(const Cloud& cloud, const Triangulation& t,
                                  const std::vector<std::uint32_t>& steps, VertexId v) {
  const auto at = [&](VertexId w) { return cloud.points[w.index()]; };
  const auto lower = [&](VertexId u, VertexId w) {
    return std::tuple(at(u).z, at(u).x, at(u).y) < std::tuple(at(w).z, at(w).x, at(w).y);
  };
  std::vector<VertexId> down, level;
  t.for_each_neighbor(v, [&](VertexId w) {
    if (at(w).z < at(v).z) down.push_back(w);
    if (at(w).z == at(v).z && steps[w.index()] + 1 == steps[v.index()]) level.push_back(w);
  });
  if (!down.empty()) {
    return *std::min_element(down.begin(), down.end(), [&](VertexId a, VertexId b) {
      const int side = steepness_by_gmp(at(v), at(a), at(b));
      return side != 0 ? side > 0 : lower(a, b);
    });
  }
  return level.empty() ? VertexId() : *std::min_element(level.begin(), level.end(), lower);
}

/// Edges to the nearest vertex with lower ground, or in pits to the first; by relaxation until nothing
/// changes.
std::vector<std::uint32_t> steps_by_relaxation(const Cloud& cloud, const Triangulation& t) {
  constexpr std::uint32_t kFar = 1'000'000;
  std::vector<std::uint32_t> steps(cloud.size(), kFar);
  for (std::uint32_t v = 0; v < cloud.size(); ++v) {
    t.for_each_neighbor(vertex(v), [&](VertexId w) {
      if (cloud.points[w.index()].z < cloud.points[v].z) steps[v] = 0;
    });
  }
  const Pits pits = find_pits(t, cloud.elevations());
  for (std::uint32_t i = 0; i < pits.size(); ++i) {
    const VertexId first = *std::min_element(pits[i].begin(), pits[i].end(), [&](VertexId a, VertexId b) {
      const Point3 &p = cloud.points[a.index()], &q = cloud.points[b.index()];
      return std::pair(p.x, p.y) < std::pair(q.x, q.y);
    });
    steps[first.index()] = 0;
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t v = 0; v < cloud.size(); ++v) {
      t.for_each_neighbor(vertex(v), [&](VertexId w) {
        if (cloud.points[w.index()].z != cloud.points[v].z || steps[w.index()] + 1 >= steps[v]) return;
        steps[v] = steps[w.index()] + 1;
        changed = true;
      });
    }
  }
  return steps;
}

RC_GTEST_PROP(Drainage, FollowsItsDefinition, ()) {
  const Cloud cloud = *support::clouds(40);
  const Triangulation t = delaunay_of(cloud);
  const Drainage drainage = drain(t, cloud.points);
  const std::vector<std::uint32_t> steps = steps_by_relaxation(cloud, t);
  double longest = 0;
  for (std::uint32_t v = 0; v < cloud.size(); ++v) {
    RC_ASSERT(drainage.downstream[v] == downstream_by_definition(cloud, t, steps, vertex(v)));
    double length = 0;
    std::uint32_t end = v, edges = 0;
    for (; drainage.downstream[end].valid(); ++edges) {
      RC_ASSERT(edges < cloud.size());
      const Point3 &p = cloud.points[end], &q = cloud.points[drainage.downstream[end].index()];
      RC_ASSERT(q.z <= p.z);
      length += std::hypot(p.x - q.x, p.y - q.y);
      end = drainage.downstream[end].index();
    }
    RC_ASSERT(drainage.sink[v] == vertex(end));
    longest = std::max(longest, length);
    if (vertex(v) == drainage.longest_from) RC_ASSERT(drainage.longest_edges == edges);
  }
  RC_ASSERT(std::fabs(drainage.longest_length - longest) <= 1e-9 * longest);
  RC_ASSERT(drainage.basins == find_pits(t, cloud.elevations()).size());
}

RC_GTEST_PROP(Drainage, DoesNotDependOnTheNumbersOfVertices, ()) {
  const Cloud cloud = *support::clouds(40);
  const auto order = support::permutation(cloud.size(), *rc::gen::arbitrary<std::uint64_t>());
  const Cloud moved = support::permuted(cloud, order);
  const Drainage here = drain(delaunay_of(cloud), cloud.points);
  const Drainage there = drain(delaunay_of(moved), moved.points);
  for (std::uint32_t v = 0; v < cloud.size(); ++v) {
    const VertexId next = here.downstream[v], image = there.downstream[order[v]];
    RC_ASSERT(next.valid() == image.valid());
    if (next.valid()) RC_ASSERT(image == vertex(order[next.index()]));
  }
  RC_ASSERT(there.longest_from == vertex(order[here.longest_from.index()]));
}

/// The least level up to which v is joined to a vertex that comes before it, by trying all levels.
double spill_by_definition(const Cloud& cloud, const Triangulation& t, VertexId first) {
  const auto key = [&](std::uint32_t v) {
    return std::tuple(cloud.points[v].z, cloud.points[v].x, cloud.points[v].y);
  };
  const std::vector<double> z = cloud.elevations();
  for (const double level : std::set<double>(z.begin(), z.end())) {
    if (level < z[first.index()]) continue;
    std::set<std::uint32_t> seen = {first.index()};
    std::vector<std::uint32_t> stack = {first.index()};
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      if (key(v) < key(first.index())) return level;
      t.for_each_neighbor(vertex(v), [&](VertexId w) {
        if (z[w.index()] <= level && seen.insert(w.index()).second) stack.push_back(w.index());
      });
    }
  }
  return std::numeric_limits<double>::infinity();
}

RC_GTEST_PROP(SpillLevels, FollowTheirDefinition, ()) {
  const Cloud cloud = *support::clouds(30);
  const Triangulation t = delaunay_of(cloud);
  const Pits pits = find_pits(t, cloud.elevations());
  const std::vector<double> levels = spill_levels(t, cloud.points, pits);
  const Drainage drainage = drain(t, cloud.points);
  RC_ASSERT(levels.size() == pits.size());
  for (std::uint32_t i = 0; i < pits.size(); ++i) {
    RC_ASSERT(levels[i] == spill_by_definition(cloud, t, drainage.sink[pits[i][0].index()]));
  }
}

TEST(Drainage, OpensTheDammedValley) {
  const auto points = support::dammed_valley();
  const Triangulation before = delaunay(Cloud{points}.places()).value();
  const Drainage dammed = drain(before, points);
  EXPECT_EQ(dammed.sink[0], vertex(0));
  EXPECT_EQ(dammed.downstream[2], vertex(1));  // from the dam to the lower side: both are equally near
  EXPECT_EQ(dammed.basins, 2u);
  Triangulation after = before;
  after.flip(before.find_halfedge(vertex(2), vertex(3)));
  const Drainage open = drain(after, points);
  EXPECT_EQ(open.downstream[0], vertex(1));
  EXPECT_EQ(open.basins, 1u);
}

TEST(Drainage, OfLevelGroundEndsInItsFirstVertex) {
  const Cloud cloud = support::make_cloud({{0, 0, 7}, {2, 0, 7}, {0, 2, 7}, {2, 2, 7}, {1, 1, 7}});
  const Drainage drainage = drain(delaunay_of(cloud), cloud.points);
  EXPECT_EQ(drainage.basins, 1u);
  for (std::uint32_t v = 0; v < 5; ++v) EXPECT_EQ(drainage.sink[v], vertex(0));
}

TEST(Drainage, OfNothingIsNothing) {
  const Drainage drainage = drain(Triangulation(), {});
  EXPECT_EQ(drainage.basins, 0u);
  EXPECT_FALSE(drainage.longest_from.valid());
}

TEST(Drainage, LengthsReachTheEndOfDoubles) {
  const Cloud cloud{{{-1.7e308, 0, 3}, {1.7e308, 0, 2}, {0, 1e308, 1}, {0, -1e308, 0}}};
  const Drainage drainage = drain(delaunay_of(cloud), cloud.points);
  EXPECT_EQ(drainage.basins, 1u);
  EXPECT_GT(drainage.longest_length, 1e308);
}

}  // namespace
