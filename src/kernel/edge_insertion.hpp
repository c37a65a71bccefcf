/// Inserting an edge into a triangulation: what it would replace, and back again.
#pragma once

#include <span>
#include <vector>

#include "kernel/sleeve.hpp"
#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

/// One planned insertion at a time; its memory is kept from one to the next.
class EdgeInsertion {
 public:
  /// Prepares the edge pq: the sleeve it crosses and the constrained Delaunay triangles on both of its sides.
  /// Returns false if p and q are joined already or a vertex lies between them. Requires: p, q distinct, not
  /// isolated.
  bool plan(const Triangulation& triangulation, std::span<const Point2> sites, VertexId p, VertexId q);

  /// The faces that go, and the triangles that come in their places, as many.
  std::span<const FaceId> faces() const noexcept { return sleeve_.faces; }
  std::span<const Triangle> triangles() const noexcept { return triangles_; }
  /// All vertices of the faces, p and q first; a vertex passed twice occurs twice.
  std::span<const VertexId> vertices() const noexcept { return vertices_; }

  /// Carries the plan out. Requires: the triangulation is as it was planned for.
  void apply(Triangulation& triangulation);
  /// Takes back the last `apply`. Requires: the triangulation is as that left it.
  void undo(Triangulation& triangulation) const;

 private:
  Sleeve sleeve_;
  std::vector<Triangle> triangles_, before_;
  std::vector<VertexId> vertices_;
};

}  // namespace thalweg::detail
