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

namespace thalweg {
namespace detail {
namespace {

constexpr std::uint32_t kNone = HalfedgeId::kInvalid;

/// What a thread takes at a time.
constexpr std::uint32_t kRowChunk = 1u << 16;

/// Whether there is no triangle: then, and only then, the hull runs to and fro and ghosts have ghosts behind
/// them.
bool flat(const GhostedTriangulation& mesh) {
  return mesh.origin[prev_of(mesh.twin[mesh.hull])] == kGhost;
}

/// Lets the hull have no twin, marks the slots of ghosts with kGhost in their unused fourth place, and
/// returns these slots.
std::vector<std::uint32_t> cut_off_ghosts(GhostedTriangulation& mesh) {
  std::vector<std::uint32_t> slots;
  std::uint32_t h = mesh.hull;
  do {
    slots.push_back(h / 4);
    mesh.origin[h | 3] = kGhost;
    mesh.twin[mesh.twin[h]] = kNone;
    h = prev_of(mesh.twin[prev_of(h)]);
  } while (h != mesh.hull);
  return slots;
}

/// Moves the last triangles into the slots of ghosts, so that the first `face_count` slots hold the faces.
void fill_holes(GhostedTriangulation& mesh, std::span<const std::uint32_t> ghosts, std::uint32_t face_count) {
  auto from = static_cast<std::uint32_t>(mesh.origin.size() / 4);
  for (const std::uint32_t to : ghosts) {
    if (to >= face_count) continue;
    do --from;
    while (mesh.origin[4 * from + 3] == kGhost);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t h = mesh.twin[4 * from + i];
      mesh.origin[4 * to + i] = mesh.origin[4 * from + i];
      mesh.twin[4 * to + i] = h;
      if (h != kNone) mesh.twin[h] = 4 * to + i;
    }
  }
}

/// From four numbers a slot to three, in place.
void pack(GhostedTriangulation& mesh, std::uint32_t face_count, unsigned threads) {
  const auto pack_origin = [&] {
    for (std::uint32_t f = 0; f < face_count; ++f) {
      for (std::uint32_t i = 0; i < 3; ++i) mesh.origin[3 * f + i] = mesh.origin[4 * f + i];
    }
    mesh.origin.resize(3 * std::size_t{face_count});
  };
  const auto pack_twin = [&] {
    for (std::uint32_t f = 0; f < face_count; ++f) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t h = mesh.twin[4 * f + i];
        mesh.twin[3 * f + i] = h == kNone ? kNone : h - h / 4;
      }
    }
    mesh.twin.resize(3 * std::size_t{face_count});
  };
  // Two arrays, so two threads at most; in place, each must go through its array in order.
  parallel_chunks(2, 1, face_count < kRowChunk ? 1 : threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      for (std::size_t array = begin; array < end; ++array) array == 0 ? pack_origin() : pack_twin();
    };
  });
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

/// The points of the given rows.
std::vector<Point2> gathered(std::span<const Point2> points, std::span<const std::uint32_t> rows,
                             unsigned threads) {
  std::vector<Point2> sites = large_vector<Point2>(rows.size());
  parallel_chunks(rows.size(), kRowChunk, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) sites[i] = points[rows[i]];
    };
  });
  return sites;
}

}  // namespace

Result<Triangulation> delaunay_of_sites(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
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
  threads = resolve_threads(threads);
  GhostedTriangulation mesh = divide_and_conquer(sites, keys, threads);
  if (flat(mesh)) return Error{ErrorCode::all_collinear, "all points lie on one line: there is no triangle"};
  const std::vector<std::uint32_t> ghosts = cut_off_ghosts(mesh);
  const auto face_count = static_cast<std::uint32_t>(mesh.origin.size() / 4 - ghosts.size());
  fill_holes(mesh, ghosts, face_count);
  pack(mesh, face_count, threads);
  return Triangulation::from_arrays(std::move(mesh.origin), std::move(mesh.twin),
                                    static_cast<std::uint32_t>(sites.size()));
}

Result<Triangulation> delaunay_of_sites(std::span<const Point2> sites, unsigned threads) {
  std::vector<std::uint32_t> keys(sites.size());
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
  if (std::vector<std::uint32_t> rows = detail::rows_not_finite(points, threads); !rows.empty()) {
    std::string message =
        std::to_string(rows.size()) + " of the points have a coordinate that is not a finite number";
    return Error{ErrorCode::not_finite, std::move(message), std::move(rows)};
  }
  detail::SpatialOrder order = detail::spatial_order(points, threads);
  if (!order.distinct()) {
    for (std::uint32_t s = 0; s < order.site_count(); ++s) order.rows[s] = order.rows[order.starts[s]];
    order.rows.resize(order.site_count());
    order.starts = {};
  }
  Result<Triangulation> of_sites =
      detail::delaunay_of_sites(detail::gathered(points, order.rows, threads), order.keys, threads);
  if (!of_sites) return of_sites;
  return std::move(*of_sites).renamed(order.rows, static_cast<std::uint32_t>(points.size()));
}

}  // namespace thalweg
