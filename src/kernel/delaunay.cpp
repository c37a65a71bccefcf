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

/// Lets the hull have no twin, and the slots of ghosts begin with kGhost. Returns these slots.
std::vector<std::uint32_t> cut_off_ghosts(GhostedTriangulation& mesh) {
  std::vector<std::uint32_t> slots;
  std::uint32_t h = mesh.hull;
  do {
    slots.push_back(h / 4);
    mesh.origin[h & ~3u] = kGhost;
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
    while (mesh.origin[4 * std::size_t{from}] == kGhost);
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t h = mesh.twin[4 * from + i];
      mesh.origin[4 * to + i] = mesh.origin[4 * from + i];
      mesh.twin[4 * to + i] = h;
      if (h != kNone) mesh.twin[h] = 4 * to + i;
    }
  }
}

/// Three numbers a face from four a slot, each of them converted.
template <class Convert>
Array<std::uint32_t> packed(const Array<std::uint32_t>& slots, std::uint32_t face_count, unsigned threads,
                            Convert&& convert) {
  Array<std::uint32_t> faces(3 * std::size_t{face_count});
  parallel_for(face_count, threads, [&](std::size_t f) {
    for (std::size_t i = 0; i < 3; ++i) faces[3 * f + i] = convert(slots[4 * f + i]);
  });
  return faces;
}

/// For every site the half-edge along the hull that leaves it, or else the first of all that do. Each part of
/// the half-edges has a part of the sites for itself: those that lie where its triangles do.
Array<std::uint32_t> outgoing_of(const Array<std::uint32_t>& origin, const Array<std::uint32_t>& twin,
                                 std::size_t site_count, std::size_t parts) {
  Array<std::uint32_t> outgoing(site_count);
  std::vector<std::vector<std::uint32_t>> strays(parts), hulls(parts);
  parallel_parts(origin.size(), parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
    const std::size_t low = site_count * part / parts, high = site_count * (part + 1) / parts;
    std::fill(outgoing.begin() + static_cast<std::ptrdiff_t>(low),
              outgoing.begin() + static_cast<std::ptrdiff_t>(high), kNone);
    for (auto h = static_cast<std::uint32_t>(end); h-- > begin;) {
      if (origin[h] - low < high - low) {
        outgoing[origin[h]] = h;
      } else {
        strays[part].push_back(h);
      }
      if (twin[h] == kNone) hulls[part].push_back(h);
    }
  });
  for (const auto& stray : strays) {
    for (const std::uint32_t h : stray) outgoing[origin[h]] = std::min(outgoing[origin[h]], h);
  }
  for (const auto& hull : hulls) {
    for (const std::uint32_t h : hull) outgoing[origin[h]] = h;
  }
  return outgoing;
}

/// The triangles alone, packed. One array after the other, so that no more memory is held than there must be.
Triangulation without_ghosts(GhostedTriangulation mesh, unsigned threads) {
  const std::size_t site_count = mesh.origin.size() / 8 + 1;
  const std::vector<std::uint32_t> ghosts = cut_off_ghosts(mesh);
  const auto face_count = static_cast<std::uint32_t>(mesh.origin.size() / 4 - ghosts.size());
  fill_holes(mesh, ghosts, face_count);
  Array<std::uint32_t> origin = packed(mesh.origin, face_count, threads, [](std::uint32_t v) { return v; });
  mesh.origin = Array<std::uint32_t>();  // braces would empty it and keep the memory
  Array<std::uint32_t> twin =
      packed(mesh.twin, face_count, threads, [](std::uint32_t h) { return h == kNone ? kNone : h - h / 4; });
  mesh.twin = Array<std::uint32_t>();
  Array<std::uint32_t> outgoing =
      outgoing_of(origin, twin, site_count, parts_of(face_count, kRowChunk, threads));
  return linked(std::move(origin), std::move(twin), std::move(outgoing));
}

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
  GhostedTriangulation mesh = divide_and_conquer(sites, keys, resolve_threads(threads));
  if (flat(mesh)) return Error{ErrorCode::all_collinear, "all points lie on one line: there is no triangle"};
  return mesh;
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
Array<Point2> gathered(std::span<const Point2> points, std::span<const std::uint32_t> rows,
                       unsigned threads) {
  Array<Point2> sites(rows.size());
  parallel_for(rows.size(), threads, [&](std::size_t i) { sites[i] = points[rows[i]]; });
  return sites;
}

}  // namespace

Result<Triangulation> delaunay_of_sites(std::span<const Point2> sites, std::span<const std::uint32_t> keys,
                                        unsigned threads) {
  Result<GhostedTriangulation> mesh = triangulate(sites, keys, threads);
  if (!mesh) return std::move(mesh).error();
  return without_ghosts(*std::move(mesh), threads);
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
  Result<detail::GhostedTriangulation> mesh =
      detail::triangulate(detail::gathered(points, order.rows, threads), order.keys, threads);
  if (!mesh) return std::move(mesh).error();
  order.keys = detail::Array<std::uint32_t>();
  return detail::without_ghosts(*std::move(mesh), threads)
      .renamed(order.rows, static_cast<std::uint32_t>(points.size()), threads);
}

}  // namespace thalweg
