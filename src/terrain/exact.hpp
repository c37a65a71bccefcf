/// The minimum over all order-k triangulations, by a search that is complete.
#pragma once

#include <cstdint>

#include "terrain/assign.hpp"
#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

struct ExactOutcome {
  Outcome outcome;
  std::uint32_t bound =
      0;  ///< the best bound that is proved; equal to outcome.pits if the search came to its end
};

/// Goes on from `best`, where its pits exceed the bound of the plan, until the optimum is proved or the watch
/// stops it. Requires: `plan` as made at order k; `best` of order <= k.
///
/// The search. A node stands for all order-k triangulations that have certain required edges and lack certain
/// forbidden ones. Some order-k triangulation T' with the required edges is built (completion.hpp); if there
/// is none, the node is empty. Take a pit F of T' that has pairs of useful order <= k left to lower, or to
/// equal other, ground that are not forbidden and cross no required edge. A triangulation of the node either
/// has one of them as an edge, and belongs to the child that requires the first such one and forbids those
/// before it; or it has none, and belongs to the child that forbids them all. Every child requires or forbids
/// more, so the search ends. A pit without such pairs is stuck: in no triangulation of the node does an edge
/// lead out of F, so F holds a pit of each. Stuck pits of one T' are disjoint, hence their number bounds the
/// node from below; so does the assignment bound over the pairs that are left. If all pits of T' are stuck,
/// T' is optimal for its node.
ExactOutcome exact_pits(const Surface& surface, const Plan& plan, Outcome best, unsigned k,
                        const Watch& watch);

}  // namespace thalweg::detail
