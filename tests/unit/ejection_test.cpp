/// Ejection chains: never worse, always valid, and of use where single insertions are not.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <vector>

#include "kernel/edge_insertion.hpp"
#include "oracle/terrain.hpp"
#include "support/cloud.hpp"
#include "support/prepared.hpp"
#include "support/surface.hpp"
#include "terrain/ejection.hpp"
#include "terrain/flats.hpp"
#include "terrain/hull.hpp"
#include "thalweg/circle_count.hpp"

namespace {

using support::surface_of;
using thalweg::find_pits;
using thalweg::Point3;
using thalweg::detail::EdgeInsertion;
using thalweg::detail::find_exits;
using thalweg::detail::FlatSearch;
using thalweg::detail::insert_chains;
using thalweg::detail::insert_overlapping;
using thalweg::detail::Outcome;
using thalweg::detail::Surface;
using thalweg::detail::Watch;

std::vector<oracle::Tri> shape(const thalweg::Triangulation& t) {
  return oracle::normal_form(support::triangles_of(t));
}

Outcome delaunay_of(const Surface& surface) {
  Outcome outcome;
  outcome.triangulation = surface.delaunay();
  outcome.pits = surface.pits().size();
  return outcome;
}

/// The Delaunay triangulation with chains inserted, and the trail of these.
Outcome with_chains(const Surface& surface, unsigned k) {
  Watch watch;
  watch.keep_trail = true;
  Outcome outcome = delaunay_of(surface);
  insert_chains(surface, k, watch, outcome);
  return outcome;
}

RC_GTEST_PROP(InsertChains, NeverMakesItWorseAndKeepsTheOrder, ()) {
  const support::Cloud cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const auto k = *rc::gen::inRange(0u, 8u);
  const Outcome outcome = with_chains(surface, k);
  RC_ASSERT(outcome.pits <= surface.pits().size());
  RC_ASSERT(outcome.pits == find_pits(outcome.triangulation, surface.z()).size());
  RC_ASSERT(!outcome.triangulation.find_fault());
  RC_ASSERT(outcome.trail.size() == outcome.insertions);
  const auto orders = thalweg::face_orders(surface.graph(), outcome.triangulation, k);
  RC_ASSERT(std::all_of(orders.begin(), orders.end(), [k](std::uint32_t order) { return order <= k; }));
}

RC_GTEST_PROP(InsertChains, TakesBackWhatGainsNothing, ()) {
  const support::Cloud cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const auto k = *rc::gen::inRange(0u, 8u);
  Outcome outcome = delaunay_of(surface);
  outcome.circle_counts = 5;
  insert_overlapping(surface, find_exits(surface, k, 1, nullptr), k, Watch(), outcome);
  const Outcome before = outcome;
  insert_chains(surface, k, Watch(), outcome);
  RC_ASSERT(outcome.circle_counts >= before.circle_counts);
  RC_ASSERT((outcome.pits < before.pits) == (outcome.insertions > before.insertions));
  if (outcome.pits == before.pits) RC_ASSERT(shape(outcome.triangulation) == shape(before.triangulation));
}

/// Chains of one insertion are chains.
RC_GTEST_PROP(InsertChains, LeaveNothingToInsert, ()) {
  const support::Cloud cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const auto k = *rc::gen::inRange(0u, 8u);
  Outcome outcome = with_chains(surface, k);
  const std::uint32_t left = outcome.pits;
  insert_overlapping(surface, find_exits(surface, k, 1, nullptr), k, Watch(), outcome);
  RC_ASSERT(outcome.pits == left);
}

/// Whether each step leads from a pit to lower ground, or to level ground outside of it, and all of them to
/// the outcome.
bool inserts_exits_of_pits(const Surface& surface, unsigned k) {
  const Outcome outcome = with_chains(surface, k);
  thalweg::Triangulation t = surface.delaunay();
  FlatSearch flats(surface);
  EdgeInsertion insertion;
  for (const thalweg::TrailStep& step : outcome.trail) {
    if (!flats.on_pit(t, step.u)) return false;
    const auto pit = flats.flat();
    if (surface.z(step.v) > surface.z(step.u)) return false;
    if (std::find(pit.begin(), pit.end(), step.v) != pit.end()) return false;
    if (!insertion.plan(t, surface.sites(), step.u, step.v)) return false;
    insertion.apply(t);
  }
  return shape(t) == shape(outcome.triangulation);
}

RC_GTEST_PROP(InsertChains, InsertExitsOfPits, ()) {
  const support::Cloud cloud = *support::clouds(30);
  RC_ASSERT(inserts_exits_of_pits(surface_of(cloud.points), *rc::gen::inRange(0u, 8u)));
}

/// An exit to level ground that has become a part of the pit is none any more.
TEST(InsertChains, PassOverExitsWithinAPit) {
  const std::vector<Point3> points = {{0, 0, 0}, {4, 2, 1}, {0, 3, 2}, {8, 7, 1}, {6, 3, 1}, {2, 1, 2}};
  for (unsigned k = 0; k <= 3; ++k) EXPECT_TRUE(inserts_exits_of_pits(surface_of(points), k)) << k;
}

TEST(InsertChains, StopWhenCancelled) {
  const Surface surface = surface_of(support::dammed_valley());
  const std::atomic<bool> cancel{true};
  Watch watch;
  Outcome open = delaunay_of(surface), stopped = open;
  insert_chains(surface, 1, watch, open);
  EXPECT_EQ(open.pits, 1u);
  watch.cancel = &cancel;
  insert_chains(surface, 1, watch, stopped);
  EXPECT_EQ(stopped.pits, 2u);
}

/// Places and heights at random, until chains have found what single insertions could not.
TEST(InsertChains, FindsWhatSingleInsertionsCannot) {
  std::uint64_t state = 1;
  const auto next = [&state](std::uint64_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>((state >> 33) % below);
  };
  std::uint32_t gained = 0;
  for (int set = 0; set < 3000 && gained == 0; ++set) {
    std::vector<Point3> points;
    for (int i = 0; i < 40; ++i) points.push_back({next(1 << 20), next(1 << 20), next(1 << 20)});
    const Surface surface = surface_of(points);
    Outcome outcome = delaunay_of(surface);
    insert_overlapping(surface, find_exits(surface, 6, 1, nullptr), 6, Watch(), outcome);
    const std::uint32_t single = outcome.pits;
    insert_chains(surface, 6, Watch(), outcome);
    gained += single - outcome.pits;
  }
  EXPECT_GT(gained, 0u);
}

}  // namespace
