/// The order-k Voronoi diagram with point location: which k sites are the nearest, everywhere in the plane.
///
/// The cell of a set of k sites is where each of them is nearer than every other site. Cells are convex
/// polygons; across an edge exactly one site is lost and one gained; a vertex is the centre of a circle
/// through three sites with k - 1 or k - 2 others inside. Nothing is decided on rounded centres: the vertices
/// are the triples.
///
/// Degenerate input is the normal case. Of two sites equally far from a point the one that is smaller in
/// (x, y) is the nearer, everywhere: this is the symbolic perturbation of the canonical Delaunay
/// triangulation, and it makes the diagram unique. Every vertex then has three edges; where more than three
/// sites lie on one circle several vertices have the same place, and cells between them have no area, but are
/// there.
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "thalweg/export.hpp"
#include "thalweg/id.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg {

namespace detail {
class SiteIndex;
struct VoronoiBuilder;
}  // namespace detail

using CellId = Id<struct VoronoiCellTag>;                 ///< a cell of an OrderKVoronoi
using VoronoiVertexId = Id<struct VoronoiVertexTag>;      ///< a vertex of an OrderKVoronoi
using VoronoiHalfedgeId = Id<struct VoronoiHalfedgeTag>;  ///< a half-edge of an OrderKVoronoi

/// How `order_k_voronoi` works.
struct OrderKVoronoiOptions {
  unsigned threads = 1;  ///< 0 = all of the machine; the result does not depend on it
};

/// An axis-parallel rectangle.
struct Box {
  Point2 low;   ///< the corner with the least x and y
  Point2 high;  ///< the corner with the largest x and y
};

/// A half-edge structure with polygonal faces: the half-edges of a cell are consecutive, counter-clockwise.
/// Immutable: safe for concurrent readers. Sites are named by the caller's rows; of rows with equal points
/// the first stands for all.
///
/// Unbounded cells are cycles too: a ray ends at a *vertex at infinity*, and an *edge at infinity* joins two
/// of them along an unbounded cell. The other side of edges at infinity, the outside, is no cell. Every
/// vertex has three edges. Requires, of every id handed in: it is one of this diagram. Complexity: O(1) where
/// nothing else is said.
class THALWEG_EXPORT OrderKVoronoi {
 public:
  /// k.
  unsigned order() const noexcept { return order_; }
  /// The number of distinct sites.
  std::uint32_t site_count() const noexcept { return static_cast<std::uint32_t>(rows_.size()); }
  /// The caller's points.
  Point2 point(VertexId site) const noexcept { return points_[site.index()]; }

