/// A triangulation as packed half-edges: three to a triangle, topology only, no coordinate anywhere.
///
///     half-edge 3f+i runs from the i-th to the (i+1)-th corner of face f, counter-clockwise, f on its left
///
///            2                      next, prev, face: arithmetic
///           / ^                     origin, twin:     one array each
///     3f+2 v   \ 3f+1               twin of a hull half-edge: invalid
///         0 ---> 1
///           3f
///
/// 4 bytes an id: 12 + 12 bytes a triangle and 4 a vertex, 52 bytes a site in a large triangulation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "thalweg/export.hpp"
#include "thalweg/id.hpp"

namespace thalweg {

/// The corners of a triangle.
using Triangle = std::array<VertexId, 3>;

/// Vertices, and triangles that join them; not where they are. `const` is safe for concurrent readers.
/// Requires, of every id handed in: valid, and one of this triangulation. Complexity: O(1) where nothing else
/// is said.
class THALWEG_EXPORT Triangulation {
 public:
  /// No vertices and no triangles.
  Triangulation() = default;

  /// The triangulation with these counter-clockwise triangles over vertices 0 .. vertex_count - 1. Triangle i
  /// becomes face i, its corners in the given rotation. Vertices in no triangle are legal ("isolated").
  /// Returns nothing if an index is out of range, a triangle repeats a vertex, a directed edge occurs twice,
  /// or the triangles around a vertex do not form one fan. Complexity: O(m log m) for m triangles.
  static std::optional<Triangulation> from_triangles(std::span<const Triangle> triangles,
                                                     std::uint32_t vertex_count);

  /// Takes arrays that are already linked: origin[h], twin[h] (kInvalid on the hull) for each of the 3 m
  /// half-edges. Requires: the invariants that `find_fault` checks. Complexity: O(m).
  static Triangulation from_arrays(std::vector<std::uint32_t> origin, std::vector<std::uint32_t> twin,
                                   std::uint32_t vertex_count);

  /// The number of vertices, isolated ones included.
  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(outgoing_.size()); }
  /// The number of triangles; the outside is none.
  std::uint32_t face_count() const noexcept { return static_cast<std::uint32_t>(origin_.size() / 3); }
  /// Three times the number of triangles.
  std::uint32_t halfedge_count() const noexcept { return static_cast<std::uint32_t>(origin_.size()); }

  /// The half-edge that follows h around its face.
  static constexpr HalfedgeId next(HalfedgeId h) noexcept {
    return HalfedgeId(h.index() % 3 == 2 ? h.index() - 2 : h.index() + 1);
  }
  /// The half-edge that precedes h around its face.
  static constexpr HalfedgeId prev(HalfedgeId h) noexcept {
    return HalfedgeId(h.index() % 3 == 0 ? h.index() + 2 : h.index() - 1);
  }
  /// The face on the left of h.
  static constexpr FaceId face(HalfedgeId h) noexcept { return FaceId(h.index() / 3); }
  /// The half-edge of f that starts at the given corner, 0 to 2.
  static constexpr HalfedgeId halfedge(FaceId f, std::uint32_t corner = 0) noexcept {
    return HalfedgeId(3 * f.index() + corner);
  }

  /// The vertex from which h runs.
  VertexId origin(HalfedgeId h) const noexcept { return VertexId(origin_[h.index()]); }
  /// The vertex to which h runs.
  VertexId dest(HalfedgeId h) const noexcept { return origin(next(h)); }
  /// The vertex of the face of h that is not on h.
  VertexId apex(HalfedgeId h) const noexcept { return origin(prev(h)); }
  /// The half-edge in the opposite direction; invalid if h is on the hull.
  HalfedgeId twin(HalfedgeId h) const noexcept { return HalfedgeId(twin_[h.index()]); }
  /// Whether there is no face on the right of h.
  bool on_hull(HalfedgeId h) const noexcept { return !twin(h).valid(); }

  /// The corners of f, counter-clockwise from corner 0.
  Triangle corners(FaceId f) const noexcept {
    return {origin(halfedge(f, 0)), origin(halfedge(f, 1)), origin(halfedge(f, 2))};
  }

