/// Inserting an edge: sleeve out, two constrained polygons in.
#include "kernel/edge_insertion.hpp"

#include <algorithm>

#include "kernel/assert.hpp"
#include "kernel/polygon.hpp"

namespace thalweg::detail {

bool EdgeInsertion::plan(const Triangulation& triangulation, std::span<const Point2> sites, VertexId p,
                         VertexId q) {
  if (triangulation.joined(p, q) || !find_sleeve(triangulation, sites, p, q, sleeve_)) return false;

  vertices_.assign({p, q});
  vertices_.insert(vertices_.end(), sleeve_.left.begin(), sleeve_.left.end());
  vertices_.insert(vertices_.end(), sleeve_.right.begin(), sleeve_.right.end());

  triangles_.clear();
  triangulate_polygon(sites, p, q, sleeve_.left, triangles_);
  std::reverse(sleeve_.right.begin(), sleeve_.right.end());
  triangulate_polygon(sites, q, p, sleeve_.right, triangles_);
  THALWEG_ASSERT(triangles_.size() == sleeve_.faces.size());
  return true;
}

void EdgeInsertion::apply(Triangulation& triangulation) {
  before_.clear();
  for (const FaceId f : sleeve_.faces) before_.push_back(triangulation.corners(f));
  triangulation.replace(sleeve_.faces, triangles_);
}

void EdgeInsertion::undo(Triangulation& triangulation) const {
  triangulation.replace(sleeve_.faces, before_);
}

}  // namespace thalweg::detail
