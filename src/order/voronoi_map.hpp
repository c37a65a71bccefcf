/// The order-i Voronoi diagram as a planar map of vertices with three half-edges each, and the step from one
/// order to the next. Topology and labels only: the k-sets of the cells follow from the labels.
///
/// A circle through three sites with j others inside (the set I) is a vertex of two diagrams: "new" in the
/// one of order j + 1, where the cells I+a, I+b, I+c meet, and "old" in the one of order j + 2, where I+ab,
/// I+bc, I+ca meet. An edge between cells J+u and J+v lies on the bisector of u and v: seen from J+u the site
/// v is its gain and u its loss. Slot s of a vertex a0, a1, a2 (counter-clockwise) is the edge on the
/// bisector of a[s] and a[s+1]; around the vertex the slots are counter-clockwise in both diagrams:
///
///            new:  1 \ a1 / 0            old:      | 2
///                     \  /                  a1 a2  |  a0 a1          (a sector is labelled with what its
///                  a2  \/  a0                     / \                 cell holds beside I)
///                       |                      0 /   \ 1
///                       | 2                      a2 a0
///
/// Everything is in general position, because circles are tested with `incircle_canonical`, which never ties:
/// the diagram is that of the perturbed sites, in which the lexicographically smaller of two equally distant
/// sites is the nearer. Collinear sites need no perturbation: their bisectors are parallel.
///
/// Vertices at infinity: a ray between J+u and J+v ends at the "circle" u, v, infinity, a half-plane. Edges
/// at infinity join consecutive ones, so that an unbounded cell is a cycle too; the gain there is "infinity".
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

/// In place of a site: infinity. In place of a half-edge: none.
inline constexpr std::uint32_t kInfinity = 0xffffffffu;
inline constexpr std::uint32_t kNoHalfedge = 0xffffffffu;

/// One diagram. Half-edge 3 v + s leaves vertex v along slot s; the face is on its left.
struct VoronoiMap {
  std::vector<std::uint32_t> corner;  ///< three sites a vertex, counter-clockwise
  std::vector<std::uint32_t> twin;    ///< three half-edges a vertex
  std::uint32_t old_count = 0;        ///< vertices below are old, those from here on are new

  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(corner.size() / 3); }

  static constexpr std::uint32_t turn_ccw(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
  static constexpr std::uint32_t turn_cw(std::uint32_t h) noexcept { return h % 3 == 0 ? h + 2 : h - 1; }

  bool is_new(std::uint32_t h) const noexcept { return h >= 3 * old_count; }
  /// The half-edge after h around its face.
  std::uint32_t next(std::uint32_t h) const noexcept { return turn_cw(twin[h]); }
  /// The site that the face across h has and the face of h has not.
  std::uint32_t gain(std::uint32_t h) const noexcept { return corner[is_new(h) ? h : turn_ccw(h)]; }
  /// The site that the face of h has and the face across has not.
  std::uint32_t loss(std::uint32_t h) const noexcept { return corner[is_new(h) ? turn_ccw(h) : h]; }
  /// Whether the left of h is no cell but the outside of the map. Requires: h leaves a vertex that is new or
  /// not at infinity.
  bool outside(std::uint32_t h) const noexcept { return corner[turn_ccw(h)] == kInfinity; }
};

/// The diagram of order 1: the dual of the canonical Delaunay triangulation.
VoronoiMap first_order(const Triangulation& delaunay);

/// The diagram of the next order. Requires: `map` has order at most the number of sites - 2 and its sites are
/// not all on one line. The result does not depend on `threads`. Errors: an empty map if ids do not suffice.
/// Complexity: O(size of both diagrams) expected for sites without cells of many neighbours, which cost
/// O(m log m) each. Source: Lee 1982, the iteration over orders; holes by gift wrapping are our own.
VoronoiMap next_order(const VoronoiMap& map, std::span<const Point2> sites, unsigned threads);

}  // namespace thalweg::detail
