/// Units, their exits, which of these cross, and the largest assignment: all by definition on small terrains.
#include "terrain/units.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "oracle/terrain.hpp"
#include "support/cloud.hpp"
#include "support/prepared.hpp"
#include "support/random_mesh.hpp"
#include "support/surface.hpp"
#include "terrain/assign.hpp"
#include "thalweg/circle_count.hpp"

namespace {

using support::surface_of;
using support::vertex;
using thalweg::Point2;
using thalweg::Point3;
using thalweg::detail::Assignment;
using thalweg::detail::cross_properly;
using thalweg::detail::Crossings;
using thalweg::detail::ExitPair;
using thalweg::detail::find_exits;
using thalweg::detail::find_units;
using thalweg::detail::insert_assignment;
using thalweg::detail::make_plan;
using thalweg::detail::meeting_pairs;
using thalweg::detail::Plan;
using thalweg::detail::solve_assignment;
using thalweg::detail::Surface;
using thalweg::detail::UnitExit;
using thalweg::detail::Units;
using thalweg::detail::Watch;

constexpr std::uint32_t kNone = Units::kGround;

/// The set of each vertex among those of equal height that are joined by `edges` and that no edge leads down
/// from: the first vertex of the set in elevation order, or kNone.
std::vector<std::uint32_t> sets_without_way_down(const Surface& surface,
                                                 const std::set<oracle::Pair>& edges) {
  const auto n = static_cast<std::uint32_t>(surface.sites().size());
  const auto z = surface.z();
  std::vector<std::uint32_t> first(n);
  for (std::uint32_t v = 0; v < n; ++v) first[v] = v;
  std::vector<bool> drains(n, false);
  for (std::uint32_t round = 0; round < n; ++round) {
    for (const auto& [u, v] : edges) {
      if (z[u] != z[v]) {
        drains[z[u] > z[v] ? u : v] = true;
        continue;
      }
      const std::uint32_t least = surface.lower(vertex(first[u]), vertex(first[v])) ? first[u] : first[v];
      first[u] = first[v] = least;
      if (drains[u] || drains[v]) drains[u] = drains[v] = true;
    }
  }
  for (std::uint32_t v = 0; v < n; ++v) first[v] = drains[v] ? kNone : first[v];
  return first;
}

/// An exit by definition: the unit by its first vertex, then what exits are sorted by, but for elevation.
using Key = std::tuple<std::uint32_t, unsigned, std::uint32_t, std::uint32_t, std::uint32_t>;

struct Defined {
  std::vector<std::uint32_t> unit;  // of each vertex: the first vertex of its unit, or kNone
  std::set<Key> exits;              // unit, order, from, to, target
};

/// The words of units.hpp, again and again until nothing changes.
Defined units_by_definition(const Surface& surface, std::span<const oracle::Site> s, unsigned k) {
  const auto pairs = oracle::useful_pairs(s, k);
  const auto delaunay = oracle::edges_of(support::triangles_of(surface.delaunay()));
  std::set<oracle::Pair> safe(delaunay.begin(), delaunay.end());
  for (;;) {
    Defined result{sets_without_way_down(surface, safe), {}};
    std::set<oracle::Pair> left = safe;
    for (const oracle::OrderedPair& pair : pairs) {
      for (const oracle::Pair& way : {oracle::Pair(pair.u, pair.v), oracle::Pair(pair.v, pair.u)}) {
        const std::uint32_t p = way.first, q = way.second;
        const std::uint32_t unit = result.unit[p], other = result.unit[q];
        if (unit == kNone || s[q].z > s[p].z || (s[q].z == s[p].z && other == unit)) continue;
        result.exits.emplace(unit, pair.order, p, q, s[q].z == s[p].z ? other : kNone);
        std::erase_if(
            left, [&](const oracle::Pair& e) { return oracle::cross(s[p], s[q], s[e.first], s[e.second]); });
      }
    }
    if (left == safe) return result;
    safe = std::move(left);
  }
}

Units units_of(const Surface& surface, unsigned k) {
  return find_units(surface, find_exits(surface, k, 1, nullptr), k, Watch());
}

/// Whether find_units finds what is defined: units by their first vertices, and their exits, each once and in
/// order.
bool units_are_as_defined(const Surface& surface, std::span<const oracle::Site> s, unsigned k) {
  const Defined expected = units_by_definition(surface, s, k);
  const Units units = units_of(surface, k);

  // In elevation order of their first vertices.
  std::vector<std::uint32_t> firsts;
  for (std::uint32_t v = 0; v < s.size(); ++v) {
    if (expected.unit[v] == v) firsts.push_back(v);
  }
  std::sort(firsts.begin(), firsts.end(),
            [&](std::uint32_t u, std::uint32_t v) { return surface.lower(vertex(u), vertex(v)); });
  if (units.count != firsts.size()) return false;
  std::set<Key> found;
  const auto rank = surface.ranks();
  for (std::uint32_t u = 0; u < units.count; ++u) {
    std::vector<std::tuple<unsigned, std::uint32_t, std::uint32_t>> order;
    for (const UnitExit& e : units.of(u)) {
      if (e.unit != u) return false;
      found.emplace(firsts[u], e.exit.order, e.exit.from.index(), e.exit.to.index(),
                    e.target == Units::kGround ? kNone : firsts[e.target]);
      order.emplace_back(e.exit.order, rank[e.exit.from.index()], rank[e.exit.to.index()]);
    }
    if (!std::is_sorted(order.begin(), order.end())) return false;
    if (std::adjacent_find(order.begin(), order.end()) != order.end()) return false;
  }
  return found == expected.exits && units.exits.size() == found.size();
}

RC_GTEST_PROP(UnitsLaws, AreTheDefinition, ()) {
  const auto cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const auto s = oracle::sites_of(std::span<const Point3>(cloud.points));
  RC_ASSERT(units_are_as_defined(surface, s, support::random_index(7)));
}

/// What drains at first is cut off by the exits of what was cut off before it.
TEST(Units, OfTheSecondRound) {
  const std::vector<std::vector<Point3>> terrains = {{{2, 4, 2},
                                                      {2, 9, 2},
                                                      {13, 2, 2},
                                                      {10, 5, 0},
                                                      {13, 11, 1},
                                                      {5, 5, 2},
                                                      {0, 2, 1},
                                                      {10, 0, 0},
                                                      {9, 13, 0},
                                                      {11, 2, 1},
                                                      {3, 0, 2}},
                                                     {{81, 50, 5},
                                                      {703, 16, 1},
                                                      {612, 136, 5},
                                                      {563, 42, 5},
                                                      {67, 104, 4},
                                                      {368, 15, 0},
                                                      {457, 122, 3},
                                                      {839, 84, 1},
                                                      {549, 7, 2},
                                                      {380, 6, 0}},
                                                     {{657, 3, 4},
                                                      {746, 2, 2},
                                                      {838, 66, 0},
                                                      {636, 109, 5},
                                                      {181, 8, 2},
                                                      {3, 104, 3},
                                                      {880, 8, 6},
                                                      {703, 96, 4},
                                                      {96, 49, 1},
                                                      {458, 128, 2},
                                                      {874, 127, 6},
                                                      {993, 73, 4}}};
  for (const std::vector<Point3>& points : terrains) {
    const auto cloud = support::make_cloud(points);
    const Surface surface = surface_of(cloud.points);
    const auto s = oracle::sites_of(std::span<const Point3>(cloud.points));
    for (unsigned k = 0; k <= 8; ++k) EXPECT_TRUE(units_are_as_defined(surface, s, k)) << k;
  }
}

TEST(CrossProperly, OnlyInsideBoth) {
  const Point2 a{0, 0}, b{4, 0}, c{2, -1}, d{2, 1};
  EXPECT_TRUE(cross_properly(a, b, c, d));
  EXPECT_TRUE(cross_properly(c, d, b, a));
  EXPECT_FALSE(cross_properly(a, b, {2, 1}, {2, 2}));
  EXPECT_FALSE(cross_properly(a, b, {2, 0}, d));  // an end on the other
  EXPECT_FALSE(cross_properly({2, 0}, d, a, b));
  EXPECT_FALSE(cross_properly(a, b, a, d));
  EXPECT_FALSE(cross_properly(a, b, {1, 0}, {6, 0}));
  EXPECT_FALSE(cross_properly(a, b, {5, -1}, {5, 1}));
}

/// Whether the open segment pq meets the inside of the triangle, or is a side of it.
bool passes(std::span<const oracle::Site> s, std::uint32_t p, std::uint32_t q, const oracle::Tri& t) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = t[i], b = t[(i + 1) % 3];
    if (oracle::cross(s[p], s[q], s[a], s[b]) || std::minmax(p, q) == std::minmax(a, b)) return true;
  }
  return false;
}

