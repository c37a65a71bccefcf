/// From the planar map of the last order to the diagram: cells, their sets, and where each site is.
#include "order/voronoi_builder.hpp"

#include <algorithm>
#include <utility>

#include "kernel/assert.hpp"
#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {
namespace {

/// An old vertex u, v, infinity lies in the middle of the infinite border of a cell, no ray reaches it: joins
/// what it separates and leaves it without half-edges.
void cut_out_old_infinity(VoronoiMap& map) {
  for (std::uint32_t v = 0; v < map.old_count; ++v) {
    if (map.corner[3 * v + 2] != kInfinity) continue;
    std::uint32_t* twin = &map.twin[3 * v];
    map.twin[twin[1]] = twin[2];
    map.twin[twin[2]] = twin[1];
    twin[1] = twin[2] = kNoHalfedge;
  }
}

/// Half-edges in a new order: by cells, those of the outside last.
struct CellOrder {
  std::vector<std::uint32_t> place;  ///< of each half-edge of the map
  std::vector<std::uint32_t> first;  ///< of each cell, of the outside, and the end
};

CellOrder order_by_cells(const VoronoiMap& map) {
  CellOrder order;
  order.place.assign(map.twin.size(), kNoHalfedge);
  std::uint32_t place = 0;
  std::uint32_t outside = kNoHalfedge;
  const auto number_cycle = [&](std::uint32_t first) {
    order.first.push_back(place);
    std::uint32_t h = first;
    do {
      order.place[h] = place++;
      h = map.next(h);
    } while (h != first);
  };
  for (std::uint32_t h = 0; h < map.twin.size(); ++h) {
    if (order.place[h] != kNoHalfedge || map.twin[h] == kNoHalfedge) continue;
    map.outside(h) ? void(outside = h) : number_cycle(h);
  }
  number_cycle(outside);
  order.first.push_back(place);
  return order;
}

}  // namespace

OrderKVoronoi VoronoiBuilder::start(std::span<const Point2> points, std::vector<std::uint32_t> rows,
                                    unsigned k, std::shared_ptr<const SiteIndex> index) {
  OrderKVoronoi diagram;
  diagram.order_ = k;
  diagram.points_.assign(points.begin(), points.end());
  diagram.rows_ = std::move(rows);
  diagram.index_ = std::move(index);
  return diagram;
}

void VoronoiBuilder::take_map(OrderKVoronoi& diagram, VoronoiMap map) {
  cut_out_old_infinity(map);
  CellOrder order = order_by_cells(map);
  diagram.first_ = std::move(order.first);
  diagram.halfedges_.resize(diagram.first_.back());
  diagram.origin_.resize(diagram.first_.back());
  diagram.outgoing_.reserve(diagram.first_.back() / 3);
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    if (v == map.old_count) diagram.old_count_ = diagram.vertex_count();
    if (map.twin[3 * v + 1] == kNoHalfedge) continue;
    for (std::uint32_t h = 3 * v; h < 3 * v + 3; ++h) {
      const std::uint32_t place = order.place[h], gain = map.gain(h), loss = map.loss(h);
      const bool at_infinity = gain == kInfinity || loss == kInfinity;
      diagram.halfedges_[place] = {at_infinity ? kInfinity : gain, at_infinity ? kInfinity : loss,
                                   order.place[map.twin[h]], 0};
      diagram.origin_[place] = diagram.vertex_count();
    }
    diagram.outgoing_.push_back(order.place[3 * v]);
  }
  for (std::uint32_t c = 0; c <= diagram.cell_count(); ++c) {
    for (std::uint32_t h = diagram.first_[c]; h < diagram.first_[c + 1]; ++h) {
      diagram.halfedges_[diagram.halfedges_[h].twin].across = c;
    }
  }
}

std::vector<VertexId> VoronoiBuilder::set_of(const OrderKVoronoi& diagram, VoronoiHalfedgeId h) {
  const Triangle circle = diagram.circle(diagram.origin(h));
  const auto [a, b, c] = circle;
  std::vector<VertexId> set;
  for (const std::uint32_t row : diagram.rows_) {
    const VertexId s(row);
    if (s == a || s == b || s == c) continue;
    if (incircle_canonical(diagram.point(a), diagram.point(b), diagram.point(c), diagram.point(s)) > 0) {
      set.push_back(s);
    }
  }
  // Of the three sites, the cell has all that are lost on the way out of it, and none that are gained.
  const VertexId losses[2] = {diagram.loss(h), diagram.loss(diagram.prev(h))};
  set.insert(set.end(), losses, losses + (losses[0] == losses[1] ? 1 : 2));
  std::sort(set.begin(), set.end());
  THALWEG_ASSERT(set.size() == diagram.order_);
  return set;
}

void VoronoiBuilder::spread_sets(OrderKVoronoi& diagram, std::uint32_t cell, std::vector<VertexId> set) {
  const std::size_t k = diagram.order_;
  std::vector<VertexId>& sets = diagram.sets_;
  sets.resize(k * diagram.cell_count());
  std::copy(set.begin(), set.end(), sets.begin() + static_cast<std::ptrdiff_t>(k * cell));
  std::vector<std::uint32_t> todo = {cell};
  while (!todo.empty()) {
    const std::uint32_t from = todo.back();
    todo.pop_back();
    const VertexId* known = &sets[k * from];
    diagram.for_each_halfedge(CellId(from), [&](VoronoiHalfedgeId h) {
      const std::uint32_t to = diagram.halfedges_[h.index()].across;
      if (to == diagram.cell_count() || sets[k * to].valid()) return;
      const VertexId gain = diagram.gain(h), loss = diagram.loss(h);
      VertexId* out = &sets[k * to];
      bool gained = false;
      for (std::size_t i = 0; i < k; ++i) {
        if (!gained && gain < known[i]) {
          *out++ = gain;
          gained = true;
        }
        if (known[i] != loss) *out++ = known[i];
      }
      if (!gained) *out = gain;
      todo.push_back(to);
    });
  }
}

void VoronoiBuilder::one_cell(OrderKVoronoi& diagram) {
  diagram.first_ = {0, 0, 0};
  for (const std::uint32_t row : diagram.rows_) diagram.sets_.emplace_back(row);
  std::sort(diagram.sets_.begin(), diagram.sets_.end());
}

}  // namespace thalweg::detail
