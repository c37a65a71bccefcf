/// Elevation order and the pits at the start.
#include "terrain/surface.hpp"

#include <algorithm>
#include <utility>

namespace thalweg::detail {
Surface::Surface(Array<Point2> sites, Array<double> z, Triangulation delaunay)
    : sites_(std::move(sites)),
      z_(std::move(z)),
      delaunay_(std::move(delaunay)),
      graph_(sites_, delaunay_),
      pits_(find_pits(delaunay_, z_)),
      pit_of_(sites_.size(), kNoPit),
      lowest_level_(*std::min_element(z_.begin(), z_.end())) {
  for (std::uint32_t i = 0; i < pits_.size(); ++i) {
    for (const VertexId v : pits_[i]) pit_of_[v.index()] = i;
  }
}

Triangulation Surface::release(Triangulation edited) && {
  if (!edited.is_revision()) return edited;
  delaunay_.take(std::move(edited));
  return std::move(delaunay_);
}

std::optional<Error> Surface::count_by_voronoi(unsigned k, unsigned threads) {
  auto diagram = order_k_voronoi(sites_, k, {threads});
  if (!diagram) return std::move(diagram).error();
  voronoi_.emplace(*std::move(diagram));
  graph_.count_by(*voronoi_);
  return std::nullopt;
}

Array<std::uint32_t> Surface::ranks() const {
  struct Key {
    double z;
    VertexId site;
  };
  Array<Key> keys(z_.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = {z_[i], VertexId(i)};
  std::sort(keys.begin(), keys.end(),
            [&](const Key& a, const Key& b) { return a.z != b.z ? a.z < b.z : lower(a.site, b.site); });
  Array<std::uint32_t> ranks(keys.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) ranks[keys[i].site.index()] = i;
  return ranks;
}

VertexId Surface::lowest(std::span<const VertexId> vertices) const noexcept {
  return *std::min_element(vertices.begin(), vertices.end(),
                           [&](VertexId u, VertexId v) { return lower(u, v); });
}

}  // namespace thalweg::detail
