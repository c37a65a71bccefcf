/// Merges in pieces: edges across are certain, and the arrays are those of a merge in one piece.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "kernel/edges_across.hpp"
#include "kernel/part_builder.hpp"
#include "support/ordered_sites.hpp"
#include "support/point_sets.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"

namespace {

using support::Kind;
using support::OrderedSites;
using thalweg::Point2;
using thalweg::detail::EdgeAcross;
using thalweg::detail::GhostedTriangulation;

void expect_same_arrays(const std::vector<Point2>& points, const std::string& what) {
  const OrderedSites ordered(points);
  if (ordered.sites.size() < 2) return;
  const auto whole = words_of(ordered, {});
  for (const unsigned threads : {2u, 8u})
    ASSERT_EQ(whole, words_of(ordered, support::shared_everywhere(threads)))
        << what << ", " << threads << " threads";
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
  const OrderedSites ordered(points);
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
    const auto& at = ordered.sites;
    const auto h = mesh_of_all->find_halfedge(thalweg::VertexId(p), thalweg::VertexId(q));
    const auto found = h.valid() ? h : mesh_of_all->find_halfedge(thalweg::VertexId(q), thalweg::VertexId(p));
    EXPECT_TRUE(found.valid()) << "edge " << p << ", " << q;
    if (found.valid() && mesh_of_all->twin(found).valid()) {
      const std::uint32_t u = mesh_of_all->apex(found).index();
      const std::uint32_t v = mesh_of_all->apex(mesh_of_all->twin(found)).index();
      EXPECT_NE(thalweg::incircle(at[p], at[q], at[u], at[v]), 0) << "edge " << p << ", " << q;
    }
    // From the bottom up: the triangle of two edges one after the other turns left, unless they share a site.
    if (i + 1 == edges.size()) break;
    const std::uint32_t r = edges[i + 1].left, s = edges[i + 1].right;
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
