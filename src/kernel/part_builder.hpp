/// The parts of divide and conquer: base cases, and the merge along a seam.
#pragma once

#include <cstdint>
#include <span>

#include "kernel/part_arrays.hpp"

namespace thalweg::detail {

/// The direction of a cut. The low side of a cut of x is the left one; of y, the bottom one, which is the
/// left one after a turn of the plane by a quarter clockwise: (x, y) becomes (y, -x). Turning keeps
/// orientation, so one merge serves both.
enum class Axis { x, y };

class SeamSplit;

/// The outermost sites of a part along an axis, ties decided from bottom to top along x and from right to
/// left along y: for the least and the greatest the ghost half-edge of the hull edge that leaves it
/// counter-clockwise (its destination is the site).
struct Extremes {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
};

/// A triangulated part of the sites. One site: its number.
struct Part {
  Extremes along_x, along_y;
  std::uint32_t single = kGhost;

  bool is_single() const noexcept { return single != kGhost; }
  const Extremes& along(Axis axis) const noexcept { return axis == Axis::x ? along_x : along_y; }
};

/// The slots that a merge fills, when its right part begins with site `mid`.
constexpr std::uint32_t slot_at(std::uint32_t mid) noexcept {
  return 2 * mid - 2;
}

/// Where sites are cut: across an axis, and how many are on the low side.
struct Cut {
  Axis axis;
  std::uint32_t low;
};

/// The cut at the first bit in which keys in ascending order differ. Requires: some do. Complexity: O(log n).
Cut cut_of(std::span<const std::uint32_t> keys) noexcept;

/// Triangulates sites [lo, hi), whose keys begin at keys[0]. Calls for different parts can run at the same
/// time. Complexity: O(m log m) for m sites.
Part build_part(const PartArrays& arrays, std::uint32_t lo, std::uint32_t hi, const std::uint32_t* keys);

/// Joins two parts of which the left precedes the right along the axis. Fills slots `slot` and `slot + 1`.
/// With a split of the seam between the two, that is used. Complexity: linear in the triangles that go or
/// come.
Part merge_parts(const PartArrays& arrays, const Part& left, const Part& right, Axis axis, std::uint32_t slot,
                 SeamSplit* split = nullptr);

}  // namespace thalweg::detail