RC_GTEST_PROP(CrossingsLaws, AreTheDefinition, ()) {
  const auto cloud = *support::clouds(25);
  const Surface surface = surface_of(cloud.points);
  const auto s = oracle::sites_of(std::span<const Point3>(cloud.points));
  const Units units = units_of(surface, support::random_index(7));
  const auto triangles = support::triangles_of(surface.delaunay());
  const Crossings crossings(surface, units.exits);
  RC_ASSERT(crossings.complete());
  std::vector<ExitPair> meeting;
  for (std::uint32_t i = 0; i < units.exits.size(); ++i) {
    const std::uint32_t p = units.exits[i].exit.from.index(), q = units.exits[i].exit.to.index();
    std::vector<std::uint32_t> crossed;
    for (std::uint32_t j = 0; j < units.exits.size(); ++j) {
      const std::uint32_t u = units.exits[j].exit.from.index(), v = units.exits[j].exit.to.index();
      if (oracle::cross(s[p], s[q], s[u], s[v]) || (p == v && q == u)) crossed.push_back(j);
      const bool meet = std::any_of(triangles.begin(), triangles.end(), [&](const oracle::Tri& t) {
        return passes(s, p, q, t) && passes(s, u, v, t);
      });
      if (i < j && meet) meeting.emplace_back(i, j);
    }
    const auto found = crossings.of(i);
    RC_ASSERT(std::vector<std::uint32_t>(found.begin(), found.end()) == crossed);
  }
  RC_ASSERT(meeting_pairs(surface, units.exits) == meeting);
}

