/// Counting the sites inside a circle, and with it the order of a triangle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "thalweg/array.hpp"
#include "thalweg/export.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"
#include "thalweg/voronoi_counter.hpp"

namespace thalweg {

/// The sites with their Delaunay neighbours, packed for graph searches. Immutable: safe for concurrent
/// readers. Memory: about 28 bytes a site beside the sites, which are referred to, not copied.
class THALWEG_EXPORT DelaunayGraph {
 public:
  /// Requires: `delaunay` is a Delaunay triangulation of `sites` (any of them where sites are cocircular);
  /// vertex v lies at sites[v]; both outlive the graph. Isolated vertices have no neighbours and are never
  /// counted. Complexity: O(n).
  DelaunayGraph(std::span<const Point2> sites, const Triangulation& delaunay);

  /// The sites that the graph was made of: the caller's memory.
  std::span<const Point2> sites() const noexcept { return sites_; }
  /// The place of v. Requires: v < sites().size(), here and below.
  Point2 point(VertexId v) const noexcept { return sites_[v.index()]; }
  /// The Delaunay neighbours of v, counter-clockwise; none for an isolated vertex. Complexity: O(1).
  std::span<const VertexId> neighbors(VertexId v) const noexcept {
    return std::span(neighbors_).subspan(starts_[v.index()], starts_[v.index() + 1] - starts_[v.index()]);
  }
  /// The triangulation that the graph was made of: the caller's.
  const Triangulation& delaunay() const noexcept { return *delaunay_; }

  /// From now on counters made for this graph answer by point location in the diagram whatever it is deep
  /// enough for: limits less than its order. The answers are the same. Requires: the order-k Voronoi diagram
  /// of the same sites in the same order; it outlives the graph; no counter of this graph exists yet.
  void count_by(const OrderKVoronoi& diagram) noexcept { voronoi_ = &diagram; }
  /// The diagram that `count_by` was given, or null.
  const OrderKVoronoi* voronoi() const noexcept { return voronoi_; }

 private:
  std::span<const Point2> sites_;
  const Triangulation* delaunay_;
  detail::Array<std::uint32_t> starts_;
  detail::Array<VertexId> neighbors_;
  const OrderKVoronoi* voronoi_ = nullptr;
};

/// Counts sites in circles by a search of the Delaunay graph, or by point location if the graph says so.
/// Holds scratch memory of 4 bytes a site: one per thread.
class THALWEG_EXPORT CircleCounter {
 public:
  /// Requires: `graph` outlives the counter. Complexity: O(n), for the scratch memory.
  explicit CircleCounter(const DelaunayGraph& graph);

  /// The number of sites strictly inside the circle through u, v, w, or limit + 1 if there are more than
  /// `limit`. Degenerate: sites on the circle do not count. Requires: u, v, w counter-clockwise. Exact.
  /// Complexity: about 6 (limit + 1) incircle tests, whatever the number of sites; fewer by some for each
  /// site in `known`: any that the caller knows to be strictly inside, repeated or not. Source: the sites in
  /// a disk induce a connected part of the Delaunay graph; proof in src/order/circle_count.cpp.
  unsigned count_in_circle(VertexId u, VertexId v, VertexId w, unsigned limit,
                           std::span<const VertexId> known = {});

  /// The sites that the last `count_in_circle` found inside: all of them, if they were not more than its
  /// limit. Requires: it has been called.
  std::span<const VertexId> inside() const noexcept { return std::span(queue_).subspan(1, inside_count_); }

  /// Whether the triangle has order at most k. Requires: counter-clockwise. Exact. Complexity: as
  /// count_in_circle.
  bool order_at_most(unsigned k, const Triangle& t) { return count_in_circle(t[0], t[1], t[2], k) <= k; }

  /// How often `count_in_circle` was called.
  std::uint64_t calls() const noexcept { return calls_; }

 private:
  void make_room(std::size_t size);
  unsigned crawl(VertexId u, VertexId v, VertexId w, unsigned limit, std::span<const VertexId> known);

  const DelaunayGraph* graph_;
  std::optional<VoronoiCounter> located_;
  detail::Array<std::uint32_t> stamp_;
  std::vector<VertexId> queue_;  // a corner, then the sites found inside, then room for more
  std::vector<VertexId> fresh_;  // room for neighbours that were not met before
  std::size_t inside_count_ = 0;
  std::uint32_t epoch_ = 0;
  std::uint64_t calls_ = 0;
};

/// The order of every face: the number of sites strictly inside its circumcircle, or limit + 1 if more than
/// `limit`. Exact. Requires: a triangulation of the sites of `graph` with the same vertex ids. The result
/// does not depend on `threads` (0 = all of the machine). Complexity: O(m * order).
THALWEG_EXPORT std::vector<std::uint32_t> face_orders(const DelaunayGraph& graph,
                                                      const Triangulation& triangulation, unsigned limit,
                                                      unsigned threads = 1);

}  // namespace thalweg