  /// One half-edge that leaves v: for a vertex on the hull the one along the hull, so that turning
  /// counter-clockwise from it visits every face at v. Invalid for an isolated vertex.
  HalfedgeId outgoing(VertexId v) const noexcept { return HalfedgeId(outgoing_[v.index()]); }
  /// Whether v is a corner of no triangle.
  bool isolated(VertexId v) const noexcept { return !outgoing(v).valid(); }
  /// Whether v is on the border; an isolated vertex is not.
  bool on_hull(VertexId v) const noexcept { return !isolated(v) && on_hull(outgoing(v)); }

  /// The half-edge out of the same vertex that follows h counter-clockwise; invalid past the last face of a
  /// hull vertex.
  HalfedgeId turn_ccw(HalfedgeId h) const noexcept { return twin(prev(h)); }

  /// Calls visit(VertexId) for every neighbour of v, counter-clockwise. Complexity: O(degree).
  template <class Visit>
  void for_each_neighbor(VertexId v, Visit&& visit) const {
    const HalfedgeId first = outgoing(v);
    for (HalfedgeId h = first; h.valid();) {
      visit(dest(h));
      const HalfedgeId turned = turn_ccw(h);
      if (!turned.valid()) visit(apex(h));
      if (turned == first) return;
      h = turned;
    }
  }

  /// The half-edge from u to v; invalid if they are not joined, or joined only by a hull edge that runs v to
  /// u. Complexity: O(degree of u).
  HalfedgeId find_halfedge(VertexId u, VertexId v) const noexcept;
  /// Whether an edge joins u and v. Complexity: O(degree of u).
  bool joined(VertexId u, VertexId v) const noexcept;

  /// Replaces the diagonal ab of the quadrilateral a, d, b, c (c = apex(h), d = apex(twin(h))) by cd:
  ///
  ///          c                 c
  ///        /   ^             / | ^
  ///       a --h-> b   =>    a  |  b        returns the half-edge d -> c, which is h: face(h) becomes d, c, a
  ///        ^   /             ^ h /          and the other face c, d, b
  ///          d                 d
  ///
  /// Requires: h not on the hull; the caller has checked that the quadrilateral is strictly convex.
  /// Keeps all ids of vertices and faces; the six half-edges of the two faces are renumbered. Complexity:
  /// O(1).
  HalfedgeId flip(HalfedgeId h) noexcept;

  /// Replaces faces by as many triangles that cover the same region; face olds[i] becomes triangle news[i].
  /// Requires: the triangles are counter-clockwise and bounded by the same edges as the faces.
  /// Keeps all ids of vertices and of other faces; the half-edges of `olds` are renumbered. Undo: the same
  /// call with the old corners. Complexity: O(m log m) for m faces replaced.
  void replace(std::span<const FaceId> olds, std::span<const Triangle> news);

  /// The first broken invariant in words, or nothing: arrays of equal length; origins in range; no triangle
  /// with a repeated vertex; twin an involution with matching ends; no directed edge twice; `outgoing` right,
  /// and along the hull for hull vertices; the faces at every vertex one fan. Complexity: O(m log m).
  std::optional<std::string> find_fault() const;

  /// The same triangulation with vertex i called names[i], of vertex_count vertices; faces and half-edges
  /// keep their ids. Requires: names distinct and < vertex_count. Complexity: O(m).
  Triangulation renamed(std::span<const std::uint32_t> names, std::uint32_t vertex_count) &&;

  /// Raw array, for packed output: the origin of each half-edge, three a face.
  std::span<const std::uint32_t> origins() const noexcept { return origin_; }
  /// Raw array, for packed output: the twin of each half-edge, kInvalid on the hull.
  std::span<const std::uint32_t> twins() const noexcept { return twin_; }

  /// Whether all ids mean the same: not whether the set of triangles is the same. Complexity: O(m).
  friend bool operator==(const Triangulation&, const Triangulation&) = default;

 private:
  void set_outgoing();
  void link(HalfedgeId h, HalfedgeId twin) noexcept;
  void settle_outgoing(std::span<const FaceId> faces) noexcept;

  std::vector<std::uint32_t> origin_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::uint32_t> outgoing_;
};

}  // namespace thalweg