/// Thousands of exits through one triangle are not looked at pair by pair.
TEST(Crossings, AreNotKnownOfTooMany) {
  const Surface surface = surface_of(support::dammed_valley());
  const std::vector<UnitExit> exits(6400, {{vertex(0), vertex(1), 1}, 0, kNone});
  EXPECT_EQ(meeting_pairs(surface, exits), std::nullopt);
  const Crossings crossings(surface, exits);
  EXPECT_FALSE(crossings.complete());
  EXPECT_TRUE(crossings.of(0).empty());
}

/// Every other site of a large cocircular face is a pit, and all of these have ways to each other.
TEST(Plan, DoesWithTheReachBoundWhereTooManyCross) {
  std::vector<Point3> points;
  double z = 0;
  const auto circle = support::integer_circle(32045);
  for (std::size_t i = 0; i < circle.size(); i += 2) points.push_back({circle[i].x, circle[i].y, z = 1 - z});
  const Surface surface = surface_of(points);
  const auto exits = find_exits(surface, 0, 1, nullptr);
  const Plan plan = make_plan(surface, exits, 0, Watch());
  EXPECT_FALSE(plan.crossings.complete());
  EXPECT_FALSE(plan.assignment.complete);
  EXPECT_EQ(plan.bound, 1u);
}

/// The size of the largest assignment, by trying every exit of every unit, as far as `steps` go.
class Largest {
 public:
  Largest(const Units& units, const Crossings& crossings)
      : units_(units), crossings_(crossings), exit_of_(units.count, kNone) {}

  std::uint32_t size() {
    visit(0, 0);
    return best_;
  }
  bool gave_up() const { return steps_ == 0; }

 private:
  bool is_free(std::uint32_t e) const {
    for (const std::uint32_t other : crossings_.of(e)) {
      if (exit_of_[units_.exits[other].unit] == other) return false;
    }
    std::uint32_t at = units_.exits[e].target;
    while (at != kNone && at != units_.exits[e].unit) {
      at = exit_of_[at] == kNone ? kNone : units_.exits[exit_of_[at]].target;
    }
    return at == kNone;
  }

  void visit(std::uint32_t unit, std::uint32_t served) {
    best_ = std::max(best_, served);
    if (unit == units_.count || served + units_.count - unit <= best_ || steps_ == 0) return;
    --steps_;
    for (std::uint32_t e = units_.starts[unit]; e < units_.starts[unit + 1]; ++e) {
      if (!is_free(e)) continue;
      exit_of_[unit] = e;
      visit(unit + 1, served + 1);
      exit_of_[unit] = kNone;
    }
    visit(unit + 1, served);
  }

  const Units& units_;
  const Crossings& crossings_;
  std::vector<std::uint32_t> exit_of_;
  std::uint32_t best_ = 0;
  std::uint32_t steps_ = 20000;
};

