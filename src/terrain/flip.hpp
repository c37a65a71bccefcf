/// The flip heuristic (de Kok, van Kreveld, Loeffler, section 3).
#pragma once

#include <vector>

#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

/// Flips until no diagonal can be replaced by one from the lowest corner of its convex quadrilateral to the
/// opposite corner with both new triangles of order <= k; lower orders first, as in the paper's rounds k' = 1
/// .. k. If `pits_at` is given, it receives the number of pits at every order 0 .. k: the rounds do not look
/// ahead, so the run at k passes through the results of all smaller orders.
///
/// Departures from the paper: a candidate's order depends on its corners alone and is counted once, then
/// waits in the bucket of that order; "lowest" is in elevation order (z, x, y), which ranks ties. Within a
/// round candidates are taken in waves, each sorted by the ranks of the new edge, so that the result depends
/// on the terrain alone. Complexity: O(nk) flips (Lemma 5), about 5 circle counts a site in all on real
/// terrain at k = 8.
Outcome flip_pits(const Surface& surface, unsigned k, const Watch& watch,
                  std::vector<std::uint32_t>* pits_at = nullptr);

}  // namespace thalweg::detail
