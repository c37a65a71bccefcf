/// From the planar map of the last order to the diagram: cells, their sets, and where each site is.
#include "order/voronoi_builder.hpp"

#include <algorithm>
#include <utility>

#include "kernel/assert.hpp"
#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {
namespace {

/// Gives vertex `from` the number `to`.
void move_vertex(VoronoiMap& map, std::uint32_t from, std::uint32_t to) {
  for (std::uint32_t slot = 0; slot < 3; ++slot) {
    const std::uint32_t twin = map.twin[3 * from + slot];
    map.corner[3 * to + slot] = map.corner[3 * from + slot];
    map.twin[3 * to + slot] = twin;
    map.twin[twin] = 3 * to + slot;
  }
}

/// An old vertex u, v, infinity lies in the middle of the infinite border of a cell: joins what it separates,
/// and closes the gaps in the numbering.
void drop_old_infinity(VoronoiMap& map) {
  std::vector<std::uint32_t> dropped;
  for (std::uint32_t v = 0; v < map.old_count; ++v) {
    if (map.corner[3 * v + 2] != kInfinity) continue;
    const std::uint32_t one = map.twin[3 * v + 1], other = map.twin[3 * v + 2];
    map.twin[one] = other;
    map.twin[other] = one;
    dropped.push_back(v);
  }
  const auto count = static_cast<std::uint32_t>(dropped.size());
  const std::uint32_t old_left = map.old_count - count, left = map.vertex_count() - count;
  std::uint32_t from = map.old_count;
  auto last = dropped.end();
  for (const std::uint32_t to : dropped) {
    if (to >= old_left) break;
    for (--from; last != dropped.begin() && *(last - 1) == from; --from) --last;
    move_vertex(map, from, to);
  }
  for (std::uint32_t v = std::max(map.old_count, left), to = old_left; v < left + count; ++v, ++to) {
    move_vertex(map, v, to);
  }
  map.old_count = old_left;
  map.corner.resize(3 * std::size_t{left});
  map.twin.resize(3 * std::size_t{left});
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
  drop_old_infinity(map);
  diagram.face_.assign(map.twin.size(), OrderKVoronoi::kNone);
  for (std::uint32_t h = 0; h < map.twin.size(); ++h) {
    if (diagram.face_[h] != OrderKVoronoi::kNone || map.outside(h)) continue;
    const std::uint32_t cell = diagram.cell_count();
    diagram.first_.push_back(h);
    std::uint32_t g = h;
    do {
      diagram.face_[g] = cell;
      g = map.next(g);
    } while (g != h);
  }
  diagram.first_.shrink_to_fit();
  diagram.old_count_ = map.old_count;
  diagram.corner_ = std::move(map.corner);
  diagram.twin_ = std::move(map.twin);
}

std::vector<VertexId> VoronoiBuilder::set_beside(const OrderKVoronoi& diagram, std::uint32_t h) {
  const std::span<const Point2> sites = diagram.index_->sites();
  const std::uint32_t* corners = &diagram.corner_[h - h % 3];
  std::vector<VertexId> set;
  for (std::uint32_t s = 0; s < sites.size(); ++s) {
    if (s == corners[0] || s == corners[1] || s == corners[2]) continue;
    const bool inside =
        incircle_canonical(sites[corners[0]], sites[corners[1]], sites[corners[2]], sites[s]) > 0;
    if (inside) set.push_back(diagram.row(s));
  }
  // The cell of an old vertex has two of its sites: the one lost across h, and that which is on neither side.
  set.push_back(diagram.row(diagram.loss_of(h)));
  if (h < 3 * diagram.old_count_) set.push_back(diagram.row(corners[(h % 3 + 2) % 3]));
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
      const std::uint32_t to = diagram.face_[diagram.twin_[h.index()]];
      if (to == OrderKVoronoi::kNone || sets[k * to].valid()) return;
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
  diagram.first_ = {OrderKVoronoi::kNone};
  for (const std::uint32_t row : diagram.rows_) diagram.sets_.push_back(VertexId(row));
  std::sort(diagram.sets_.begin(), diagram.sets_.end());
}

}  // namespace thalweg::detail
