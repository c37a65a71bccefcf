/// The optimum by assignment: choose exits, insert them all, look whether the triangles are of order k.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "terrain/assignment.hpp"
#include "terrain/crossings.hpp"
#include "terrain/exits.hpp"
#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"
#include "terrain/units.hpp"

namespace thalweg::detail {

/// The problem of choosing exits at one order, solved without regard to the order of the triangles.
struct Plan {
  Units units;
  Crossings crossings;
  Assignment assignment;
  std::uint32_t bound =
      0;  ///< the best valid bound: of the assignment, and the reach bound where its search was cut short
};

/// Requires: `exits` as find_exits returns them, of order <= k.
Plan make_plan(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch);

/// The Delaunay triangulation constrained to the exits chosen by the plan, if all its triangles have order <=
/// k. Where they have not, exits that do not get on with each other are kept apart, and the assignment is
/// solved again. When the pits of the result equal the bound, it is optimal: no order-k triangulation has
/// fewer. Requires: the plan knows all crossings.
///
/// At order 1, in general position, this never fails. A pair of useful order 1 crosses one Delaunay edge
/// (sleeve_search.hpp: no more than one site on either side), so its hull is a quadrilateral of two triangles
/// whose diagonal it replaces. If two such hulls share a triangle, both pairs run from corners of it through
/// the opposite sides, and cross. Chosen exits do not cross, so their hulls share nothing, and every triangle
/// is one of a single insertion: of order 1. The flip rule alone finds this optimum in general position in
/// every set that was enumerated, but not always where ground is level or sites are collinear: a flip that
/// gains nothing can block one that does.
std::optional<Outcome> insert_assignment(const Surface& surface, const Plan& plan, unsigned k,
                                         const Watch& watch);

}  // namespace thalweg::detail
