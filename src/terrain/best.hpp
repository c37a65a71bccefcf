/// The best that is known: the optimum by assignment, with the heuristics behind it.
#pragma once

#include <span>

#include "terrain/assign.hpp"
#include "terrain/exits.hpp"
#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

/// A triangulation of order <= k with as few pits as is known how. By assignment, which is optimal whenever
/// its pits equal the plan's bound; otherwise the best of it and of two combinations: hulls or flips, then
/// overlapping insertions, then ejection chains; and of the same at smaller orders, where those might have
/// fewer pits. Among equal counts the one with fewer changed edges. Never more pits than
/// flip_pits or insert_hulls at k; nor than this at a smaller k, but that it looks no further down than 64
/// orders at which nothing could be proved.
/// Requires: `exits` as find_exits returns them, of order <= k; `plan` made from them.
Outcome best_pits(const Surface& surface, std::span<const Exit> exits, const Plan& plan, unsigned k,
                  const Watch& watch);

}  // namespace thalweg::detail
