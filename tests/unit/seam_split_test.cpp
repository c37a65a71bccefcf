/// Merges in pieces: edges across are certain, and the arrays are those of a merge in one piece.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kernel/divide_and_conquer.hpp"
#include "kernel/edges_across.hpp"
#include "kernel/part_builder.hpp"
#include "kernel/spatial_order.hpp"
#include "support/point_sets.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"

namespace {

using support::Kind;
using thalweg::Point2;
using thalweg::detail::EdgeAcross;
using thalweg::detail::GhostedTriangulation;

/// Distinct sites in spatial order, with their keys.
struct Ordered {
  std::vector<Point2> sites;
  std::vector<std::uint32_t> keys;

  explicit Ordered(const std::vector<Point2>& points) {
    const auto order = thalweg::detail::spatial_order(points, 1);
    for (std::uint32_t s = 0; s < order.site_count(); ++s) sites.push_back(points[order.first_row(s)]);
    keys.assign(order.keys.begin(), order.keys.end());
  }
};

/// All words that mean something.
std::vector<std::uint32_t> words(const GhostedTriangulation& mesh) {
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < mesh.origin.size(); ++i) {
    if (i % 4 == 3) continue;
    result.push_back(mesh.origin[i]);
    result.push_back(mesh.twin[i]);
  }
  return result;
}

void expect_same_arrays(const std::vector<Point2>& points, const std::string& what) {
  const Ordered ordered(points);
  if (ordered.sites.size() < 2) return;
  const auto whole = words(thalweg::detail::divide_and_conquer(ordered.sites, ordered.keys, {}));
  for (const unsigned threads : {2u, 8u}) {
    const auto shared = words(thalweg::detail::divide_and_conquer(
        ordered.sites, ordered.keys, {.threads = threads, .least_piece = 6, .least_edges = 1}));
    ASSERT_EQ(whole, shared) << what << ", " << threads << " threads";
  }
}

Point2 turned(Point2 p) {
  return {-p.y, p.x};
}

/// Points on convex curves, most of which have edges across whatever the cut is.
std::vector<Point2> curve(int shape, int count, support::Random& random) {
  std::vector<Point2> points;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * random.unit() - 1, whole = random.whole(-60, 60);
    const Point2 on[] = {
        {t, t * t},
        {t * t, t},
        {t, std::exp(4 * t)},
        {whole, whole * whole},                                   // cocircular by fours
        {random.below(2) == 0 ? -1.0 : 1.0, whole},               // two columns
        {whole, random.below(2) == 0 ? 0.0 : 50.0},               // two rows
        {std::cos(3.1 * t), 3 * std::sin(3.1 * t)},               // an ellipse
        {random.below(2) == 0 ? t * t + 1 : -1 - t * t, 2 * t},   // two arcs, back to back
        {random.below(2) == 0 ? 2 - t * t : -2 + t * t, 2 * t},   // two arcs, face to face
        {std::cos(t) * 5, std::sin(t) * 5 + random.whole(0, 1)},  // two arcs, one behind the other
        {t, t * t + 1e-3 * random.unit()},                        // a curve with a breadth
        {i % 3 == 0 ? 0.25 * t : t, i % 3 == 0 ? 0.6 : t * t},    // a parabola and a bar in it
    };
    points.push_back(on[shape]);
  }
  return points;
}
constexpr int kCurves = 12;

TEST(SeamSplit, SameArraysForPointsOnCurves) {
  for (int shape = 0; shape < kCurves; ++shape) {
    for (int seed = 0; seed < 12; ++seed) {
      support::Random random(static_cast<std::uint64_t>(100 * shape + seed));
      std::vector<Point2> points = curve(shape, 20 + 45 * seed, random);
      if (seed % 2 == 1) std::ranges::transform(points, points.begin(), turned);
      expect_same_arrays(points, "curve " + std::to_string(shape) + ", seed " + std::to_string(seed));
    }
  }
}

