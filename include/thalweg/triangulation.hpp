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
#include <utility>
#include <vector>

#include "thalweg/array.hpp"
#include "thalweg/export.hpp"
#include "thalweg/id.hpp"

namespace thalweg {

/// The corners of a triangle.
using Triangle = std::array<VertexId, 3>;

class Triangulation;

namespace detail {
/// The triangulation with these arrays: the origin and the twin of each half-edge, and one half-edge out of
/// each vertex as `Triangulation::outgoing` has it. Requires: the invariants that `find_fault` checks.
Triangulation linked(Array<std::uint32_t> origin, Array<std::uint32_t> twin, Array<std::uint32_t> outgoing);
}  // namespace detail

/// Vertices, and triangles that join them; not where they are. `const` is safe for concurrent readers.
/// Requires, of every id handed in: valid, and one of this triangulation. Complexity: O(1) where nothing else
/// is said.
class THALWEG_EXPORT Triangulation {
 public:
  /// No vertices and no triangles.
  Triangulation() = default;
  /// The same vertices and triangles under the same ids; a copy of a revision is one of the same base.
  Triangulation(const Triangulation&) = default;
  /// Takes all of the other, which is empty afterwards.
  Triangulation(Triangulation&&) noexcept = default;
  /// A copy. std::bad_alloc leaves all as it was.
  Triangulation& operator=(const Triangulation& other) {
    Triangulation copy(other);
    return *this = std::move(copy);
  }
  /// Takes all of the other, which is empty afterwards.
  Triangulation& operator=(Triangulation&&) noexcept = default;
  ~Triangulation() = default;

  /// The triangulation with these counter-clockwise triangles over vertices 0 .. vertex_count - 1. Triangle i
  /// becomes face i, its corners in the given rotation. Vertices in no triangle are legal ("isolated").
  /// Returns nothing if an index is out of range, a triangle repeats a vertex, a directed edge occurs twice,
  /// or the triangles around a vertex do not form one fan. Complexity: O(m log m) for m triangles.
  static std::optional<Triangulation> from_triangles(std::span<const Triangle> triangles,
                                                     std::uint32_t vertex_count);

  /// The triangulation of arrays that are already linked: origin[h], twin[h] (kInvalid on the hull) for each
  /// of the 3 m half-edges. Requires: the invariants that `find_fault` checks. Complexity: O(m).
  static Triangulation from_arrays(std::span<const std::uint32_t> origin, std::span<const std::uint32_t> twin,
                                   std::uint32_t vertex_count);

  /// A triangulation equal to `base` that shares with it all that edits do not change: it holds 6 bytes a
  /// vertex, and 128 for every stretch of 16 half-edges that an edit has touched. Reading and editing are
  /// those of any other. Requires: `base` is no revision itself, outlives this one and its copies, and does
  /// not change. Complexity: O(n), a small part of that of a copy.
  static Triangulation revision_of(const Triangulation& base);
  /// Whether it was made by revision_of.
  bool is_revision() const noexcept { return base_ != nullptr; }
  /// Of a revision: the faces that may differ from those of its base, ascending. Complexity: in
  /// the number of edits.
  std::vector<FaceId> revised_faces() const;
  /// Becomes equal to a revision of this triangulation. Invalidates: the revision. Complexity: O(n).
  void take(Triangulation&& revision);

  /// The number of vertices, isolated ones included.
  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(outgoing_.size()); }
  /// The number of triangles; the outside is none.
  std::uint32_t face_count() const noexcept { return halfedge_count() / 3; }
  /// Three times the number of triangles.
  std::uint32_t halfedge_count() const noexcept {
    return static_cast<std::uint32_t>((is_revision() ? base_->origin_ : origin_).size());
  }

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
  VertexId origin(HalfedgeId h) const noexcept { return VertexId(get(&Triangulation::origin_, h)); }
  /// The vertex to which h runs.
  VertexId dest(HalfedgeId h) const noexcept { return origin(next(h)); }
  /// The vertex of the face of h that is not on h.
  VertexId apex(HalfedgeId h) const noexcept { return origin(prev(h)); }
  /// The half-edge in the opposite direction; invalid if h is on the hull.
  HalfedgeId twin(HalfedgeId h) const noexcept { return HalfedgeId(get(&Triangulation::twin_, h)); }
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
  /// Keeps all ids of vertices and faces; the six half-edges of the two faces are renumbered. Throws nothing
  /// but, on a revision, std::bad_alloc, and then nothing has changed. Complexity: O(1).
  HalfedgeId flip(HalfedgeId h);

