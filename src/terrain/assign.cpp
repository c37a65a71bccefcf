/// Inserting an assignment, and what to do when its triangles are of too high an order.
#include "terrain/assign.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/assert.hpp"
#include "kernel/edge_insertion.hpp"
#include "terrain/changes.hpp"
#include "terrain/completion.hpp"
#include "terrain/disjoint_sets.hpp"

namespace thalweg::detail {
namespace {

constexpr std::uint32_t kNoOwner = 0xffffffffu;

/// The constrained Delaunay triangulation with the chosen exits. Inserting them one after another gives it: a
/// sleeve crosses no earlier exit, and a constrained Delaunay triangulation changes only within the sleeve of
/// a new constraint. owner[f], if asked for, becomes the last exit that changed face f.
Outcome insert_all(const Surface& surface, const Units& units, std::span<const std::uint32_t> chosen,
                   const Watch& watch, std::vector<std::uint32_t>* owner = nullptr) {
  Outcome outcome;
  outcome.triangulation = Triangulation::revision_of(surface.delaunay());
  if (owner != nullptr) owner->assign(outcome.triangulation.face_count(), kNoOwner);
  EdgeInsertion insertion;
  for (const std::uint32_t e : chosen) {
    const Exit& exit = units.exits[e].exit;
    if (!insertion.plan(outcome.triangulation, surface.sites(), exit.from, exit.to))
      continue;  // a Delaunay edge
    insertion.apply(outcome.triangulation);
    const std::uint32_t pit = watch.keep_trail ? surface.pit_of(exit.from) : Surface::kNoPit;
    outcome.note_insertion(exit.order, exit.from, exit.to,
                           pit == Surface::kNoPit ? VertexId() : surface.lowest(surface.pits()[pit]),
                           watch.keep_trail);
    if (owner != nullptr) {
      for (const FaceId f : insertion.faces()) (*owner)[f.index()] = e;
    }
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
      : surface_(surface),
        plan_(plan),
        k_(k),
        counter_(surface.graph()),
        work_(Triangulation::revision_of(surface.delaunay())) {}

  std::vector<ExitPair> find() {
    auto pairs = meeting_pairs(surface_, plan_.units.exits).value_or(std::vector<ExitPair>());
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

/// The chosen exits in groups whose hulls meet, those groups alone that own a triangle of an order above k.
std::vector<std::vector<RequiredEdge>> offending_groups(const Surface& surface, const Plan& plan,
                                                        unsigned k) {
  const std::vector<std::uint32_t>& chosen = plan.assignment.chosen;
  std::vector<std::uint32_t> owner;
  const Outcome outcome = insert_all(surface, plan.units, chosen, Watch(), &owner);
  std::vector<UnitExit> exits;
  for (const std::uint32_t e : chosen) exits.push_back(plan.units.exits[e]);
  DisjointSets groups(static_cast<std::uint32_t>(exits.size()));
  const auto meeting = meeting_pairs(surface, exits).value_or(std::vector<ExitPair>());
  for (const auto& [a, b] : meeting) groups.join(a, b);

  std::vector<std::uint8_t> offends(exits.size(), 0);
  CircleCounter counter(surface.graph());
  for (const FaceId f : changed_faces(surface, outcome.triangulation)) {
    if (owner[f.index()] == kNoOwner || counter.order_at_most(k, outcome.triangulation.corners(f))) continue;
    const auto place = std::lower_bound(chosen.begin(), chosen.end(), owner[f.index()]) - chosen.begin();
    offends[groups.find(static_cast<std::uint32_t>(place))] = 1;
  }
  std::vector<std::vector<RequiredEdge>> result(exits.size());
  for (std::uint32_t i = 0; i < exits.size(); ++i) {
    if (offends[groups.find(i)] != 0)
      result[groups.find(i)].push_back({exits[i].exit.from, exits[i].exit.to});
  }
  std::erase_if(result, [](const auto& group) { return group.empty(); });
  return result;
}

/// The chosen exits with another triangulation of their surroundings than the constrained Delaunay one, grown
/// so that its triangles have order <= k, where such a triangulation is found soon.
std::optional<Outcome> insert_grown(const Surface& surface, const Plan& plan, unsigned k,
                                    const Watch& watch) {
  constexpr std::uint64_t kBudget = 10'000;
  Completion completion(surface, k);
  std::vector<std::pair<VertexId, VertexId>> grown;
  for (const std::vector<RequiredEdge>& group : offending_groups(surface, plan, k)) {
    if (completion.find(group, kBudget, watch) != Completion::Answer::found) return std::nullopt;
    grown.insert(grown.end(), completion.edges().begin(), completion.edges().end());
  }
  Outcome outcome = insert_all(surface, plan.units, plan.assignment.chosen, watch);
  EdgeInsertion insertion;
  const auto at = [&](VertexId v) { return surface.sites()[v.index()]; };
  for (const std::pair<VertexId, VertexId>& edge : grown) {
    const VertexId u = edge.first, v = edge.second;
    // What one group has grown may run into another one's exits.
    const bool crosses =
        std::any_of(plan.assignment.chosen.begin(), plan.assignment.chosen.end(), [&](std::uint32_t e) {
          const Exit& exit = plan.units.exits[e].exit;
          return cross_properly(at(u), at(v), at(exit.from), at(exit.to));
        });
    if (crosses) return std::nullopt;
    if (insertion.plan(outcome.triangulation, surface.sites(), u, v)) insertion.apply(outcome.triangulation);
  }
  outcome.circle_counts += completion.circle_counts();
  outcome.pits = find_pits(outcome.triangulation, surface.z()).size();
  if (!is_of_order(surface, k, outcome)) return std::nullopt;
  return outcome;
}

}  // namespace

Plan make_plan(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch) {
  Units units = find_units(surface, exits, k, watch);
  Crossings crossings(surface, units.exits);
  Assignment assignment;
  assignment.complete = false;
  if (crossings.complete()) assignment = solve_assignment(units, crossings, watch.threads);
  const std::uint32_t bound = std::max(assignment.bound, reach_bound(surface, exits));
  return {std::move(units), std::move(crossings), std::move(assignment), bound};
}

std::optional<Outcome> insert_assignment(const Surface& surface, const Plan& plan, unsigned k,
                                         const Watch& watch) {
  Outcome outcome = insert_all(surface, plan.units, plan.assignment.chosen, watch);
  THALWEG_ASSERT(outcome.pits <= plan.assignment.pits(plan.units));
  if (is_of_order(surface, k, outcome)) return outcome;

  if (std::optional<Outcome> grown = insert_grown(surface, plan, k, watch)) {
    if (grown->pits == plan.bound) return grown;
  }
  Crossings apart = plan.crossings;
  apart.add(UneasyPairs(surface, plan, k).find());
  const Assignment again = solve_assignment(plan.units, apart, watch.threads);
  outcome = insert_all(surface, plan.units, again.chosen, watch);
  if (is_of_order(surface, k, outcome)) return outcome;
  return std::nullopt;
}

}  // namespace thalweg::detail
