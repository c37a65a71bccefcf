/// Is somebody's mesh a triangulation of its points? Every kind of fault, by exact tests.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "thalweg/export.hpp"
#include "thalweg/point.hpp"

namespace thalweg {

/// What may be wrong with a mesh.
enum class FaultKind {
  index_out_of_range,  ///< a triangle names a vertex that does not exist
  degenerate,          ///< a triangle without area: a repeated or three collinear vertices
  clockwise,           ///< a triangle that turns the wrong way
  duplicate_vertex,    ///< two vertices at the same (x, y)
  unused_vertex,       ///< a vertex in no triangle
  duplicate_triangle,  ///< the same three vertices twice
  non_manifold,        ///< an edge with three or more triangles, or a vertex whose triangles are not one fan
  crossing,            ///< two edges that cross, or a vertex inside an edge
  overlap,             ///< two triangles that share area
  hole,                ///< a border inside the convex hull: part of it is not covered
};

/// The name of a kind as users read it: "index out of range", ... Never null.
THALWEG_EXPORT const char* fault_name(FaultKind kind) noexcept;

/// One kind of fault: how often it was found, and the first few places.
struct Fault {
  FaultKind kind = FaultKind::degenerate;  ///< what is wrong
  std::uint64_t count = 0;                 ///< how often; counting stops at a million
  std::vector<std::string> examples;       ///< at most five, e.g. "triangle 17 (4, 8, 2)"
};

/// All faults of the mesh, one entry a kind in the order of FaultKind; empty if and only if the triangles are
/// a counter-clockwise triangulation of all points, covering their convex hull. Exact. Requires: finite
/// coordinates. Complexity: O(m log m) for a sound mesh; a broken one costs more, bounded by the number of
/// faults looked at (counting stops at a million of a kind).
THALWEG_EXPORT std::vector<Fault> find_faults(std::span<const Point2> points,
                                              std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace thalweg
