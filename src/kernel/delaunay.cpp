/// The canonical Delaunay triangulation: checks, order, triangulation, and the way back to packed arrays.
#include "thalweg/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "kernel/delaunay_sites.hpp"
#include "kernel/divide_and_conquer.hpp"
#include "kernel/spatial_order.hpp"

namespace thalweg {
namespace detail {
namespace {

constexpr std::uint32_t kNone = HalfedgeId::kInvalid;

/// Whether there is no triangle: then, and only then, the hull runs to and fro and ghosts have ghosts behind
/// them.
bool flat(const GhostedTriangulation& mesh) {
  return mesh.origin[prev_of(mesh.twin[mesh.hull])] == kGhost;
}

/// Lets the hull have no twin, and returns the slots of the ghosts, ascending.
std::vector<std::uint32_t> cut_off_ghosts(GhostedTriangulation& mesh) {
  std::vector<std::uint32_t> slots;
  std::uint32_t h = mesh.hull;
  do {
    slots.push_back(h / 4);
    mesh.twin[mesh.twin[h]] = kNone;
    h = prev_of(mesh.twin[prev_of(h)]);
  } while (h != mesh.hull);
  std::sort(slots.begin(), slots.end());
  return slots;
}

/// Moves the last triangles into the slots of ghosts, so that the first `face_count` slots hold the faces.
void fill_holes(GhostedTriangulation& mesh, std::span<const std::uint32_t> ghosts, std::uint32_t face_count) {
  auto last_ghost = ghosts.end();
  auto from = static_cast<std::uint32_t>(mesh.origin.size() / 4);
  for (const std::uint32_t to : ghosts) {
    if (to >= face_count) return;
    for (--from; *(last_ghost - 1) == from; --from) --last_ghost;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t h = mesh.twin[4 * from + i];
      mesh.origin[4 * to + i] = mesh.origin[4 * from + i];
      mesh.twin[4 * to + i] = h;
      if (h != kNone) mesh.twin[h] = 4 * to + i;
    }
  }
}

/// From four numbers a slot to three, and from numbers of sites to the names of vertices, if any.
void pack(GhostedTriangulation& mesh, std::uint32_t face_count, std::span<const std::uint32_t> names) {
  for (std::uint32_t f = 0; f < face_count; ++f) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.origin[4 * f + i];
      const std::uint32_t h = mesh.twin[4 * f + i];
      mesh.origin[3 * f + i] = names.empty() ? v : names[v];
      mesh.twin[3 * f + i] = h == kNone ? kNone : h - h / 4;
    }
  }
  mesh.origin.resize(3 * std::size_t{face_count});
  mesh.twin.resize(3 * std::size_t{face_count});
}

/// delaunay_of_sites; site s is called names[s], of vertex_count vertices.
Result<Triangulation> triangulate(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                  std::span<const std::uint32_t> names, std::uint32_t vertex_count,
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
  if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
  GhostedTriangulation mesh = divide_and_conquer(sites, keys, threads);
  if (flat(mesh)) return Error{ErrorCode::all_collinear, "all points lie on one line: there is no triangle"};
  const std::vector<std::uint32_t> ghosts = cut_off_ghosts(mesh);
  const auto face_count = static_cast<std::uint32_t>(mesh.origin.size() / 4 - ghosts.size());
  fill_holes(mesh, ghosts, face_count);
  pack(mesh, face_count, names);
  return Triangulation::from_arrays(std::move(mesh.origin), std::move(mesh.twin), vertex_count);
}

std::vector<std::uint32_t> rows_not_finite(std::span<const Point2> points) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) rows.push_back(i);
  }
  return rows;
}

}  // namespace

Result<Triangulation> delaunay_of_sites(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                        unsigned threads) {
  return triangulate(sites, keys, {}, static_cast<std::uint32_t>(sites.size()), threads);
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
  if (std::vector<std::uint32_t> rows = detail::rows_not_finite(points); !rows.empty()) {
    std::string message =
        std::to_string(rows.size()) + " of the points have a coordinate that is not a finite number";
    return Error{ErrorCode::not_finite, std::move(message), std::move(rows)};
  }
  detail::SpatialOrder order = detail::spatial_order(points, options.threads);
  if (!order.distinct()) {
    for (std::uint32_t s = 0; s < order.site_count(); ++s) order.rows[s] = order.rows[order.starts[s]];
    order.rows.resize(order.site_count());
    order.starts = {};
  }
  std::vector<Point2> sites(order.site_count());
  for (std::uint32_t s = 0; s < order.site_count(); ++s) sites[s] = points[order.rows[s]];
  return detail::triangulate(sites, order.keys, order.rows, static_cast<std::uint32_t>(points.size()),
                             options.threads);
}

}  // namespace thalweg
