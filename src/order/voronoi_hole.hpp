/// The part of a Voronoi diagram inside one cell of the diagram of one order less.
///
/// Inside the cell of a set T the next nearest site decides: what is there is the Voronoi diagram of all
/// sites but T. Only sites gained across the cell's own edges matter, each on one arc of the boundary, and it
/// is a tree with these arcs as leaves: its dual triangulates the polygon of the gained sites in the order of
/// their arcs. (The circles of these triangles hold all of T and nothing else.) Why one arc a site s: seen
/// from s, every ray enters the region "T is nearer than s" once and leaves the region of s once, so the
/// directions in which it is in both are an interval.
///
/// A hole of m sites thus has m - 2 triangles, each Delaunay among the m sites alone.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "order/voronoi_map.hpp"
#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

/// A side of the polygon: from this site to that of the following side.
struct HoleSide {
  std::uint32_t site;
  std::uint32_t halfedge;  ///< of the next diagram: it ends, inside the cell, at what the side belongs to
};

/// Fills one hole after the other. Holds scratch memory: one per thread.
class HoleFiller {
 public:
  explicit HoleFiller(std::span<const Point2> sites) : sites_(sites) {}

  /// Triangulates the polygon and links its m - 2 vertices, written to vertex `first_vertex` of `map` and
  /// those after it, with each other and with the sides. Requires: sides counter-clockwise, at least 2;
  /// infinity, if it is among the sites, last.
  void fill(std::span<const HoleSide> sides, VoronoiMap& map, std::uint32_t first_vertex);

 private:
  /// The triangle to be found is to the left of the edge from side `to` back to side `from`: sides from..to
  /// are the rest of the polygon.
  struct Chain {
    std::uint32_t from, to;
    std::uint32_t outer;      ///< half-edge of the map across the edge
    std::uint32_t mesh_edge;  ///< half-edge of the mesh from `to` to `from`, or into `from` along the hull
  };

  bool inside(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const noexcept;
  std::uint32_t nearest_apex(std::span<const HoleSide> sides, Chain chain) const noexcept;
  std::uint32_t mesh_apex(Chain chain) const noexcept;
  void triangulate(std::span<const HoleSide> sides);
  std::uint32_t root_edge(std::uint32_t last) const noexcept;
  std::uint32_t hull_edge_into(std::uint32_t side) const noexcept;
  Chain before(Chain chain, std::uint32_t apex, std::uint32_t outer) const noexcept;
  Chain after(Chain chain, std::uint32_t apex, std::uint32_t outer) const noexcept;

  std::span<const Point2> sites_;
  std::vector<Chain> stack_;
  Triangulation mesh_;  ///< of a large polygon; its vertices are sides, infinity excepted
  enum class Way { scan, mesh, line } way_ = Way::scan;
  bool unbounded_ = false;
};

}  // namespace thalweg::detail
