/// Exits and what follows from them: sorted, complete by brute force, prefixes; the reach bound; the least
/// order of an exit of each remaining pit, and its reason.
#include "terrain/exits.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <tuple>
#include <utility>
#include <vector>

#include "oracle/terrain.hpp"
#include "support/cloud.hpp"
#include "support/random_mesh.hpp"
#include "support/surface.hpp"
#include "terrain/hull.hpp"
#include "terrain/reasons.hpp"
#include "thalweg/useful_order.hpp"

namespace {

using support::surface_of;
using support::vertex;
using thalweg::Method;
using thalweg::PitReason;
using thalweg::Point3;
using thalweg::VertexId;
using thalweg::detail::Exit;
using thalweg::detail::exits_up_to;
using thalweg::detail::explain_pits;
using thalweg::detail::find_exits;
using thalweg::detail::reach_bound;
using thalweg::detail::Surface;

using Key = std::tuple<unsigned, std::uint32_t, std::uint32_t>;

std::vector<Key> keys(std::span<const Exit> exits) {
  std::vector<Key> result;
  for (const Exit& e : exits) result.emplace_back(e.order, e.from.index(), e.to.index());
  return result;
}

TEST(FindExits, OfADammedValley) {
  const Surface surface = surface_of(support::dammed_valley());
  EXPECT_TRUE(find_exits(surface, 0, 1, nullptr).empty());
  EXPECT_EQ(keys(find_exits(surface, 1, 1, nullptr)), (std::vector<Key>{{1, 0, 1}}));
  EXPECT_EQ(reach_bound(surface, find_exits(surface, 0, 1, nullptr)), 2u);
  EXPECT_EQ(reach_bound(surface, find_exits(surface, 1, 1, nullptr)), 1u);
}

TEST(FindExits, TwoLakesJoinedByALevelExitAreOneGroup) {
  auto points = support::dammed_valley();
  points[0].z = points[1].z;
  const Surface surface = surface_of(points);
  ASSERT_EQ(surface.pits().size(), 2u);
  const auto exits = find_exits(surface, 1, 1, nullptr);
  EXPECT_EQ(keys(exits), (std::vector<Key>{{1, 0, 1}, {1, 1, 0}}));
  EXPECT_EQ(reach_bound(surface, exits), 1u);
  EXPECT_EQ(reach_bound(surface, {}), 2u);
}

/// Beyond the dam, ground as high as the pit, which drains to a lower one.
TEST(FindExits, LevelGroundThatDrainsIsAWayOut) {
  auto points = support::dammed_valley();
  points[1].z = points[0].z;
  points.push_back({4, 0.5, 0});
  const Surface surface = surface_of(points);
  ASSERT_EQ(surface.pits().size(), 2u);
  ASSERT_EQ(surface.pit_of(vertex(1)), Surface::kNoPit);
  const auto exits = find_exits(surface, 1, 1, nullptr);
  EXPECT_EQ(keys(exits), (std::vector<Key>{{1, 0, 1}}));
  EXPECT_EQ(reach_bound(surface, exits), 1u);
}

TEST(FindExits, ReachBoundJoinsGroupsAlongChains) {
  // Three lakes in a row behind dams, all level: two level exits make one group; a lower end drains it.
  std::vector<Point3> points = {{0, 0, 1},  {4, 0, 1},  {8, 0, 1},   {2, 1, 5},   {2, -1, 5}, {6, 1, 5},
                                {6, -1, 5}, {4, 40, 9}, {4, -40, 9}, {-40, 0, 9}, {50, 0, 9}};
  {
    const Surface surface = surface_of(points);
    ASSERT_EQ(surface.pits().size(), 3u);
    EXPECT_EQ(reach_bound(surface, find_exits(surface, 1, 1, nullptr)), 1u);
  }
  points[2].z = 0;
  const Surface surface = surface_of(points);
  ASSERT_EQ(surface.pits().size(), 3u);
  EXPECT_EQ(reach_bound(surface, find_exits(surface, 1, 1, nullptr)), 1u);
  EXPECT_EQ(reach_bound(surface, find_exits(surface, 0, 1, nullptr)), 3u);
}

TEST(FindExits, StopWhenCancelled) {
  const Surface surface = surface_of(support::dammed_valley());
  const std::atomic<bool> cancel{true};
  EXPECT_TRUE(find_exits(surface, 1, 1, &cancel).empty());
}

/// Every pair from a vertex of a pit to lower ground, or to level ground outside the pit, by definition.
std::vector<Key> exits_by_definition(const Surface& surface, std::span<const oracle::Site> s, unsigned k) {
  std::vector<Key> result;
  for (std::uint32_t i = 0; i < surface.pits().size(); ++i) {
    for (const VertexId p : surface.pits()[i]) {
      for (std::uint32_t q = 0; q < s.size(); ++q) {
        const bool out =
            s[q].z < s[p.index()].z || (s[q].z == s[p.index()].z && surface.pit_of(vertex(q)) != i);
        if (!out) continue;
        const auto order = oracle::useful_order(s, p.index(), q);
        if (order && *order <= k) result.emplace_back(*order, p.index(), q);
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

RC_GTEST_PROP(FindExitsLaws, AreTheDefinitionSortedByOrderAndRanks, ()) {
  const auto cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const auto s = oracle::sites_of(std::span<const Point3>(cloud.points));
  const unsigned k = support::random_index(7);
  const auto exits = find_exits(surface, k, 1, nullptr);
  std::vector<Key> found = keys(exits);
  std::sort(found.begin(), found.end());
  RC_ASSERT(found == exits_by_definition(surface, s, k));
  const auto rank = surface.ranks();
  std::vector<Key> by_rank;
  for (const Exit& e : exits) by_rank.emplace_back(e.order, rank[e.from.index()], rank[e.to.index()]);
  RC_ASSERT(std::is_sorted(by_rank.begin(), by_rank.end()));

  RC_ASSERT(reach_bound(surface, exits) == oracle::reach_bound(s, k));
  for (unsigned lower = 0; lower <= k; ++lower) {
    const auto prefix = exits_up_to(exits, lower);
    RC_ASSERT(keys(prefix) == keys(find_exits(surface, lower, 2, nullptr)));
    RC_ASSERT(reach_bound(surface, prefix) == oracle::reach_bound(s, lower));
  }
  RC_ASSERT(exits_up_to(exits, k + 5).size() == exits.size());
}

TEST(ExplainPits, ADamThatNeedsAnOrderMore) {
  const Surface surface = surface_of(support::dammed_valley());
  const auto explained = explain_pits(surface, surface.pits(), {}, 0, Method::best, {});
  ASSERT_EQ(explained.pits.size(), 2u);
  EXPECT_EQ(explained.pits[0].vertex, vertex(0));
  EXPECT_EQ(explained.pits[0].reason, PitReason::unremovable);
  EXPECT_EQ(explained.pits[0].order_needed, 1u);
  EXPECT_EQ(explained.pits[1].vertex, vertex(1));
  EXPECT_EQ(explained.pits[1].reason, PitReason::unremovable);
  EXPECT_EQ(explained.pits[1].order_needed, std::nullopt);
  EXPECT_EQ(explained.order_searched, 1u);  // all but the bottom have a way out
}

TEST(ExplainPits, WithinReachIsAConflictOrWasNotTried) {
  const Surface surface = surface_of(support::dammed_valley());
  const auto exits = find_exits(surface, 1, 1, nullptr);
  for (const Method method : {Method::flip, Method::hull, Method::best, Method::delaunay}) {
    const auto explained = explain_pits(surface, surface.pits(), exits, 1, method, {});
    EXPECT_EQ(explained.pits[0].order_needed, 1u);
    EXPECT_EQ(explained.pits[0].reason, method == Method::delaunay ? PitReason::kept : PitReason::conflict);
    EXPECT_EQ(explained.pits[1].reason, PitReason::unremovable);
  }
}

/// The least useful order from the pit to lower ground, or to level ground outside it.
std::optional<unsigned> least_order(std::span<const oracle::Site> s, std::span<const VertexId> pit) {
  std::optional<unsigned> least;
  for (const VertexId p : pit) {
    for (std::uint32_t q = 0; q < s.size(); ++q) {
      if (s[q].z > s[p.index()].z || std::binary_search(pit.begin(), pit.end(), vertex(q))) continue;
      const auto order = oracle::useful_order(s, p.index(), q);
      if (order && (!least || *order < *least)) least = order;
    }
  }
  return least;
}

RC_GTEST_PROP(ExplainPitsLaws, NeededOrdersAreTheLeast, ()) {
  const auto cloud = *support::clouds(25);
  const Surface surface = surface_of(cloud.points);
  const auto s = oracle::sites_of(std::span<const Point3>(cloud.points));
  const unsigned k = support::random_index(5);
  const auto exits = find_exits(surface, k, 1, nullptr);
  auto outcome = insert_hulls(surface, exits, k, {});
  insert_overlapping(surface, exits, k, {}, outcome);
  const thalweg::Pits pits = find_pits(outcome.triangulation, surface.z());
  const auto explained = explain_pits(surface, pits, exits, k, Method::best, {});
  RC_ASSERT(explained.pits.size() == pits.size());
  for (std::uint32_t i = 0; i < pits.size(); ++i) {
    const auto& pit = explained.pits[i];
    const auto least = least_order(s, pits[i]);
    RC_ASSERT(pit.vertex == surface.lowest(pits[i]));
    RC_ASSERT(pit.vertices == pits[i].size());
    RC_ASSERT(pit.boundary == pits.boundary(i));
    RC_ASSERT(pit.order_needed == (least && *least <= explained.order_searched ? least : std::nullopt));
    RC_ASSERT((pit.reason == PitReason::unremovable) == (!least || *least > k));
    RC_ASSERT(pit.reason != PitReason::kept);
  }
}

/// Whether the exits are those of a plain scan of all useful pairs.
testing::AssertionResult all_exits_found(const Surface& surface, unsigned k) {
  std::vector<std::array<std::uint32_t, 3>> expected, found;
  for (const thalweg::UsefulPair& pair : thalweg::useful_pairs(surface.graph(), k)) {
    for (const auto& [p, q] : {std::pair(pair.u, pair.v), std::pair(pair.v, pair.u)}) {
      const std::uint32_t pit = surface.pit_of(p);
      if (pit == Surface::kNoPit || surface.z(q) > surface.z(p)) continue;
      if (surface.z(q) == surface.z(p) && surface.pit_of(q) == pit) continue;
      expected.push_back({p.index(), q.index(), pair.order});
    }
  }
  for (const auto& exit : find_exits(surface, k, 1, nullptr)) {
    found.push_back({exit.from.index(), exit.to.index(), exit.order});
  }
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  if (found == expected) return testing::AssertionSuccess() << found.size() << " exits";
  return testing::AssertionFailure() << found.size() << " exits of " << expected.size() << " at order " << k;
}

/// Lakes of more vertices than are all searched. Random places, and a lattice, where every vertex is on a
/// cocircular face.
TEST(FindExits, SkipNothingInLargeLakes) {
  for (const bool lattice : {false, true}) {
    std::uint64_t state = 7;
    std::vector<Point3> points;
    for (int i = 0; i < 900; ++i) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      const auto x = lattice ? i % 30 : static_cast<int>((state >> 33) % 100000);
      state = state * 6364136223846793005u + 1442695040888963407u;
      const auto y = lattice ? i / 30 : static_cast<int>((state >> 33) % 100000);
      const double size = lattice ? 30 : 100000;
      // Two lakes behind a wall, one lower than the other.
      const double wall = lattice ? 0.01 : 0.045;
      points.push_back({double(x), double(y),
                        x > (0.5 + wall) * size   ? 0.0
                        : x < (0.5 - wall) * size ? 1.0
                                                  : 2.0});
    }
    const Surface surface = surface_of(points);
    for (const unsigned k : {0u, 2u, 12u}) {
      EXPECT_TRUE(all_exits_found(surface, k)) << (lattice ? "lattice" : "random");
      EXPECT_TRUE(!lattice || k < 12 || !find_exits(surface, k, 1, nullptr).empty());
    }
  }
}

/// A lake with holes, each behind a rim of one vertex's width: the lake has exits to them from as far inside
/// as there can be.
TEST(FindExits, SkipNothingAroundHoles) {
  std::uint64_t state = 11;
  std::vector<Point3> points;
  for (int i = 0; i < 900; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const auto x = static_cast<double>((state >> 33) % 100000);
    state = state * 6364136223846793005u + 1442695040888963407u;
    points.push_back({x, static_cast<double>((state >> 33) % 100000), 1});
  }
  const thalweg::Triangulation t = surface_of(points).delaunay();
  for (std::uint32_t hole = 0; hole < 900; hole += 60) {
    points[hole].z = 0;
    t.for_each_neighbor(vertex(hole), [&](VertexId w) { points[w.index()].z = 2; });
  }
  const Surface surface = surface_of(points);
  std::size_t largest = 0;
  for (std::uint32_t i = 0; i < surface.pits().size(); ++i)
    largest = std::max(largest, surface.pits()[i].size());
  ASSERT_GT(largest, 500u);
  for (const unsigned k : {0u, 1u, 2u, 3u, 4u, 6u}) EXPECT_TRUE(all_exits_found(surface, k));
}

/// 324 sites on one circle, all level but for one corner of their triangulation: across the circle every
/// vertex of the lake has an exit of order 0 to it, however far it is along edges.
TEST(FindExits, SkipNothingAcrossACocircularFace) {
  std::vector<Point3> points;
  for (const auto& p : support::integer_circle(32045)) points.push_back({p.x, p.y, 1});
  const thalweg::Triangulation t = surface_of(points).delaunay();
  const auto neighbors = [&](std::uint32_t v) {
    std::vector<VertexId> result;
    t.for_each_neighbor(vertex(v), [&](VertexId w) { result.push_back(w); });
    return result;
  };
  std::uint32_t corner = 0;
  while (neighbors(corner).size() != 2) ++corner;
  points[corner].z = 0;
  for (const VertexId w : neighbors(corner)) points[w.index()].z = 2;
  const Surface surface = surface_of(points);
  EXPECT_TRUE(all_exits_found(surface, 0));
  EXPECT_EQ(find_exits(surface, 0, 1, nullptr).size(), points.size() - 3);
}

}  // namespace
