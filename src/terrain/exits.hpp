/// Exits: the pairs of useful order <= k by which a pit could drain; and what follows from them without any
/// search.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "terrain/surface.hpp"

namespace thalweg::detail {

/// A pair from a vertex of a pit to strictly lower ground, or to equal ground outside the pit.
struct Exit {
  VertexId from, to;
  unsigned order = 0;
};

/// All exits of the Delaunay pits of useful order at most k, by (order, elevation order of from, of to).
/// Since the order of a pair depends on the sites alone, the exits at a smaller k are a prefix. Ties are
/// broken by elevation order, which is an order of coordinates (z, x, y), so that in general position the
/// result does not even depend on how the axes lie. Complexity: O(pit vertices) walks, in parallel. Stops
/// early once *cancel is true; what it returns is then of no meaning.
std::vector<Exit> find_exits(const Surface& surface, unsigned k, unsigned threads,
                             const std::atomic<bool>* cancel);

/// The exits of useful order at most k: a prefix of `exits`, which must be sorted as above.
std::span<const Exit> exits_up_to(std::span<const Exit> exits, unsigned k);

/// The reach bound at order k from the exits at order k: join pits by equal-height exits; the number of
/// joined groups that have no exit to strictly lower ground, nor to equal ground that drains. No order-k
/// triangulation has fewer pits: in it, each such group is a union of whole flats with no lower neighbour,
/// and holds a pit.
std::uint32_t reach_bound(const Surface& surface, std::span<const Exit> exits);

/// The least useful order of an exit of each flat, looked for only where it is worth the time.
struct LeastOrders {
  unsigned searched = 0;                         ///< exits up to this order were looked for
  std::vector<std::optional<unsigned>> of_flat;  ///< one a flat
};

/// The least order of an exit of each of `flats` (sets of vertices of equal height), none of which has one of
/// order <= known. Doubles the order searched while the next doubling is expected to keep within a fixed
/// number of steps in all: the depth depends on the terrain, never on the clock or the number of threads.
LeastOrders least_exit_orders(const Surface& surface, const std::vector<std::vector<VertexId>>& flats,
                              unsigned known, unsigned threads, const std::atomic<bool>* cancel);

}  // namespace thalweg::detail
