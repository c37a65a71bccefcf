/// What a heuristic has changed, measured against the Delaunay triangulation from which it came.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "terrain/surface.hpp"

namespace thalweg::detail {

/// The faces that edits have changed: all others are still what they are in the Delaunay triangulation, under
/// the same id.
std::vector<FaceId> changed_faces(const Surface& surface, const Triangulation& triangulation);

struct EdgeChanges {
  std::uint32_t changed = 0;  ///< edges that the Delaunay triangulation does not have
  std::uint32_t non_delaunay =
      0;  ///< inner edges with the apex of one triangle inside the circle of the other
};

/// Looks at the changed faces only: an edge between two others is a Delaunay edge, and locally Delaunay.
EdgeChanges edge_changes(const Surface& surface, const Triangulation& triangulation,
                         std::span<const FaceId> changed);

/// The order of every face: counted for the changed ones, 0 for the others. `counts` grows by the counts
/// made. On all threads.
std::vector<std::uint32_t> orders_after(const Surface& surface, const Triangulation& triangulation,
                                        std::span<const FaceId> changed, unsigned limit, unsigned threads,
                                        std::uint64_t& counts);

/// The smallest angle of any triangle, in degrees: of the Delaunay triangulation, and of what it has become.
/// Rounded: for people, not for decisions.
struct SmallestAngles {
  double before_deg, after_deg;
};
/// Both in one pass, since most triangles are in both. On all threads.
SmallestAngles smallest_angles(const Surface& surface, const Triangulation& triangulation, unsigned threads);

}  // namespace thalweg::detail
