/// Fewer triangles over the same region, for pictures of large terrains.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/point.hpp"

namespace thalweg::detail {

using ThinTriangle = std::array<std::uint32_t, 3>;

/// The triangles after taking out vertices, one at a time with its star filled by triangles over the vertices
/// around it, until there are at most `most` or no vertex can go. A vertex stays if keep[v] is not 0 or if it
/// lies on the border. Laws: the same region is covered, all triangles counter-clockwise; triangles of kept
/// vertices alone are all still there. Exact; the result depends on the numbers of vertices. Requires: a
/// triangulation. Complexity: O(n) a round, some ten rounds.
std::vector<ThinTriangle> thin_out(std::span<const Point2> places, std::vector<ThinTriangle> triangles,
                                   std::span<const std::uint8_t> keep, std::size_t most);

}  // namespace thalweg::detail
