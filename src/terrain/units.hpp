/// Units: what has to choose an exit, for the assignment bound and for the optimum by assignment.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "terrain/exits.hpp"
#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

/// Where an exit of a unit leads.
struct UnitExit {
  Exit exit;
  std::uint32_t unit;
  std::uint32_t
      target;  ///< the unit at its other end, or Units::kGround: lower ground, or level ground that drains
};

/// The units at order k and their exits.
///
/// Let A be the exits of the Delaunay pits and X the Delaunay edges that they cross. A unit is a set of
/// vertices of equal height joined by Delaunay edges not in X, unless an edge not in X leads from it to lower
/// ground: then it drains whatever is chosen, and is dropped. The exits of all units join A, until nothing
/// changes. Units are all the pits, the vertices that drain but may be cut off
/// ("victims"), and the pieces into which a flat may be cut.
struct Units {
  static constexpr std::uint32_t kGround = 0xffffffffu;

  std::uint32_t count = 0;
  std::vector<UnitExit>
      exits;  ///< by unit, then as exits are sorted; units in elevation order of their lowest vertices
  std::vector<std::uint32_t> starts;  ///< exits of unit u: [starts[u], starts[u + 1])

  std::span<const UnitExit> of(std::uint32_t unit) const noexcept {
    return std::span(exits).subspan(starts[unit], starts[unit + 1] - starts[unit]);
  }
};

/// Requires: `exits` as find_exits returns them, of order <= k. Complexity: a few rounds, each proportional
/// to the exits.
Units find_units(const Surface& surface, std::span<const Exit> exits, unsigned k, const Watch& watch);

}  // namespace thalweg::detail
