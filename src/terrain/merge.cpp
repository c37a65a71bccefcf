/// Duplicates, by policy.
#include "terrain/merge.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>

#include "kernel/huge_pages.hpp"
#include "kernel/parallel.hpp"
#include "kernel/spatial_order.hpp"

namespace thalweg::detail {
namespace {

constexpr std::size_t kNamedRows = 10;

bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// The first rows that hold a NaN or an infinity.
Result<bool> require_finite(std::span<const Point3> points, unsigned threads) {
  std::atomic<bool> all_finite{true};
  parallel_for(points.size(), threads, [&](std::size_t i) {
    if (!is_finite(points[i])) all_finite.store(false, std::memory_order_relaxed);
  });
  if (all_finite) return true;
  Error error{ErrorCode::not_finite, "", {}};
  for (std::size_t i = 0; i < points.size() && error.rows.size() < kNamedRows; ++i) {
    if (!is_finite(points[i])) error.rows.push_back(static_cast<std::uint32_t>(i));
  }
  error.message = "row " + std::to_string(error.rows[0]) + " holds a coordinate that is NaN or infinite";
  return error;
}

/// The row of the group that stands for it. Rows of a group ascend.
std::uint32_t chosen_row(std::span<const Point3> points, std::span<const std::uint32_t> group,
                         DuplicatePolicy policy) {
  const auto less_z = [&](std::uint32_t a, std::uint32_t b) { return points[a].z < points[b].z; };
  switch (policy) {
    case DuplicatePolicy::lowest:
      return *std::min_element(group.begin(), group.end(), less_z);
    case DuplicatePolicy::highest:
      return *std::max_element(group.begin(), group.end(), less_z);
    case DuplicatePolicy::last:
      return group.back();
    case DuplicatePolicy::first:
    case DuplicatePolicy::mean:
    case DuplicatePolicy::error:
      break;
  }
  return group.front();
}

/// The mean elevation of a group. Summed in ascending order, so that the order of rows does not show in the
/// last bit.
double mean_z(std::span<const Point3> points, std::span<const std::uint32_t> group) {
  std::vector<double> z;
  for (const std::uint32_t row : group) z.push_back(points[row].z);
  std::sort(z.begin(), z.end());
  if (z.front() == z.back()) return z.front();
  const auto count = static_cast<double>(z.size());
  double sum = 0, sum_of_parts = 0;
  for (const double value : z) {
    sum += value;
    sum_of_parts += value / count;
  }
  // Rounding may carry a mean past the values that it lies between.
  return std::clamp(std::isfinite(sum) ? sum / count : sum_of_parts, z.front(), z.back());
}

void merge_group(std::span<const Point3> points, std::span<const std::uint32_t> group, DuplicatePolicy policy,
                 MergedSites& sites) {
  const std::uint32_t row = chosen_row(points, group, policy);
  sites.row.push_back(row);
  sites.xy.push_back({points[row].x, points[row].y});
  sites.z.push_back(points[row].z);
  if (group.size() == 1) return;
  for (const std::uint32_t other : group) {
    if (other != row) sites.merged.emplace_back(other, row);
  }
  if (policy == DuplicatePolicy::mean) {
    sites.z.back() = mean_z(points, group);
    if (sites.z.back() != points[row].z) sites.mean_elevations.emplace_back(row, sites.z.back());
  }
}

Error duplicate_error(std::span<const std::uint32_t> group) {
  return {ErrorCode::duplicate_points,
          "rows " + std::to_string(group[0]) + " and " + std::to_string(group[1]) + " have the same x and y",
          {group.begin(), group.end()}};
}

}  // namespace

Result<MergedSites> merge_sites(std::span<const Point3> points, DuplicatePolicy policy, unsigned threads) {
  if (points.size() >= VertexId::kInvalid) {
    return Error{ErrorCode::too_many_points,
                 std::to_string(points.size()) + " points are more than 32-bit ids can number",
                 {}};
  }
  if (auto finite = require_finite(points, threads); !finite) return std::move(finite).error();

  MergedSites sites;
  {
    const KeptPages pages;
    Array<Point2> xy(points.size());
    parallel_for(points.size(), threads, [&](std::size_t i) { xy[i] = {points[i].x, points[i].y}; });
    SpatialOrder order = spatial_order(xy, threads);
    const std::uint32_t count = order.site_count();
    if (order.distinct()) {
      sites.row = std::move(order.rows);
      sites.xy = std::move(order.sites);
      sites.z = Array<double>(count);
      parallel_for(count, threads, [&](std::size_t s) { sites.z[s] = points[sites.row[s]].z; });
    } else {
      sites.row.reserve(count);
      sites.xy.reserve(count);
      sites.z.reserve(count);
      for (std::uint32_t s = 0; s < count; ++s) {
        const std::span<const std::uint32_t> group =
            std::span(order.rows).subspan(order.starts[s], order.starts[s + 1] - order.starts[s]);
        if (group.size() > 1 && policy == DuplicatePolicy::error) return duplicate_error(group);
        merge_group(points, group, policy, sites);
      }
      std::sort(sites.merged.begin(), sites.merged.end());
      std::sort(sites.mean_elevations.begin(), sites.mean_elevations.end());
    }
    sites.keys = std::move(order.keys);
  }
  return sites;
}

}  // namespace thalweg::detail