/// What is wrong with the assignment, whatever its size; nullptr if nothing.
const char* fault_of(const Assignment& assignment, const Units& units, const Crossings& crossings) {
  std::vector<std::uint32_t> exit_of(units.count, kNone);
  if (!std::is_sorted(assignment.chosen.begin(), assignment.chosen.end())) return "not ascending";
  for (const std::uint32_t e : assignment.chosen) {
    if (exit_of[units.exits[e].unit] != kNone) return "two exits of one unit";
    exit_of[units.exits[e].unit] = e;
    const auto crossed = crossings.of(e);
    for (const std::uint32_t other : assignment.chosen) {
      if (std::find(crossed.begin(), crossed.end(), other) != crossed.end()) return "two that cross";
    }
  }
  for (std::uint32_t u = 0; u < units.count; ++u) {
    std::uint32_t at = u;
    for (std::uint32_t steps = 0; at != kNone; ++steps) {
      if (steps > units.count) return "a cycle";
      at = exit_of[at] == kNone ? kNone : units.exits[exit_of[at]].target;
    }
  }
  return nullptr;
}

RC_GTEST_PROP(AssignmentLaws, IsValidAndALargestOne, ()) {
  const auto cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const Units units = units_of(surface, support::random_index(7));
  const Crossings crossings(surface, units.exits);
  const Assignment assignment = solve_assignment(units, crossings);
  RC_ASSERT(fault_of(assignment, units, crossings) == nullptr);
  RC_ASSERT(assignment.complete);
  RC_ASSERT(assignment.bound == assignment.pits(units));
  Largest largest(units, crossings);
  const std::uint32_t size = largest.size();
  RC_ASSERT(assignment.chosen.size() >= size);
  if (!largest.gave_up()) RC_ASSERT(assignment.chosen.size() == size);
  RC_ASSERT(solve_assignment(units, crossings, 3).chosen == assignment.chosen);
}

/// An assignment problem that has no terrain. Units without exits are at the end.
struct Problem {
  Problem(std::uint32_t count, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& exits,
          std::vector<ExitPair> pairs)
      : units{count, {}, std::vector<std::uint32_t>(count + std::size_t{1}, 0)}, crossings(surface, {}) {
    for (const auto& [unit, target] : exits) {
      units.exits.push_back({{vertex(0), vertex(1), 0}, unit, target});
      for (std::uint32_t u = unit + 1; u <= count; ++u) ++units.starts[u];
    }
    crossings = Crossings(surface, units.exits);
    crossings.add(pairs);
  }

  const Surface surface = surface_of(support::dammed_valley());
  Units units;
  Crossings crossings;
};

RC_GTEST_PROP(AssignmentLaws, IsALargestOneOfAnyProblem, ()) {
  const std::uint32_t count = 1 + support::random_index(9);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> exits;
  for (std::uint32_t unit = 0; unit < count; ++unit) {
    for (std::uint32_t more = support::random_index(4); more > 0; --more) {
      std::uint32_t target = support::random_index(count);
      if (target == unit || support::random_index(3) == 0) target = kNone;
      exits.emplace_back(unit, target);
    }
  }
  std::vector<ExitPair> pairs;
  for (std::uint32_t i = 0; i < exits.size(); ++i) {
    for (std::uint32_t j = i + 1; j < exits.size(); ++j) {
      if (exits[i].first != exits[j].first && support::random_index(5) == 0) pairs.emplace_back(i, j);
    }
  }
  const Problem problem(count, exits, pairs);
  const Assignment assignment = solve_assignment(problem.units, problem.crossings);
  RC_ASSERT(fault_of(assignment, problem.units, problem.crossings) == nullptr);
  RC_ASSERT(assignment.complete);
  Largest largest(problem.units, problem.crossings);
  RC_ASSERT(assignment.chosen.size() == largest.size());
  RC_ASSERT(!largest.gave_up());
  RC_ASSERT(assignment.bound == count - assignment.chosen.size());
}

/// Each exit crosses the next one: every other unit can be served, and that no more can takes exponential
/// time to see.
TEST(Assignment, GivesUpWithAValidBound) {
  for (const std::uint32_t count : {16u, 60u}) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> exits;
    std::vector<ExitPair> pairs;
    for (std::uint32_t u = 0; u < count; ++u) exits.emplace_back(u, kNone);
    for (std::uint32_t u = 1; u < count; ++u) pairs.emplace_back(u - 1, u);
    const Problem problem(count, exits, pairs);
    const Assignment assignment = solve_assignment(problem.units, problem.crossings);
    EXPECT_EQ(fault_of(assignment, problem.units, problem.crossings), nullptr);
    EXPECT_EQ(assignment.chosen.size(), count / 2);
    EXPECT_EQ(assignment.complete, count == 16);
    EXPECT_EQ(assignment.bound, count == 16 ? 8u : 0u);
  }
}

