/// The engine of the Delaunay triangulation: divide and conquer over sites in spatial order.
///
/// Source: Lee and Schachter 1980; Guibas and Stolfi 1985 (the merge); Dwyer 1987 (alternating cuts);
/// Shewchuk 1996 (triangles instead of quad-edges, and ghosts). Departures: the cuts are bits of Morton keys;
/// the merge changes triangles in place, so that nothing is ever allocated or freed; ties are decided by
/// incircle_canonical.
#pragma once

#include <cstdint>
#include <span>

#include "thalweg/array.hpp"
#include "thalweg/point.hpp"

namespace thalweg::detail {

/// A triangulated sphere: the triangles of the plane, and a ghost for each edge of the hull, whose third
/// vertex is kGhost.
///
/// Half-edge 4t+i (i < 3) of slot t runs from its i-th to its next corner. m sites make 2m - 2 triangles,
/// ghosts included; if all sites are collinear there are ghosts only.
struct GhostedTriangulation {
  Array<std::uint32_t> origin;
  Array<std::uint32_t> twin;
  std::uint32_t hull = 0;  ///< the half-edge of some ghost that is on the hull
};

inline constexpr std::uint32_t kGhost = 0xffffffffu;

/// Half-edge numbers are four bytes and a site takes eight of them.
inline constexpr std::uint32_t kMaxSites = 0x1fffffffu;

constexpr std::uint32_t next_of(std::uint32_t h) noexcept {
  return (h & 2) != 0 ? h - 2 : h + 1;
}
constexpr std::uint32_t prev_of(std::uint32_t h) noexcept {
  return (h & 3) == 0 ? h + 2 : h - 1;
}

/// The canonical Delaunay triangulation of the sites.
/// Laws: the arrays depend on the sites alone, not on `threads`.
/// Requires: at least 2 and at most kMaxSites distinct sites in spatial order, with their keys.
/// Complexity: O(n log n); 64 bytes a site.
GhostedTriangulation divide_and_conquer(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                        unsigned threads);

}  // namespace thalweg::detail
