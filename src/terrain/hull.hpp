/// The hull heuristic (de Kok, van Kreveld, Loeffler, section 4), and insertions that overlap.
#pragma once

#include <span>
#include <vector>

#include "terrain/exits.hpp"
#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

/// Inserts exits of useful order <= k, lower orders first, each with the constrained Delaunay triangulation
/// of its hull, whenever its pit is still there, its hull does not touch an earlier one and the number of
/// pits falls. The result has order <= k. If `pits_at` is given, it receives the number of pits at every
/// order 0 .. k: exits at a smaller order are a prefix, so the run at k passes through the results of all
/// smaller orders.
///
/// Departures from the paper: candidates are searched from pits only; hulls are kept apart by locking their
/// triangles, which is the same as marking their edges: a sleeve that crosses a marked or non-Delaunay edge
/// contains a locked triangle, and the other way round; and an insertion has to pay, because it can make a
/// pit of a vertex that drained through one of the edges that it removes. Requires: `exits` as find_exits
/// returns them, of order <= k.
Outcome insert_hulls(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch,
                     std::vector<std::uint32_t>* pits_at = nullptr);

/// Goes on from any triangulation of order <= k: inserts exits whose hulls may cross earlier ones, whenever
/// all new triangles have order <= k and the number of pits falls; again from the start until nothing more is
/// gained.
void insert_overlapping(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch,
                        Outcome& outcome);

}  // namespace thalweg::detail
