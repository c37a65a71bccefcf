/// The canonical Delaunay triangulation: checks, order, triangulation, and the way back to packed arrays.
#include "thalweg/delaunay.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kernel/delaunay_sites.hpp"
#include "kernel/divide_and_conquer.hpp"
#include "kernel/huge_pages.hpp"
#include "kernel/parallel.hpp"
#include "kernel/spatial_order.hpp"
#include "kernel/without_ghosts.hpp"

namespace thalweg {
namespace detail {
namespace {

/// What a thread takes at a time.
constexpr std::uint32_t kRowChunk = 1u << 16;

/// The checks, and the engine.
Result<GhostedTriangulation> triangulate(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                         unsigned threads) {
  if (sites.size() < 3) {
    return Error{ErrorCode::too_few_points,
                 "a triangulation needs 3 distinct points, not " + std::to_string(sites.size())};
  }
  if (sites.size() > kMaxSites) {
    return Error{ErrorCode::too_many_points, "at most " + std::to_string(kMaxSites) +
                                                 " points can be triangulated, not " +
                                                 std::to_string(sites.size())};
  }
  return divide_and_conquer(sites, keys, {.threads = resolve_threads(threads)});
}

/// The rows of points with a coordinate that is not finite. (x * 0 is 0 for finite x and NaN for others;
/// adding up keeps a NaN.)
std::vector<std::uint32_t> rows_not_finite(std::span<const Point2> points, unsigned threads) {
  std::atomic<bool> all_finite{true};
  parallel_chunks(points.size(), kRowChunk, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      double x = 0, y = 0;
      for (std::size_t i = begin; i < end; ++i) {
        x += points[i].x * 0;
        y += points[i].y * 0;
      }
      if (!(x + y == 0)) all_finite = false;
    };
  });
  std::vector<std::uint32_t> rows;
  if (all_finite) return rows;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) rows.push_back(i);
  }
  return rows;
}

}  // namespace

Result<Triangulation> delaunay_of_sites(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                        unsigned threads) {
  const KeptPages pages;
  Result<GhostedTriangulation> mesh = triangulate(sites, keys, threads);
  if (!mesh) return std::move(mesh).error();
  return without_ghosts(*std::move(mesh), {}, threads);
}

Result<Triangulation> delaunay_of_sites(std::span<const Point2> sites, unsigned threads) {
  Array<std::uint32_t> keys(sites.size());
  morton_keys(sites, keys);
  return delaunay_of_sites(sites, keys, threads);
}

}  // namespace detail

Result<Triangulation> delaunay(std::span<const Point2> points, const DelaunayOptions& options) {
  if (points.size() >= VertexId::kInvalid) {
    return Error{ErrorCode::too_many_points,
                 std::to_string(points.size()) + " points are more than ids can number"};
  }
  const unsigned threads = detail::resolve_threads(options.threads);
  const detail::TeamScope team(threads);
  const detail::KeptPages pages;
  if (std::vector<std::uint32_t> rows = detail::rows_not_finite(points, threads); !rows.empty()) {
    std::string message =
        std::to_string(rows.size()) + " of the points have a coordinate that is not a finite number";
    return Error{ErrorCode::not_finite, std::move(message), std::move(rows)};
  }
  detail::SpatialOrder order = detail::spatial_order(points, threads);
  if (!order.distinct()) {
    for (std::uint32_t s = 0; s < order.site_count(); ++s) order.rows[s] = order.rows[order.starts[s]];
    order.rows.resize(order.site_count());
    order.starts = std::vector<std::uint32_t>();
  }
  Result<detail::GhostedTriangulation> mesh = detail::triangulate(order.sites, order.keys, threads);
  if (!mesh) return std::move(mesh).error();
  order.sites = detail::Array<Point2>();
  order.keys = detail::Array<std::uint32_t>();
  const detail::VertexNames names{order.rows, static_cast<std::uint32_t>(points.size())};
  return detail::without_ghosts(*std::move(mesh), names, threads);
}

}  // namespace thalweg
