/// From the caller's rows to distinct sites with one elevation each.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "thalweg/array.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::detail {

/// The sites in spatial order, and the way back to rows.
struct MergedSites {
  Array<Point2> xy;
  Array<double> z;
  Array<std::uint32_t> keys;                                      ///< as spatial_order gives them
  Array<std::uint32_t> row;                                       ///< the row that stands for each site
  std::vector<std::pair<std::uint32_t, std::uint32_t>> merged;    ///< see Minimized::merged
  std::vector<std::pair<std::uint32_t, double>> mean_elevations;  ///< see Minimized::mean_elevations
};

/// Sorts the points and merges those of equal (x, y) by the policy. Of several rows that the policy likes as
/// much the first stands for the site. Errors: not_finite; duplicate_points under DuplicatePolicy::error;
/// too_many_points.
Result<MergedSites> merge_sites(std::span<const Point3> points, DuplicatePolicy policy, unsigned threads);

}  // namespace thalweg::detail