  /// Law: 2 k n - k^2 - n + 1 - (unbounded cells of all orders below k) cells for n sites of which no three
  /// are on one line. Source: Lee 1982.
  std::uint32_t cell_count() const noexcept { return static_cast<std::uint32_t>(first_.size() - 2); }
  /// The number of vertices, those at infinity included.
  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(outgoing_.size()); }
  /// The number of half-edges, those at infinity included: three times that of the vertices.
  std::uint32_t halfedge_count() const noexcept { return static_cast<std::uint32_t>(halfedges_.size()); }

  /// The k sites of a cell, ascending.
  std::span<const VertexId> sites(CellId c) const noexcept {
    return std::span(sets_).subspan(std::size_t{order_} * c.index(), order_);
  }
  /// The first half-edge with the cell on its left; invalid if the cell is the whole plane (k sites in all).
  VoronoiHalfedgeId halfedge(CellId c) const noexcept {
    return VoronoiHalfedgeId(halfedges_.empty() ? kNone : first_[c.index()]);
  }
  /// Whether the cell reaches to infinity. Complexity: O(edges) of the cell.
  bool unbounded(CellId c) const noexcept;

  /// The half-edge in the opposite direction. Always valid.
  VoronoiHalfedgeId twin(VoronoiHalfedgeId h) const noexcept {
    return VoronoiHalfedgeId(halfedges_[h.index()].twin);
  }
  /// The half-edge that follows around the cell, counter-clockwise.
  VoronoiHalfedgeId next(VoronoiHalfedgeId h) const noexcept {
    const std::uint32_t f = cycle_of(h);
    return VoronoiHalfedgeId(h.index() + 1 == first_[f + 1] ? first_[f] : h.index() + 1);
  }
  /// The half-edge that precedes around the cell.
  VoronoiHalfedgeId prev(VoronoiHalfedgeId h) const noexcept {
    const std::uint32_t f = cycle_of(h);
    return VoronoiHalfedgeId((h.index() == first_[f] ? first_[f + 1] : h.index()) - 1);
  }
  /// The vertex from which h runs.
  VoronoiVertexId origin(VoronoiHalfedgeId h) const noexcept { return VoronoiVertexId(origin_[h.index()]); }
  /// The vertex to which h runs.
  VoronoiVertexId dest(VoronoiHalfedgeId h) const noexcept { return origin(twin(h)); }
  /// The cell on the left; invalid for the outside.
  CellId face(VoronoiHalfedgeId h) const noexcept { return across(twin(h)); }
  /// The cell on the right, face(twin(h)); invalid for the outside. The cheaper of the two.
  CellId across(VoronoiHalfedgeId h) const noexcept {
    const std::uint32_t f = halfedges_[h.index()].across;
    return f == cell_count() ? CellId() : CellId(f);
  }

  /// The site that the cell across h has and the cell of h has not: the edge is on the bisector of gain(h)
  /// and loss(h). Invalid at infinity. Law: gain(h) == loss(twin(h)).
  VertexId gain(VoronoiHalfedgeId h) const noexcept { return row(halfedges_[h.index()].gain); }
  /// The site that the cell of h has and the cell across has not. Invalid at infinity.
  VertexId loss(VoronoiHalfedgeId h) const noexcept { return row(halfedges_[h.index()].loss); }
  /// Whether h is on an edge at infinity.
  bool at_infinity(VoronoiHalfedgeId h) const noexcept { return halfedges_[h.index()].gain == kNone; }

  /// One half-edge that leaves v; for a vertex at infinity its ray.
  VoronoiHalfedgeId outgoing(VoronoiVertexId v) const noexcept {
    return VoronoiHalfedgeId(outgoing_[v.index()]);
  }
  /// The sites whose circle has its centre at v, counter-clockwise. For a vertex at infinity two sites and an
  /// invalid one: the circle is the half-plane on the left of the two.
  Triangle circle(VoronoiVertexId v) const noexcept;
  /// How many sites are inside the circle of v, under the perturbation: k - 1 or k - 2.
  unsigned inside(VoronoiVertexId v) const noexcept { return order_ - (v.index() < old_count_ ? 2 : 1); }
  /// Whether v is where a ray ends.
  bool at_infinity(VoronoiVertexId v) const noexcept { return at_infinity(prev(outgoing(v))); }

  /// Calls visit(VoronoiHalfedgeId) for every half-edge of a cell, counter-clockwise. Complexity: O(edges).
  template <class Visit>
  void for_each_halfedge(CellId c, Visit&& visit) const {
    for (std::uint32_t h = first_[c.index()]; h < first_[c.index() + 1]; ++h) visit(VoronoiHalfedgeId(h));
  }

  /// The cell of the k nearest sites of q. Exact; of equally distant sites the smaller in (x, y) is the
  /// nearer, so that a point on the border of cells belongs to exactly one. Requires: finite q. Complexity:
  /// O(log n) to a site near q, and expected O(sqrt(k)) cells crossed from there.
  CellId locate(Point2 q) const;

  /// The cell that holds the centre of the circle through u, v, w, which is not computed: each comparison is
  /// one exact predicate of degree 4. Ties as in `locate`. Requires: u, v, w counter-clockwise. Complexity:
  /// as `locate`.
  CellId locate_centre(VertexId u, VertexId v, VertexId w) const;

  /// The k nearest sites of q, nearest first, equal distances by (x, y). Exact. Requires: finite q.
  /// Complexity: `locate`, and O(k log k).
  std::vector<VertexId> nearest(Point2 q) const;

  /// The cell as a convex polygon, counter-clockwise, clipped to the box, in rounded coordinates: for drawing
  /// only. Empty if no more is left than rounding could make. Complexity: O(edges^2) of the cell.
  std::vector<Point2> polygon(CellId c, const Box& box) const;

  /// The pairs of sites that are separated by an edge of the diagram, first < second, sorted: those with a
  /// circle through both that has exactly k - 1 sites inside (under the perturbation). Complexity: O(m log
  /// m).
  std::vector<std::pair<VertexId, VertexId>> delaunay_edges() const;

  /// What the diagram holds in memory, in bytes.
  std::size_t memory_bytes() const noexcept;

 private:
  friend struct detail::VoronoiBuilder;
  static constexpr std::uint32_t kNone = 0xffffffffu;

  OrderKVoronoi() = default;

  // All that a walk needs, in one place of memory.
  struct Halfedge {
    std::uint32_t gain;  // by its number in spatial order
    std::uint32_t loss;
    std::uint32_t twin;
    std::uint32_t across;  // a cell, or cell_count() for the outside
  };

  VertexId row(std::uint32_t site) const noexcept { return VertexId(site == kNone ? kNone : rows_[site]); }
  std::uint32_t cycle_of(VoronoiHalfedgeId h) const noexcept {
    return halfedges_[halfedges_[h.index()].twin].across;
  }
  template <class Nearer>
  std::uint32_t walk(std::uint32_t cell, Nearer&& nearer) const;

  unsigned order_ = 0;
  std::uint32_t old_count_ = 0;  // vertices below have k - 2 sites inside, the others k - 1
  std::vector<Point2> points_;
  std::vector<std::uint32_t> rows_;   // of each site, in spatial order
  std::vector<std::uint32_t> first_;  // half-edge of each cell, of the outside, and the end
  std::vector<Halfedge> halfedges_;
  std::vector<std::uint32_t> origin_;    // of each half-edge
  std::vector<std::uint32_t> outgoing_;  // of each vertex
  std::vector<VertexId> sets_;           // k of each cell
  std::vector<std::uint32_t> cell_at_;   // the cell that holds each site
  std::shared_ptr<const detail::SiteIndex> index_;
};

/// The diagram of order k of the distinct points among `points`. One point, and points all on one line, are
/// legal. The diagrams of orders 1 to k are built one from the other and only the last is kept.
/// Deterministic: the same set of coordinates gives the same cells. Errors: invalid_argument if k is 0;
/// too_few_points if k is more than the number of distinct points; not_finite with the rows; too_many_points
/// if ids do not suffice (half-edges: beyond about 358e6 / k points). Complexity: O(k^2 n + n log n)
/// expected; memory per site about 8 k^2 + 260 k bytes, and 415 k at the peak. Source: Lee 1982, the
/// iteration over orders; see src/order/voronoi_map.hpp and voronoi_hole.hpp.
THALWEG_EXPORT Result<OrderKVoronoi> order_k_voronoi(std::span<const Point2> points, unsigned k,
                                                     const OrderKVoronoiOptions& options = {});

}  // namespace thalweg
