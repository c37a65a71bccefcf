/// Why each remaining pit is still there.
#pragma once

#include <span>
#include <vector>

#include "terrain/exits.hpp"
#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

struct Explained {
  std::vector<RemainingPit> pits;  ///< vertex ids of the surface, in the order of find_pits
  unsigned order_searched = 0;
};

/// Explains the pits of a result at order k. `exits` are those of the Delaunay pits at order k.
Explained explain_pits(const Surface& surface, const Pits& pits, std::span<const Exit> exits, unsigned k,
                       Method method, const Watch& watch);

}  // namespace thalweg::detail
