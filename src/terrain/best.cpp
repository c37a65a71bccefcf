/// The optimum where it can be proved, and the ladder below it.
#include "terrain/best.hpp"

#include <optional>
#include <utility>

#include "terrain/changes.hpp"
#include "terrain/ejection.hpp"
#include "terrain/flip.hpp"
#include "terrain/hull.hpp"

namespace thalweg::detail {
namespace {

std::uint32_t edges_changed(const Surface& surface, const Outcome& outcome) {
  return edge_changes(surface, outcome.triangulation, changed_faces(surface, outcome.triangulation)).changed;
}

/// Keeps in `best` the better of the two: fewer pits, then fewer changed edges, then `best`.
void keep_better(const Surface& surface, Outcome& best, Outcome&& other) {
  const std::uint64_t counts = best.circle_counts + other.circle_counts;
  const bool better = other.pits != best.pits ? other.pits < best.pits
                                              : edges_changed(surface, other) < edges_changed(surface, best);
  if (better) best = std::move(other);
  best.circle_counts = counts;
}

/// Smaller orders that are tried where nothing is proved at larger ones.
constexpr unsigned kMostOrders = 64;

/// The best at k alone.
Outcome best_at(const Surface& surface, std::span<const Exit> exits, const Plan& plan, unsigned k,
                const Watch& watch) {
  std::optional<Outcome> assigned = insert_assignment(surface, plan, k, watch);
  if (assigned && assigned->pits == plan.bound) return *std::move(assigned);

  Outcome best = insert_hulls(surface, exits, k, watch);
  insert_overlapping(surface, exits, k, watch, best);
  if (best.pits > plan.bound) insert_chains(surface, k, watch, best);
  if (best.pits == plan.bound) return best;
  if (watch.stopped()) return best;
  Outcome flips = flip_pits(surface, k, watch);
  insert_overlapping(surface, exits, k, watch, flips);
  if (flips.pits > plan.bound) insert_chains(surface, k, watch, flips);
  keep_better(surface, best, std::move(flips));
  if (assigned) keep_better(surface, best, *std::move(assigned));
  return best;
}

/// Where there were too many crossings to plan with: hulls or flips, nothing more. Both only get better with
/// k.
Outcome plain_best(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch) {
  Outcome best = insert_hulls(surface, exits, k, watch);
  if (watch.stopped()) return best;
  keep_better(surface, best, flip_pits(surface, k, watch));
  return best;
}

}  // namespace

Outcome best_pits(const Surface& surface, std::span<const Exit> exits, const Plan& plan, unsigned k,
                  const Watch& watch) {
  Outcome best = plan.crossings.complete() ? best_at(surface, exits, plan, k, watch)
                                           : plain_best(surface, exits, k, watch);
  // A smaller order can only win while its bound is below what we have, and the bound grows as the order
  // falls.
  unsigned tried = 0;
  for (unsigned lower = k; lower-- > 0 && tried < kMostOrders && !watch.stopped(); ++tried) {
    const auto within = exits_up_to(exits, lower);
    if (best.pits <= reach_bound(surface, within)) break;
    const Plan lower_plan = make_plan(surface, within, lower, watch);
    if (best.pits <= lower_plan.bound) break;
    if (!lower_plan.crossings.complete()) continue;  // plain_best is no better there
    Outcome other = best_at(surface, within, lower_plan, lower, watch);
    if (other.pits < best.pits) keep_better(surface, best, std::move(other));
  }
  return best;
}

}  // namespace thalweg::detail
