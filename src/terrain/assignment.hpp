/// The assignment: one exit for as many units as can be, without crossings and without cycles. It is a bound
/// and a plan in one.
#pragma once

#include <cstdint>
#include <vector>

#include "terrain/crossings.hpp"
#include "terrain/units.hpp"

namespace thalweg::detail {

/// An assignment M of at most one exit to each unit: no two of them cross, and no cycle of units follows its
/// exits round.
///
/// It bounds from below. Take any order-k triangulation T and join units by its level edges. A joined group
/// in which no unit has an edge of T to lower ground holds at least one pit; orient a spanning tree of it
/// towards one of its units, and all others have an exit of their own. In a group with a way down, a spanning
/// tree towards that way gives every unit one. These exits are edges of T, so they do not cross and have
/// useful order <= k, and trees have no cycles: they are an assignment, and T has at least as many pits as
/// units without an exit. Hence T has at least #units - max |M| pits; units that were dropped only make it
/// more.
///
/// It is attained. Insert the exits of M as constraints into the Delaunay triangulation: only edges that they
/// cross vanish, all of them in X. No dropped unit loses its way down, which avoids X; no unit falls apart,
/// as it holds together by edges not in X; and from every unit of M the exits lead, without a cycle, to lower
/// ground or to a unit without exit. So the pits are at most #units - |M|. Only the order of the triangles
/// remains to be seen.
struct Assignment {
  std::vector<std::uint32_t> chosen;  ///< indices of exits, one a served unit, ascending
  std::uint32_t bound = 0;            ///< no order-k triangulation has fewer pits
  bool complete = true;               ///< chosen is as large as any: #units - chosen.size() == bound

  /// The pits of the triangulation that the chosen exits give.
  std::uint32_t pits(const Units& units) const noexcept {
    return units.count - static_cast<std::uint32_t>(chosen.size());
  }
};

/// A largest assignment, or, where a component of the problem needs more than its budget of steps, a large
/// one with a smaller valid bound. Among largest ones exits of small order are preferred, unit by unit.
/// Deterministic. Complexity: near-linear for the units that kernelisation settles (all but a few on real
/// terrain), exponential at worst within a component, but bounded by the budget.
Assignment solve_assignment(const Units& units, const Crossings& crossings, unsigned threads = 1);

}  // namespace thalweg::detail
