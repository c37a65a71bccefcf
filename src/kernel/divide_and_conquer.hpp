/// The engine of the Delaunay triangulation: divide and conquer over sites in spatial order.
///
/// Source: Lee and Schachter 1980; Guibas and Stolfi 1985 (the merge); Dwyer 1987 (alternating cuts);
/// Shewchuk 1996 (triangles instead of quad-edges, and ghosts). Departures: the cuts are bits of Morton keys;
/// the merge changes triangles in place, so that none is ever allocated or freed; long merges are begun at
/// several edges at once (SeamSplit); ties are decided by incircle_canonical.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/ghosted_triangulation.hpp"
#include "thalweg/point.hpp"

namespace thalweg::detail {

/// Half-edge numbers are four bytes and a site takes eight of them.
inline constexpr std::uint32_t kMaxSites = 0x1fffffffu;

/// How the work is shared. By default so that small sets are not cut in pieces, nor merges that are soon
/// done.
struct Sharing {
  unsigned threads = 1;
  std::uint32_t least_piece = 1u << 12;  ///< sites of a piece, at least; 6 or more, which are no more cut
  std::size_t least_edges = 8;           ///< so many of edges_across make a merge worth a SeamSplit
};

/// The canonical Delaunay triangulation of the sites.
/// Laws: the arrays depend on the sites alone, not on `sharing`.
/// Requires: at least 2 and at most kMaxSites distinct sites in spatial order, with their keys.
/// Complexity: O(n log n); 64 bytes a site.
GhostedTriangulation divide_and_conquer(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                        const Sharing& sharing);

}  // namespace thalweg::detail