  /// Replaces faces by as many triangles that cover the same region; face olds[i] becomes triangle news[i].
  /// Requires: the triangles are counter-clockwise and bounded by the same edges as the faces.
  /// Keeps all ids of vertices and of other faces; the half-edges of `olds` are renumbered. Undo: the same
  /// call with the old corners. std::bad_alloc leaves all as it was. Complexity: O(m log m) for m faces
  /// replaced.
  void replace(std::span<const FaceId> olds, std::span<const Triangle> news);

  /// The first broken invariant in words, or nothing: arrays of equal length; origins in range; no triangle
  /// with a repeated vertex; twin an involution with matching ends; no directed edge twice; `outgoing` right,
  /// and along the hull for hull vertices; the faces at every vertex one fan. Complexity: O(m log m).
  std::optional<std::string> find_fault() const;

  /// The same triangulation with vertex i called names[i], of vertex_count vertices; faces and half-edges
  /// keep their ids. Requires: names distinct and < vertex_count; no revision. Complexity: O(m).
  Triangulation renamed(std::span<const std::uint32_t> names, std::uint32_t vertex_count,
                        unsigned threads = 1) &&;

  /// Raw array, for packed output: the origin of each half-edge, three a face. Requires: no revision.
  std::span<const std::uint32_t> origins() const noexcept { return origin_; }
  /// Raw array, for packed output: the twin of each half-edge, kInvalid on the hull. Requires: no
  /// revision.
  std::span<const std::uint32_t> twins() const noexcept { return twin_; }

  /// Whether both have as many vertices and the same half-edges under the same ids, shared or not; not which
  /// of the half-edges out of a vertex `outgoing` names. Complexity: O(m).
  friend bool operator==(const Triangulation& a, const Triangulation& b) noexcept;

 private:
  friend Triangulation detail::linked(detail::Array<std::uint32_t>, detail::Array<std::uint32_t>,
                                      detail::Array<std::uint32_t>);

  using Numbers = detail::Array<std::uint32_t>;
  static constexpr std::uint32_t kPage = 16;  // half-edges: 64 bytes of each array
  static constexpr std::uint32_t kShared = 0xffffffffu;

  std::uint32_t get(Numbers Triangulation::*array, HalfedgeId h) const noexcept {
    if (!is_revision()) return (this->*array)[h.index()];
    const std::uint32_t page = pages_[h.index() / kPage];
    if (page == kShared) return (base_->*array)[h.index()];
    return (this->*array)[page * std::size_t{kPage} + h.index() % kPage];
  }
  std::size_t own_place(HalfedgeId h) { return is_revision() ? place_in_revision(h) : h.index(); }
  std::size_t place_in_revision(HalfedgeId h);
  void claim(HalfedgeId h);
  void set_origin(HalfedgeId h, VertexId v) { origin_[own_place(h)] = v.index(); }
  void set_twin(HalfedgeId h, HalfedgeId twin) { twin_[own_place(h)] = twin.index(); }

  void set_outgoing();
  void link(HalfedgeId h, HalfedgeId twin);
  void settle_outgoing(std::span<const FaceId> faces) noexcept;

  // Of a revision, origin_ and twin_ hold the touched stretches of the arrays of base_, one after the other
  // in the order of the edits, and pages_ says where each stretch is.
  Numbers origin_;
  Numbers twin_;
  Numbers outgoing_;
  const Triangulation* base_ = nullptr;
  std::vector<std::uint32_t> pages_;
};

}  // namespace thalweg
