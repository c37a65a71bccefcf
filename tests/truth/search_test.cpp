/// The two searches of the exact method, each on its own, against the enumeration of all triangulations.
///
/// Seen from outside they say little: where `best` has found the optimum already, a search that overlooks
/// half of its nodes still ends with the right answer.
///
/// More sets, or other ones:
///     THALWEG_EXACT_SETS=20000 THALWEG_EXACT_SEED=1 test_truth --gtest_filter='Completion.*:ExactSearch.*'
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "support/point_sets.hpp"
#include "support/prepared.hpp"
#include "support/surface.hpp"
#include "terrain/completion.hpp"
#include "terrain/exact.hpp"
#include "truth/drawn_set.hpp"

namespace {

using oracle::EdgeSet;
using oracle::Enumeration;
using oracle::Pair;
using support::DrawnSet;
using support::surface_of;
using thalweg::detail::Completion;
using thalweg::detail::Outcome;
using thalweg::detail::Plan;
using thalweg::detail::RequiredEdge;
using thalweg::detail::Surface;
using thalweg::detail::Watch;

/// The order of a triangulation that has all these edges; nothing if it is none or lacks one.
std::optional<unsigned> order_with(const Enumeration& all, const thalweg::Triangulation& t,
                                   EdgeSet required) {
  EdgeSet edges = 0;
  for (const oracle::Tri& face : support::triangles_of(t)) {
    if (!all.is_face(face)) return std::nullopt;
    edges |= Enumeration::sides_of(face);
  }
  const Enumeration::Entry* entry = all.find(edges);
  if (entry == nullptr || (edges & required) != required) return std::nullopt;
  return entry->order;
}

/// A few edges of some triangulation, but none that every Delaunay triangulation has, for these change
/// nothing; fewer if there are not that many.
std::vector<Pair> draw_edges(const Enumeration& all, EdgeSet always, support::Random& random) {
  const EdgeSet edges = all.all()[random.below(static_cast<std::uint32_t>(all.all().size()))].edges & ~always;
  std::vector<Pair> held;
  for (std::uint32_t v = 1; v < all.size(); ++v) {
    for (std::uint32_t u = 0; u < v; ++u) {
      if ((edges & oracle::edge(u, v)) != 0) held.emplace_back(u, v);
    }
  }
  std::vector<Pair> result;
  for (std::uint32_t more = 2 + random.below(4); more > 0 && !held.empty(); --more) {
    const std::uint32_t i = random.below(static_cast<std::uint32_t>(held.size()));
    result.push_back(held[i]);
    held.erase(held.begin() + i);
  }
  return result;
}

/// Edges no two of which cross, at the least order at which each is useful, extend to a triangulation of that
/// order or they do not: `find` knows which, whether the constrained Delaunay triangulation will do or others
/// have to be tried.
TEST(Completion, KnowsWhichEdgesExtend) {
  const std::uint64_t sets = support::from_environment("THALWEG_EXACT_SETS", 1500);
  const std::uint64_t seed = support::from_environment("THALWEG_EXACT_SEED", 20090601);
  std::uint64_t constrained = 0, grown = 0, impossible = 0;
  for (std::uint64_t i = 0; i < sets; ++i) {
    const DrawnSet set = support::draw_set(seed, i);
    const Enumeration& all = *set.enumeration;
    const Surface surface = surface_of(set.cloud.points);
    std::vector<EdgeSet> useful;
    for (unsigned k = 0; k <= all.most_order(); ++k) useful.push_back(all.useful(k));
    EdgeSet always = useful[0];
    for (const Enumeration::Entry& t : all.all()) always &= t.order == 0 ? t.edges : always;
    support::Random random(i);
    for (int draw = 0; draw < 40; ++draw) {
      EdgeSet edges = 0;
      std::vector<RequiredEdge> required;
      std::string names;
      for (const auto& [u, v] : draw_edges(all, always, random)) {
        edges |= oracle::edge(u, v);
        required.push_back({support::vertex(u), support::vertex(v)});
        names += " " + std::to_string(u) + "-" + std::to_string(v);
      }
      unsigned k = 0;
      while ((edges & ~useful[k]) != 0) ++k;
      SCOPED_TRACE(support::printed(set.cloud) + " order " + std::to_string(k) + ", edges" + names);
      Completion completion(surface, k);
      const auto answer = completion.find(required, 1'000'000, Watch());
      const bool possible = all.least_order(edges) <= k;
      ASSERT_EQ(answer, possible ? Completion::Answer::found : Completion::Answer::impossible);
      ASSERT_TRUE(!possible || order_with(all, completion.triangulation(), edges).value_or(k + 1) <= k);
      ++(!possible ? impossible : completion.edges().size() > required.size() ? grown : constrained);
    }
  }
  std::printf("%llu by constraints alone, %llu grown, %llu impossible\n",
              static_cast<unsigned long long>(constrained), static_cast<unsigned long long>(grown),
              static_cast<unsigned long long>(impossible));
  EXPECT_GE(constrained, sets);
  EXPECT_GE(grown, sets / 200);  // rare, whatever is drawn
  EXPECT_GE(impossible, sets / 20);
}

struct Extensible {
  std::vector<thalweg::Point3> points;
  unsigned order;
  std::vector<Pair> edges;
};

/// Found by comparing `find` with a version that takes the first triangle that fits and never takes one back.
TEST(Completion, TakesBackTrianglesThatLeadNowhere) {
  const Extensible cases[] = {
      {{{705, 0, 0},
        {884, 0, 1},
        {380, 3, 2},
        {419, 0, 3},
        {603, 3, 4},
        {785, 3, 5},
        {65, 0, 6},
        {851, 0, 7},
        {670, 3, 8},
        {106, 0, 9},
        {961, 1, 10}},
       4,
       {{4, 9}, {3, 10}, {4, 10}}},
      {{{458, 3, 0},
        {74, 3, 1},
        {92, 1, 2},
        {527, 1, 3},
        {993, 3, 4},
        {298, 3, 5},
        {94, 1, 6},
        {56, 0, 7},
        {965, 2, 8},
        {12, 2, 9},
        {305, 3, 10},
        {554, 0, 11}},
       6,
       {{0, 8}, {0, 9}, {3, 9}}},
      {{{592, 2, 0},
        {544, 0, 1},
        {698, 1, 2},
        {229, 0, 3},
        {37, 1, 4},
        {776, 2, 5},
        {513, 0, 6},
        {275, 2, 7},
        {148, 2, 8},
        {823, 2, 9},
        {690, 2, 10},
        {841, 2, 11}},
       5,
       {{4, 5}, {2, 3}, {4, 7}}},
  };
  for (const Extensible& c : cases) {
    const support::Cloud cloud{c.points};
    SCOPED_TRACE(support::printed(cloud));
    const Surface surface = surface_of(cloud.points);
    std::vector<RequiredEdge> required;
    for (const auto& [u, v] : c.edges) required.push_back({support::vertex(u), support::vertex(v)});
    Completion completion(surface, c.order);
    ASSERT_EQ(completion.find(required, 1'000'000, Watch()), Completion::Answer::found);
    const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(c.points));
    const auto triangles = support::triangles_of(completion.triangulation());
    ASSERT_TRUE(oracle::is_triangulation(sites, triangles));
    for (const oracle::Tri& t : triangles) EXPECT_LE(oracle::triangle_order(sites, t), c.order);
    for (const RequiredEdge& e : required) EXPECT_TRUE(completion.triangulation().joined(e.u, e.v));
  }
}