/// Each unit could take an exit that is in the way of the next one, and had better not. Unit by unit the good
/// exits turn out to be free, for units that are settled are in nobody's way; if all lead to the last unit,
/// as soon as that is settled. Not even a long chain needs a search, which would take exponential time.
TEST(Assignment, SettlesChainsWithoutASearch) {
  constexpr std::uint32_t kLast = 60;
  for (const bool to_last : {false, true}) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> exits;
    std::vector<ExitPair> pairs;
    for (std::uint32_t u = 0; u < kLast; ++u) {
      const std::uint32_t bad = 2 * u, good = bad + 1;
      exits.emplace_back(u, kNone);
      exits.emplace_back(u, to_last ? kLast : kNone);
      if (u > 0) pairs.insert(pairs.end(), {{bad - 2, bad}, {bad - 2, good}});
    }
    exits.emplace_back(kLast, kNone);
    const Problem problem(kLast + 1, exits, pairs);
    const Assignment assignment = solve_assignment(problem.units, problem.crossings);
    EXPECT_TRUE(assignment.complete);
    EXPECT_EQ(assignment.bound, 0u);
    EXPECT_EQ(assignment.chosen.size(), kLast + 1);
  }
}

/// Level exits may lead to a unit that has none itself.
TEST(Assignment, LeadsToUnitsThatStayPits) {
  const Problem problem(3, {{1, 0}, {2, 0}, {2, 1}}, {{0, 1}});
  const Assignment assignment = solve_assignment(problem.units, problem.crossings);
  EXPECT_TRUE(assignment.complete);
  EXPECT_EQ(assignment.bound, 1u);
  EXPECT_EQ(assignment.chosen, (std::vector<std::uint32_t>{0, 2}));
}

/// Three units in a ring of level exits, each of which crosses what leads another ring of three round: two
/// of each ring can be served at most, which the bound knows without a search.
TEST(Assignment, BoundKnowsOfRings) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> exits;
  std::vector<ExitPair> pairs;
  constexpr std::uint32_t kRings = 12;
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t i = 0; i < 3; ++i) exits.emplace_back(3 * ring + i, 3 * ring + (i + 1) % 3);
    if (ring > 0) {
      for (std::uint32_t i = 0; i < 3; ++i) pairs.emplace_back(3 * ring - 3 + i, 3 * ring + i);
    }
  }
  const Problem problem(3 * kRings, exits, pairs);
  const Assignment assignment = solve_assignment(problem.units, problem.crossings);
  EXPECT_EQ(fault_of(assignment, problem.units, problem.crossings), nullptr);
  EXPECT_GE(assignment.bound, kRings);
}

/// The plan is carried out: its exits are edges, and no pit is left but those of units without one.
RC_GTEST_PROP(InsertAssignmentLaws, HasTheChosenExits, ()) {
  const auto cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const unsigned k = support::random_index(7);
  const Plan plan = make_plan(surface, find_exits(surface, k, 1, nullptr), k, Watch());
  RC_ASSERT(plan.crossings.complete());
  RC_ASSERT(plan.bound == std::max(plan.assignment.bound,
                                   static_cast<std::uint32_t>(oracle::reach_bound(
                                       oracle::sites_of(std::span<const Point3>(cloud.points)), k))));
  Watch watch;
  watch.keep_trail = true;
  const auto outcome = insert_assignment(surface, plan, k, watch);
  if (!outcome) {
    RC_ASSERT(k > 1);
    return;
  }
  const thalweg::Triangulation& t = outcome->triangulation;
  RC_ASSERT(!t.find_fault());
  RC_ASSERT(outcome->pits == find_pits(t, surface.z()).size());
  RC_ASSERT(outcome->insertions == outcome->trail.size());
  for (const unsigned order : face_orders(surface.graph(), t, 100)) RC_ASSERT(order <= k);
  for (const auto& step : outcome->trail) {
    RC_ASSERT(t.joined(step.u, step.v));
    RC_ASSERT(!surface.delaunay().joined(step.u, step.v));
    const std::uint32_t pit = surface.pit_of(step.u);
    RC_ASSERT(step.pit ==
              (pit == Surface::kNoPit ? thalweg::VertexId() : surface.lowest(surface.pits()[pit])));
  }
}

}  // namespace
