/// Does a set of edges extend to an order-k triangulation? Decided exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "terrain/outcome.hpp"
#include "terrain/surface.hpp"

namespace thalweg::detail {

/// An edge that a triangulation has to have.
struct RequiredEdge {
  VertexId u, v;
};

/// Finds order-k triangulations with required edges. Holds scratch memory and what it has learnt about pairs
/// of sites.
class Completion {
 public:
  enum class Answer { found, impossible, unknown };

  Completion(const Surface& surface, unsigned k);

  /// Looks for an order-k triangulation that has all `edges`, no two of which cross. `found`: it is in
  /// `triangulation()`. `impossible`: proved, there is none. `unknown`: after `budget` steps neither is
  /// known, or the watch has stopped.
  ///
  /// First the constrained Delaunay triangulation is tried; that its triangles are of too high an order
  /// proves nothing. Then triangles of order <= k are grown on both sides of every required edge that is not
  /// Delaunay, and on further edges that this brings, until all edges that are open on one side are Delaunay
  /// edges. Then the Delaunay triangles fill the rest exactly, because the grown region ends at their edges.
  /// Conversely, the triangles of any order-k triangulation with these edges that are reached from them
  /// without crossing a Delaunay edge are such a region; trying every triangle at every open edge misses
  /// none.
  Answer find(std::span<const RequiredEdge> edges, std::uint64_t budget, const Watch& watch);

  const Triangulation& triangulation() const noexcept { return triangulation_; }
  /// The required edges, and those that had to be grown: the triangulation is the constrained Delaunay
  /// triangulation with them.
  std::span<const std::pair<VertexId, VertexId>> edges() const noexcept { return edges_; }
  std::uint64_t circle_counts() const noexcept { return counter_.calls(); }

  /// All sites with a useful order of at most k with v, ascending.
  const std::vector<VertexId>& partners(VertexId v);

 private:
  using Edge = std::pair<VertexId, VertexId>;

  /// An open side of an edge, left of first -> second, the triangles that fit there, and the one that is
  /// placed.
  struct Decision {
    Edge side;
    std::vector<VertexId> apexes;
    std::size_t next = 0;
    std::size_t edges_before = 0;
  };

  bool insert_all(std::span<const RequiredEdge> edges);
  bool is_of_order();
  Answer grow(std::uint64_t budget, const Watch& watch);
  std::optional<Decision> tightest_open_side();
  std::vector<VertexId> apexes_at(const Edge& side);
  bool fits(VertexId u, VertexId v);
  bool has_edge(VertexId u, VertexId v) const;
  bool has_triangle_at(VertexId u, VertexId v) const;
  void place(const Decision& decision, VertexId apex);
  void remove(const Decision& decision);
  Point2 at(VertexId v) const noexcept { return surface_->sites()[v.index()]; }

  const Surface* surface_;
  unsigned k_;
  CircleCounter counter_;
  Triangulation triangulation_;
  std::unordered_map<std::uint32_t, std::vector<VertexId>> partners_;
  std::vector<Edge> edges_;          // all edges of the grown region and all required ones, each once
  std::vector<Triangle> triangles_;  // placed
};

}  // namespace thalweg::detail
