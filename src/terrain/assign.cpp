/// Inserting an assignment, and what to do when its triangles are of too high an order.
#include "terrain/assign.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/assert.hpp"
#include "kernel/edge_insertion.hpp"
#include "terrain/changes.hpp"

namespace thalweg::detail {
namespace {

/// The constrained Delaunay triangulation with the chosen exits. Inserting them one after another gives it: a
/// sleeve crosses no earlier exit, and a constrained Delaunay triangulation changes only within the sleeve of
/// a new constraint.
Outcome insert_all(const Surface& surface, const Units& units, std::span<const std::uint32_t> chosen,
                   const Watch& watch) {
  Outcome outcome;
  outcome.triangulation = surface.delaunay();
  EdgeInsertion insertion;
  for (const std::uint32_t e : chosen) {
    const Exit& exit = units.exits[e].exit;
    if (!insertion.plan(outcome.triangulation, surface.sites(), exit.from, exit.to))
      continue;  // a Delaunay edge
    insertion.apply(outcome.triangulation);
    ++outcome.insertions;
    if (!watch.keep_trail) continue;
    const std::uint32_t pit = surface.pit_of(exit.from);
    outcome.trail.push_back({TrailStep::Kind::insertion, exit.order, exit.from, exit.to, VertexId(),
                             VertexId(),
                             pit == Surface::kNoPit ? VertexId() : surface.lowest(surface.pits()[pit])});
  }
  outcome.pits = find_pits(outcome.triangulation, surface.z()).size();
  return outcome;
}

bool is_of_order(const Surface& surface, unsigned k, Outcome& outcome) {
  CircleCounter counter(surface.graph());
  const auto changed = changed_faces(surface, outcome.triangulation);
  const bool result = std::all_of(changed.begin(), changed.end(), [&](FaceId f) {
    return counter.order_at_most(k, outcome.triangulation.corners(f));
  });
  outcome.circle_counts += counter.calls();
  return result;
}

/// Pairs of exits that do not cross but whose hulls meet, and that, inserted together, give a triangle of an
/// order above k. Heuristic: another triangulation with both might do, so nothing is proved by these pairs.
class UneasyPairs {
 public:
  UneasyPairs(const Surface& surface, const Plan& plan, unsigned k)
      : surface_(surface), plan_(plan), k_(k), counter_(surface.graph()), work_(surface.delaunay()) {}

  std::vector<std::pair<std::uint32_t, std::uint32_t>> find() {
    auto pairs = meeting_pairs(surface_, plan_.units.exits);
    std::erase_if(pairs, [&](const auto& pair) { return !is_uneasy(pair.first, pair.second); });
    return pairs;
  }

 private:
  bool is_uneasy(std::uint32_t a, std::uint32_t b) {
    const UnitExit &first = plan_.units.exits[a], &second = plan_.units.exits[b];
    const auto crossing = plan_.crossings.of(a);
    if (first.unit == second.unit || std::binary_search(crossing.begin(), crossing.end(), b)) return false;
    if (!one_.plan(work_, surface_.sites(), first.exit.from, first.exit.to)) return false;
    one_.apply(work_);
    bool uneasy = false;
    if (two_.plan(work_, surface_.sites(), second.exit.from, second.exit.to)) {
      uneasy = std::any_of(two_.triangles().begin(), two_.triangles().end(),
                           [&](const Triangle& t) { return !counter_.order_at_most(k_, t); });
    }
    one_.undo(work_);
    return uneasy;
  }

  const Surface& surface_;
  const Plan& plan_;
  unsigned k_;
  CircleCounter counter_;
  Triangulation work_;
  EdgeInsertion one_, two_;
};

}  // namespace

Plan make_plan(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch) {
  Units units = find_units(surface, exits, k, watch);
  Crossings crossings(surface, units.exits);
  Assignment assignment = solve_assignment(units, crossings);
  const std::uint32_t bound = std::max(assignment.bound, reach_bound(surface, exits));
  return {std::move(units), std::move(crossings), std::move(assignment), bound};
}

std::optional<Outcome> insert_assignment(const Surface& surface, const Plan& plan, unsigned k,
                                         const Watch& watch) {
  Outcome outcome = insert_all(surface, plan.units, plan.assignment.chosen, watch);
  THALWEG_ASSERT(outcome.pits <= plan.assignment.pits(plan.units));
  if (is_of_order(surface, k, outcome)) return outcome;

  Crossings apart = plan.crossings;
  apart.add(UneasyPairs(surface, plan, k).find());
  const Assignment again = solve_assignment(plan.units, apart);
  outcome = insert_all(surface, plan.units, again.chosen, watch);
  if (is_of_order(surface, k, outcome)) return outcome;
  return std::nullopt;
}

}  // namespace thalweg::detail
