/// How an order-k Voronoi diagram comes to be, in steps.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "order/site_index.hpp"
#include "order/voronoi_map.hpp"
#include "thalweg/order_k_voronoi.hpp"

namespace thalweg::detail {

/// The one class that may write to a diagram.
struct VoronoiBuilder {
  /// A diagram of the distinct sites points[rows[i]] without vertices and cells.
  static OrderKVoronoi start(std::span<const Point2> points, std::vector<std::uint32_t> rows, unsigned k,
                             std::shared_ptr<const SiteIndex> index);
  /// Takes vertices and half-edges, and numbers the cells by their lowest half-edges. Old vertices at
  /// infinity, which no ray reaches, are left out.
  static void take_map(OrderKVoronoi& diagram, VoronoiMap map);
  /// The set of the cell left of h, whose origin is not at infinity. Complexity: O(n).
  static std::vector<VertexId> set_of(const OrderKVoronoi& diagram, VoronoiHalfedgeId h);
  /// The sets of all cells, from that of one: across an edge one site goes and one comes.
  static void spread_sets(OrderKVoronoi& diagram, std::uint32_t cell, std::vector<VertexId> set);
  /// The cell that holds each site.
  static void locate_sites(OrderKVoronoi& diagram, unsigned threads);
  /// The diagram that is one cell: the plane.
  static void one_cell(OrderKVoronoi& diagram);
};

}  // namespace thalweg::detail
