/// Where water goes: from vertex to vertex along the steepest edge, down to the pit it ends in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/export.hpp"
#include "thalweg/pits.hpp"
#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg {

/// Side of "steeper": compares the descents from `from` to a and to b by fall over distance in the plane.
/// Returns +1 if the way to a is steeper, -1 if that to b is, 0 if both are equally steep.
/// Laws: compare_steepness(v, b, a) == -compare_steepness(v, a, b). Exact: the squares (fall * other
/// distance) are compared, never quotients or roots. Requires: finite coordinates; a and b neither at the
/// place of `from` nor above it.
THALWEG_EXPORT int compare_steepness(Point3 from, Point3 a, Point3 b) noexcept;

/// The flow paths of a terrain.
///
/// From a vertex with strictly lower neighbours water flows to the one of steepest descent; of equally steep
/// ones to the first in elevation order (z, x, y). A vertex of a flat without a lower neighbour passes it on
/// within the flat: towards the nearest vertex, in edges, that has one, or in a pit towards the first of the
/// pit in elevation order, its sink; of equally near ways by the neighbour that is first in elevation order.
/// Laws: paths have no cycle, and none ever rises; sinks are the first vertices of the pits, so that `basins`
/// is the number of pits; nothing depends on the numbers of the vertices.
struct Drainage {
  std::vector<VertexId> downstream;  ///< the next vertex of the path; invalid at sinks and isolated vertices
  std::vector<VertexId> sink;        ///< where the path ends; invalid for isolated vertices
  std::uint32_t basins = 0;          ///< number of sinks

  /// The start of the longest path, in the plane: of equally long ones the first in elevation order. Invalid
  /// without vertices.
  VertexId longest_from;
  std::uint32_t longest_edges = 0;  ///< the edges of that path
  /// Its length in the plane. Units: those of x and y. Rounded, for reading only, but the same everywhere;
  /// infinite beyond all doubles.
  double longest_length = 0;
};

/// Requires: vertex v of `terrain` lies at points[v], finite. Complexity: O(n).
THALWEG_EXPORT Drainage drain(const Triangulation& terrain, std::span<const Point3> points);

/// The level to which water must rise in each pit until it finds a way along edges to ground that is lower
/// than the pit's first vertex, in elevation order; infinite for the lowest pit of all. An edge is as high as
/// its higher end. Requires: `pits` are those of the terrain. Exact. Complexity: O(n log n).
THALWEG_EXPORT std::vector<double> spill_levels(const Triangulation& terrain, std::span<const Point3> points,
                                                const Pits& pits);

}  // namespace thalweg
