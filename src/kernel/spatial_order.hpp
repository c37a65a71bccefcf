/// The order in which the kernel keeps its sites: neighbours in the plane are near each other in memory.
///
/// Morton (Z) order of 16 bits an axis in the bounding box; a cell with more sites than a node of the
/// triangulation likes is ordered again in its own box, a few levels deep, and what is left
/// lexicographically. Every step is monotone in each coordinate, so each bit of a key is a cut of the plane
/// by an axis-parallel line that touches no site.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/array.hpp"
#include "thalweg/point.hpp"

namespace thalweg::detail {

/// Cells with more distinct sites than this are ordered again, in their own box.
inline constexpr std::uint32_t kCellSites = 48;

/// Boxes within boxes: after as many, lexicographic order. Bounds the depth of the cuts by 32 a level,
/// whatever the points.
inline constexpr int kKeyLevels = 4;

/// All points in spatial order: equal points adjacent, the lowest row first among equals.
struct SpatialOrder {
  Array<std::uint32_t> rows;  ///< the caller's row at each position of the order
  std::vector<std::uint32_t>
      starts;                 ///< site s is rows[starts[s] .. starts[s+1]); empty if all points are distinct
  Array<std::uint32_t> keys;  ///< the key of each site in the box of all, ascending
  Array<Point2> sites;        ///< each as its lowest row has it

  bool distinct() const noexcept { return starts.empty(); }
  std::uint32_t site_count() const noexcept { return static_cast<std::uint32_t>(keys.size()); }
  /// The lowest row of site s.
  std::uint32_t first_row(std::uint32_t s) const noexcept { return rows[distinct() ? s : starts[s]]; }
};

/// The points in spatial order.
/// Laws: the order of the distinct sites depends on their coordinates alone, and not on `threads`; it is
/// unchanged by exact translation and by scaling with powers of two. Degenerate: -0.0 equals 0.0. Requires:
/// finite coordinates, fewer than 2^32 points. Complexity: O(n), and a comparison sort within crowded cells
/// of the last level; 24 bytes a point, and up to 70 more where some thousand points or more have keys that
/// agree in their upper halves.
SpatialOrder spatial_order(std::span<const Point2> points, unsigned threads);

/// Writes the keys of the points in their own bounding box: x in the odd bits, y in the even ones, 16 each.
/// Laws: the key of each axis is monotone in its coordinate; the extremes of the longer side get different
/// keys. Requires: finite coordinates, keys as long as points.
void morton_keys(std::span<const Point2> points, std::span<std::uint32_t> keys);

/// x first, then y.
inline bool lexicographically_less(Point2 a, Point2 b) noexcept {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace thalweg::detail
