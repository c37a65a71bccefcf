/// The Delaunay triangulation of sites that are in spatial order already: the kernel's own entrance.
#pragma once

#include <cstdint>
#include <span>

#include "thalweg/point.hpp"
#include "thalweg/result.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

/// The canonical Delaunay triangulation of the sites; vertex ids are positions in `sites`.
/// Laws: the numbering of faces and their rotation depend on `sites` alone, not on `threads`.
/// Requires: finite, distinct sites in the order of `spatial_order`.
/// Errors: too_few_points, all_collinear, too_many_points. Complexity: O(n log n), about 70 bytes a site
/// besides `sites`.
Result<Triangulation> delaunay_of_sites(std::span<const Point2> sites, unsigned threads);

/// The same with the keys that `spatial_order` found for these sites.
Result<Triangulation> delaunay_of_sites(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                        unsigned threads);

}  // namespace thalweg::detail