/// From the worst start, with the plan and with one that knows no bound, so that nothing is pruned but by the
/// search itself.
TEST(ExactSearch, FindsTheOptimumFromDelaunay) {
  const std::uint64_t sets = support::from_environment("THALWEG_EXACT_SETS", 1500);
  const std::uint64_t seed = support::from_environment("THALWEG_EXACT_SEED", 20090601);
  for (std::uint64_t i = 0; i < sets; ++i) {
    const DrawnSet set = support::draw_set(seed, i);
    const Enumeration& all = *set.enumeration;
    const oracle::Relief relief(set.cloud.elevations());
    const auto fewest = all.fewest_pits(relief);
    const Surface surface = surface_of(set.cloud.points);
    for (unsigned k = 0; k <= all.most_order(); ++k) {
      SCOPED_TRACE(support::printed(set.cloud) + " order " + std::to_string(k));
      const auto exits = thalweg::detail::find_exits(surface, k, 1, nullptr);
      const Plan plan = thalweg::detail::make_plan(surface, exits, k, Watch());
      ASSERT_LE(plan.bound, fewest[k]);
      const Plan no_plan{{0, {}, {0}}, thalweg::detail::Crossings(surface, {}), {}, 0};
      for (const Plan* with : {&plan, &no_plan}) {
        Outcome start;
        start.triangulation = surface.delaunay();
        start.pits = surface.pits().size();
        const auto found = exact_pits(surface, *with, start, k, Watch());
        ASSERT_EQ(found.outcome.pits, fewest[k]);
        ASSERT_EQ(found.bound, fewest[k]);
        ASSERT_LE(order_with(all, found.outcome.triangulation, 0).value_or(k + 1), k);
        ASSERT_EQ(find_pits(found.outcome.triangulation, surface.z()).size(), fewest[k]);
      }
    }
  }
}

}  // namespace
