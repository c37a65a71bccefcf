/// The best of several combinations of the heuristics.
#pragma once

#include <span>

#include "terrain/exits.hpp"
#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

/// A triangulation of order <= k with as few pits as the combinations find: hulls and then overlapping
/// insertions; flips and then overlapping insertions; the same at smaller orders, where those might have
/// fewer pits. Among equal counts the one with fewer changed edges. Never more pits than flip_pits or
/// insert_hulls at k, nor than this at a smaller k. Requires: `exits` as find_exits returns them, of order <=
/// k.
Outcome best_pits(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch);

}  // namespace thalweg::detail
