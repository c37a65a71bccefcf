/// Flats and disjoint sets: local questions about pits, answered as by a full count.
#include "terrain/flats.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/cloud.hpp"
#include "support/random_mesh.hpp"
#include "support/surface.hpp"
#include "terrain/disjoint_sets.hpp"

namespace {

using support::vertex;
using thalweg::Pits;
using thalweg::Point3;
using thalweg::VertexId;
using thalweg::detail::DisjointSets;
using thalweg::detail::FlatSearch;
using thalweg::detail::Surface;

TEST(DisjointSets, BeginApart) {
  DisjointSets sets(5);
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, JoinSaysWhetherTheyWereTwo) {
  DisjointSets sets(4);
  EXPECT_TRUE(sets.join(1, 2));
  EXPECT_FALSE(sets.join(2, 1));
  EXPECT_FALSE(sets.join(3, 3));
  EXPECT_TRUE(sets.join(3, 2));
  EXPECT_FALSE(sets.join(1, 3));
  EXPECT_EQ(sets.find(0), 0u);
}

TEST(DisjointSets, TheSmallestMemberIsTheRoot) {
  DisjointSets sets(6);
  sets.join(5, 4);
  EXPECT_EQ(sets.find(5), 4u);
  sets.join(4, 3);
  sets.join(5, 1);
  for (const std::uint32_t i : {1u, 3u, 4u, 5u}) EXPECT_EQ(sets.find(i), 1u);
  EXPECT_EQ(sets.find(2), 2u);
}

RC_GTEST_PROP(DisjointSetsLaws, AgreeWithLabels, ()) {
  const std::uint32_t count = support::random_index(30) + 1;
  DisjointSets sets(count);
  std::vector<std::uint32_t> label(count);
  for (std::uint32_t i = 0; i < count; ++i) label[i] = i;
  for (std::uint32_t step = 0; step < 2 * count; ++step) {
    const std::uint32_t a = support::random_index(count), b = support::random_index(count);
    const std::uint32_t from = std::max(label[a], label[b]), to = std::min(label[a], label[b]);
    RC_ASSERT(sets.join(a, b) == (from != to));
    for (std::uint32_t& l : label) l = l == from ? to : l;
    for (std::uint32_t i = 0; i < count; ++i) RC_ASSERT(sets.find(i) == label[i]);
  }
}

std::set<std::uint32_t> as_set(std::span<const VertexId> vertices) {
  std::set<std::uint32_t> result;
  for (const VertexId v : vertices) result.insert(v.index());
  return result;
}

/// A lake (0, 1), a shelf at its height that drains (2 to 3), a ridge between them.
const std::vector<Point3> kLakeAndShelf = {{0, 0, 2},  {2, 1, 2},   {12, 0, 2}, {14, 1, 1},
                                           {7, 5, 9},  {7, -5, 9},  {7, 0, 9},  {-9, 9, 9},
                                           {25, 9, 9}, {25, -9, 9}, {-9, -9, 9}};

TEST(FlatSearch, TellsALakeFromAShelf) {
  const Surface surface = support::surface_of(kLakeAndShelf);
  FlatSearch flats(surface);
  EXPECT_TRUE(flats.on_pit(surface.delaunay(), vertex(0)));
  EXPECT_EQ(as_set(flats.flat()), (std::set<std::uint32_t>{0, 1}));
  EXPECT_TRUE(flats.on_pit(surface.delaunay(), vertex(1)));
  EXPECT_EQ(as_set(flats.flat()), (std::set<std::uint32_t>{0, 1}));
  EXPECT_FALSE(flats.on_pit(surface.delaunay(), vertex(2)));
  EXPECT_TRUE(flats.on_pit(surface.delaunay(), vertex(3)));
  EXPECT_FALSE(flats.on_pit(surface.delaunay(), vertex(6)));
}

TEST(FlatSearch, CountsAPitOnceHoweverOftenItIsTouched) {
  const Surface surface = support::surface_of(kLakeAndShelf);
  FlatSearch flats(surface);
  const auto touching = [&](std::vector<std::uint32_t> ids) {
    std::vector<VertexId> vertices;
    for (const std::uint32_t i : ids) vertices.push_back(vertex(i));
    return flats.pits_touching(surface.delaunay(), vertices);
  };
  EXPECT_EQ(touching({}), 0u);
  EXPECT_EQ(touching({0, 1, 0, 1, 1}), 1u);
  EXPECT_EQ(touching({2, 2, 6}), 0u);
  EXPECT_EQ(touching({1, 2, 3, 4}), 2u);
  EXPECT_EQ(touching({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}), surface.pits().size());
}

/// What is known to drain is not flooded again, nor is a long shelf from every vertex to where it drains.
TEST(FlatSearch, IsNotExhaustedByWhatItKnows) {
  std::vector<Point3> points = {{-2, 0, 0}, {-1, 4, 0}};
  for (std::uint32_t x = 0; x < 3000; ++x)
    points.insert(points.end(), {{double(x), 0, 1}, {double(x) + 0.5, 4, 1}});
  const Surface surface = support::surface_of(points);
  std::vector<VertexId> all;
  for (std::uint32_t v = 0; v < points.size(); ++v) all.push_back(vertex(v));
  FlatSearch flats(surface);
  EXPECT_EQ(flats.pits_touching(surface.delaunay(), all), 1u);
  EXPECT_FALSE(flats.exhausted());
  all.assign(3'000'000, vertex(100));
  EXPECT_EQ(flats.pits_touching(surface.delaunay(), all), 0u);
  EXPECT_FALSE(flats.exhausted());
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(flats.on_pit(surface.delaunay(), vertex(0)));
  EXPECT_FALSE(flats.exhausted());
}

TEST(FlatSearch, IsExhaustedInTheEnd) {
  const Surface surface = support::surface_of(kLakeAndShelf);
  FlatSearch flats(surface);
  for (int i = 0; i < 1'000'000; ++i) static_cast<void>(flats.on_pit(surface.delaunay(), vertex(0)));
  EXPECT_FALSE(flats.exhausted());
  for (int i = 0; i < 200; ++i) static_cast<void>(flats.on_pit(surface.delaunay(), vertex(0)));
  EXPECT_TRUE(flats.exhausted());
}

/// A flat in which two floods meet: the second one starts beside a vertex that the first has seen to drain.
RC_GTEST_PROP(FlatSearchLaws, AgreeWithAFullCount, ()) {
  const auto cloud = *support::clouds(30);
  const Surface surface = support::surface_of(cloud.points);
  const auto sites = oracle::sites_of(std::span<const Point3>(cloud.points));
  FlatSearch flats(surface);
  thalweg::Triangulation t = surface.delaunay();
  for (int round = 0; round < 4; ++round) {
    const Pits pits = find_pits(t, surface.z());
    std::vector<std::uint32_t> pit_of(cloud.size(), Surface::kNoPit);
    for (std::uint32_t i = 0; i < pits.size(); ++i) {
      for (const VertexId v : pits[i]) pit_of[v.index()] = i;
    }
    for (std::uint32_t v = 0; v < cloud.size(); ++v) {
      const bool on_pit = flats.on_pit(t, vertex(v));
      RC_ASSERT(on_pit == (pit_of[v] != Surface::kNoPit));
      if (on_pit) RC_ASSERT(as_set(flats.flat()) == as_set(pits[pit_of[v]]));
    }
    std::vector<VertexId> some;
    std::set<std::uint32_t> touched;
    for (std::uint32_t i = 0; i < 2 + cloud.size() / 2; ++i) {
      some.push_back(vertex(support::random_index(cloud.size())));
      if (pit_of[some.back().index()] != Surface::kNoPit) touched.insert(pit_of[some.back().index()]);
    }
    RC_ASSERT(flats.pits_touching(t, some) == touched.size());
    for (int i = 0; i < 10; ++i) support::flip_somewhere(sites, t);
  }
}

TEST(Surface, RanksByElevationThenPlace) {
  const Surface surface =
      support::surface_of(std::vector<Point3>{{3, 0, 1}, {0, 5, 1}, {0, 2, 1}, {9, 9, 0}, {1, 1, -0.0}});
  const std::uint32_t expected[] = {4, 3, 2, 1, 0};
  const auto ranks = surface.ranks();
  for (std::uint32_t v = 0; v < 5; ++v) EXPECT_EQ(ranks[v], expected[v]);
  EXPECT_TRUE(surface.lower(vertex(4), vertex(3)));
  EXPECT_FALSE(surface.lower(vertex(3), vertex(3)));
  EXPECT_EQ(surface.lowest(std::vector{vertex(0), vertex(1), vertex(2)}), vertex(2));
}

TEST(Surface, RanksElevationsOfAnySignThatDifferInTheirLastBitsAlone) {
  std::vector<Point3> points;
  for (int i = 0; i < 10'000; ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    points.push_back({static_cast<double>(i * 37 % 100), static_cast<double>(i / 100),
                      sign * (1 + (i * 7919 % 100) * 0x1p-52) * (i % 3 == 0 ? 1e-300 : 1)});
  }
  std::sort(points.begin(), points.end(),
            [](const Point3& p, const Point3& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  points.erase(std::unique(points.begin(), points.end(),
                           [](const Point3& p, const Point3& q) { return p.x == q.x && p.y == q.y; }),
               points.end());
  const Surface surface = support::surface_of(points);
  std::vector<VertexId> order;
  for (std::uint32_t v = 0; v < points.size(); ++v) order.push_back(vertex(v));
  std::sort(order.begin(), order.end(), [&](VertexId u, VertexId v) { return surface.lower(u, v); });
  for (const unsigned threads : {1u, 3u}) {
    const auto ranks = surface.ranks(threads);
    for (std::uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(ranks[order[i].index()], i);
  }
}

TEST(Surface, KnowsThePitOfEveryVertex) {
  const Surface surface = support::surface_of(kLakeAndShelf);
  EXPECT_EQ(surface.pits().size(), 2u);
  EXPECT_NE(surface.pit_of(vertex(0)), Surface::kNoPit);
  EXPECT_EQ(surface.pit_of(vertex(0)), surface.pit_of(vertex(1)));
  EXPECT_EQ(surface.pit_of(vertex(2)), Surface::kNoPit);
  EXPECT_NE(surface.pit_of(vertex(3)), surface.pit_of(vertex(0)));
}

}  // namespace
