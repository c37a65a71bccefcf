/// Filling holes: gift wrapping, which is best for the three or four sites of nearly every hole, and a
/// Delaunay triangulation for the rest.
#include "order/voronoi_hole.hpp"

#include <utility>

#include "kernel/assert.hpp"
#include "kernel/delaunay_sites.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/spatial_order.hpp"

namespace thalweg::detail {
namespace {

/// Gift wrapping takes up to m^2 tests; from here on a triangulation is faster.
constexpr std::size_t kManySides = 40;

}  // namespace

/// Whether d is inside the circle a, b, c; for c = infinity, to the left of ab.
bool HoleFiller::inside(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const noexcept {
  if (c == kInfinity) return orient2d_sign(sites_[a], sites_[b], sites_[d]) > 0;
  return incircle_canonical(sites_[a], sites_[b], sites_[c], sites_[d]) > 0;
}

// The triangle sought is Delaunay: its circle holds none of the other sites. So its apex takes the place of
// any other candidate when its turn comes, and nothing takes its place; but a candidate must be on the side
// of the hole, or its circle would be the complement of what is meant. Only the one to begin with need not
// be: as the apex is outside its circle, which lies on the other side of the chord, it is in the complement.
// With infinity as the third corner all sites are on one side of the line sought, and `inside` compares
// directions.
std::uint32_t HoleFiller::nearest_apex(std::span<const HoleSide> sides, Chain chain) const noexcept {
  const std::uint32_t from = sides[chain.from].site, to = sides[chain.to].site;
  const auto on_side = [&](std::uint32_t site) {
    return to == kInfinity || orient2d_sign(sites_[from], sites_[site], sites_[to]) > 0;
  };
  std::uint32_t best = chain.from + 1;
  for (std::uint32_t i = best + 1; i < chain.to; ++i) {
    const std::uint32_t site = sides[i].site;
    if (inside(from, sides[best].site, to, site) && on_side(site)) best = i;
  }
  THALWEG_ASSERT(on_side(sides[best].site));
  return best;
}

std::uint32_t HoleFiller::mesh_apex(Chain chain) const noexcept {
  const HalfedgeId h(chain.mesh_edge);
  return (mesh_.on_hull(h) && unbounded_ && mesh_.origin(h).index() != chain.to ? mesh_.origin(h)
                                                                                : mesh_.apex(h))
      .index();
}

/// The Delaunay triangulation of the sites of the polygon, its vertices numbered as the sides.
void HoleFiller::triangulate(std::span<const HoleSide> sides) {
  std::vector<Point2> points;
  for (const HoleSide& side : sides.first(sides.size() - (unbounded_ ? 1 : 0))) {
    points.push_back(sites_[side.site]);
  }
  const SpatialOrder order = spatial_order(points, 1);
  Result<Triangulation> mesh = delaunay_of_sites(order.sites, order.keys, 1);
  way_ = mesh ? Way::mesh : Way::line;
  if (mesh) mesh_ = std::move(*mesh).renamed(order.rows, static_cast<std::uint32_t>(points.size()));
}

/// The half-edge along the hull that ends at vertex `side`.
std::uint32_t HoleFiller::hull_edge_into(std::uint32_t side) const noexcept {
  HalfedgeId h = mesh_.outgoing(VertexId(side));
  while (mesh_.turn_ccw(h).valid()) h = mesh_.turn_ccw(h);
  return Triangulation::prev(h).index();
}

std::uint32_t HoleFiller::root_edge(std::uint32_t last) const noexcept {
  if (way_ != Way::mesh) return kNoHalfedge;
  if (unbounded_) return hull_edge_into(0);
  return mesh_.find_halfedge(VertexId(last), VertexId(0)).index();
}

/// The rest of the polygon between chain.from and its apex.
HoleFiller::Chain HoleFiller::before(Chain chain, std::uint32_t apex, std::uint32_t outer) const noexcept {
  Chain rest{chain.from, apex, outer, kNoHalfedge};
  if (way_ == Way::mesh) {
    const HalfedgeId h(chain.mesh_edge);
    const bool half_plane = mesh_.origin(h).index() == apex;
    rest.mesh_edge = half_plane ? h.index() : mesh_.twin(Triangulation::next(h)).index();
  }
  return rest;
}

/// The rest of the polygon between the apex and chain.to.
HoleFiller::Chain HoleFiller::after(Chain chain, std::uint32_t apex, std::uint32_t outer) const noexcept {
  Chain rest{apex, chain.to, outer, kNoHalfedge};
  if (way_ == Way::mesh) {
    const HalfedgeId h(chain.mesh_edge);
    const bool half_plane = mesh_.origin(h).index() == apex;
    rest.mesh_edge = half_plane ? hull_edge_into(apex) : mesh_.twin(Triangulation::prev(h)).index();
  }
  return rest;
}

void HoleFiller::fill(std::span<const HoleSide> sides, VoronoiMap& map, std::uint32_t first_vertex) {
  const auto link = [&map](std::uint32_t h, std::uint32_t g) {
    map.twin[h] = g;
    map.twin[g] = h;
  };
  const auto last = static_cast<std::uint32_t>(sides.size() - 1);
  if (last == 1) return link(sides[0].halfedge, sides[1].halfedge);
  unbounded_ = sides[last].site == kInfinity;
  way_ = Way::scan;
  if (sides.size() >= kManySides) triangulate(sides);

  std::uint32_t vertex = first_vertex;
  stack_.push_back({0, last, sides[last].halfedge, root_edge(last)});
  while (!stack_.empty()) {
    const Chain chain = stack_.back();
    stack_.pop_back();
    const std::uint32_t apex = way_ == Way::scan   ? nearest_apex(sides, chain)
                               : way_ == Way::mesh ? mesh_apex(chain)
                                                   : chain.from + 1;
    THALWEG_ASSERT(chain.from < apex && apex < chain.to);
    const std::uint32_t h = 3 * vertex++;
    map.corner[h] = sides[chain.from].site;
    map.corner[h + 1] = sides[apex].site;
    map.corner[h + 2] = sides[chain.to].site;
    link(h + 2, chain.outer);
    if (apex == chain.from + 1) {
      link(h, sides[chain.from].halfedge);
    } else {
      stack_.push_back(before(chain, apex, h));
    }
    if (chain.to == apex + 1) {
      link(h + 1, sides[apex].halfedge);
    } else {
      stack_.push_back(after(chain, apex, h + 1));
    }
  }
  THALWEG_ASSERT(vertex == first_vertex + last - 1);
}

}  // namespace thalweg::detail
