/// Edges that will join two parts, known before the parts are merged.
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/part_arrays.hpp"

namespace thalweg::detail {

/// Two parts that are to be merged: sites [lo, mid) on the left, and [mid, hi).
struct TwoParts {
  std::uint32_t lo, mid, hi;

  bool in_left(std::uint32_t site) const noexcept { return site < mid; }
};

struct EdgeAcross {
  std::uint32_t left, right;
};

/// Some edges that every Delaunay triangulation of all sites has, from the bottom of the seam to its top,
/// both ends of each on the hull of its part: those found at a few dozen evenly spaced sites. They are many
/// only if as large a share of all sites is to get such an edge, as of sites on a convex curve; then the
/// merge is long.
///
/// An edge from p on the left to q on the right is certain if some circle through both has no neighbour of p
/// in the left part and none of q in the right one in or on it: if it held any other site of the left part,
/// shrink it towards p until it holds none; what is on it then and next to p is a neighbour of p, and was
/// inside.
///
/// Rounding decides what is tried, never what is returned. Complexity: O(number of sites), and usually far
/// less.
std::vector<EdgeAcross> edges_across(const PartArrays& mesh, const TwoParts& parts);

/// A half-edge that leaves the site, or kGhost if there is none in the slots near twice its number, which is
/// seldom.
std::uint32_t halfedge_near(const PartArrays& mesh, const TwoParts& parts, std::uint32_t site) noexcept;

}  // namespace thalweg::detail
