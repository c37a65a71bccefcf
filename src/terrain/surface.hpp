/// The fixed ground on which every heuristic works: sites in spatial order, elevations, the Delaunay
/// triangulation.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "kernel/prefetch.hpp"
#include "thalweg/array.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/pits.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

class Surface {
 public:
  /// Requires: sites distinct, `delaunay` their canonical Delaunay triangulation with the same ids, z of
  /// equal length.
  Surface(Array<Point2> sites, Array<double> z, Triangulation delaunay, unsigned threads = 1);
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  std::span<const Point2> sites() const noexcept { return sites_; }
  std::span<const double> z() const noexcept { return z_; }
  double z(VertexId v) const noexcept { return z_[v.index()]; }
  const Triangulation& delaunay() const noexcept { return delaunay_; }
  const DelaunayGraph& graph() const noexcept { return *graph_; }

  /// Builds the order-k Voronoi diagram of the sites for all counting from now on. Returns what went wrong,
  /// if anything. Requires: 1 <= k <= number of sites; no counter exists yet.
  std::optional<Error> count_by_voronoi(unsigned k, unsigned threads);

  /// Whether u comes before v in elevation order (z, x, y).
  bool lower(VertexId u, VertexId v) const noexcept {
    if (z(u) != z(v)) return z(u) < z(v);
    const Point2 p = sites_[u.index()], q = sites_[v.index()];
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  }
  /// The place of each vertex in elevation order, from 0: the paper's "height normalised to 1 .. n".
  /// Complexity: O(n), and O(m log m) for m sites of nearly one elevation.
  Array<std::uint32_t> ranks(unsigned threads = 1) const;
  /// The least elevation of all.
  double lowest_level() const noexcept { return lowest_level_; }

  /// The pits of the Delaunay triangulation, and the pit that each vertex lies on (kNoPit if none).
  const Pits& pits() const noexcept { return pits_; }
  static constexpr std::uint32_t kNoPit = 0xffffffffu;
  std::uint32_t pit_of(VertexId v) const noexcept { return pit_of_[v.index()]; }
  /// A hint that z(v) and pit_of(v) will be asked for.
  void prefetch_elevation(VertexId v) const noexcept {
    prefetch(&z_[v.index()]);
    prefetch(&pit_of_[v.index()]);
  }

  /// The triangulation that was edited, with nothing of this surface in it any more: one that shares its
  /// arrays with the Delaunay triangulation takes them over.
  Triangulation release(Triangulation edited) &&;

  /// The first of `vertices` in elevation order. Requires: not empty.
  VertexId lowest(std::span<const VertexId> vertices) const noexcept;

 private:
  void note_pits();

  Array<Point2> sites_;
  Array<double> z_;
  Triangulation delaunay_;
  std::optional<DelaunayGraph> graph_;  ///< always there: made at the same time as the pits
  std::optional<OrderKVoronoi> voronoi_;
  Pits pits_;
  Array<std::uint32_t> pit_of_;
  double lowest_level_;
};

}  // namespace thalweg::detail
