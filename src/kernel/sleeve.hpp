/// The sleeve of a segment between two vertices: the triangles it crosses, in order, and the vertices on
/// either side.
#pragma once

#include <span>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

/// left and right start at the source's end and run to the target's; neither holds source or target. A vertex
/// that the sleeve passes twice on one side occurs twice, with another between: the sides are the borders of
/// the two polygons that remain when the faces are taken out, edges that dangle into them included.
struct Sleeve {
  std::vector<FaceId> faces;
  std::vector<VertexId> left, right;
};

/// The sleeve from p to q in any triangulation of the sites; `sleeve` is overwritten, its memory kept.
/// Returns false if a vertex lies on the open segment pq. Requires: p and q are distinct, not isolated and
/// not joined. Exact. Complexity: O(degree of p + crossed edges).
bool find_sleeve(const Triangulation& triangulation, std::span<const Point2> sites, VertexId p, VertexId q,
                 Sleeve& sleeve);

}  // namespace thalweg::detail