TEST(SeamSplit, SameArraysForAllKinds) {
  for (int kind = 0; kind < static_cast<int>(Kind::kinds); ++kind) {
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
      expect_same_arrays(support::point_set(static_cast<Kind>(kind), 5 + 31 * seed, seed),
                         "kind " + std::to_string(kind) + ", seed " + std::to_string(seed));
    }
  }
}

/// The edges across between the parts of the first cut, and whether they were certain: the triangulation has
/// them, and keeps them however its ties are broken.
std::vector<EdgeAcross> checked_edges(const std::vector<Point2>& points) {
  const Ordered ordered(points);
  const auto count = static_cast<std::uint32_t>(ordered.sites.size());
  if (count < 8 || ordered.keys.front() == ordered.keys.back()) return {};
  const auto cut = thalweg::detail::cut_of(ordered.keys);
  GhostedTriangulation mesh;
  mesh.origin.resize(8 * std::size_t{count});
  mesh.twin.resize(8 * std::size_t{count});
  const thalweg::detail::PartArrays arrays{ordered.sites.data(), mesh.origin.data(), mesh.twin.data()};
  build_part(arrays, 0, cut.low, ordered.keys.data());
  build_part(arrays, cut.low, count, &ordered.keys[cut.low]);
  const auto edges = edges_across(arrays, {0, cut.low, count});

  const auto mesh_of_all = thalweg::delaunay(ordered.sites);
  if (!mesh_of_all) return {};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::uint32_t p = edges[i].left, q = edges[i].right;
    EXPECT_LT(p, cut.low);
    EXPECT_GE(q, cut.low);
    bool found = false;
    mesh_of_all->for_each_neighbor(thalweg::VertexId(p),
                                   [&](thalweg::VertexId v) { found |= v.index() == q; });
    EXPECT_TRUE(found) << "edge " << p << ", " << q;
    // From the bottom up: the triangle of two edges one after the other turns left, unless they share a site.
    if (i + 1 == edges.size()) break;
    const std::uint32_t r = edges[i + 1].left, s = edges[i + 1].right;
    const auto& at = ordered.sites;
    EXPECT_TRUE(r == p || s == q || thalweg::orient2d(at[p], at[q], at[s]) > 0 ||
                thalweg::orient2d(at[p], at[q], at[r]) > 0);
    EXPECT_FALSE(r == p && s == q);
  }
  return edges;
}

TEST(EdgesAcross, AreEdgesOfTheTriangulationFromTheBottomUp) {
  std::size_t found = 0;
  for (int shape = 0; shape < kCurves; ++shape) {
    for (int seed = 0; seed < 20; ++seed) {
      support::Random random(static_cast<std::uint64_t>(1000 + 100 * shape + seed));
      found += checked_edges(curve(shape, 20 + 30 * seed, random)).size();
    }
  }
  for (int kind = 0; kind < static_cast<int>(Kind::kinds); ++kind) {
    for (std::uint32_t seed = 0; seed < 20; ++seed)
      found += checked_edges(support::point_set(static_cast<Kind>(kind), 10 + 29 * seed, seed)).size();
  }
  EXPECT_GT(found, 2000u);
}

TEST(EdgesAcross, AreManyWhereAllSitesHaveThemAndFewWhereTheMergeIsShort) {
  support::Random random(3);
  EXPECT_GE(checked_edges(curve(0, 5000, random)).size(), 24u);
  EXPECT_GE(checked_edges(curve(1, 5000, random)).size() + checked_edges(curve(2, 5000, random)).size(), 8u);
  EXPECT_LE(checked_edges(support::point_set(Kind::uniform, 5000, 1)).size(), 2u);
  std::vector<Point2> grid;
  for (int i = 0; i < 4900; ++i) grid.push_back({static_cast<double>(i % 70), static_cast<double>(i / 70)});
  EXPECT_LE(checked_edges(grid).size(), 2u);
}

}  // namespace
