/// Elevation order and the pits at the start.
#include "terrain/surface.hpp"

#include <algorithm>
#include <utility>

#include "kernel/huge_pages.hpp"

namespace thalweg::detail {
Surface::Surface(std::vector<Point2> sites, std::vector<double> z, Triangulation delaunay)
    : sites_(std::move(sites)),
      z_(std::move(z)),
      delaunay_(std::move(delaunay)),
      graph_(sites_, delaunay_),
      pits_(find_pits(delaunay_, z_)),
      pit_of_(large_vector<std::uint32_t>(sites_.size())),
      lowest_level_(*std::min_element(z_.begin(), z_.end())) {
  std::fill(pit_of_.begin(), pit_of_.end(), kNoPit);
  for (std::uint32_t i = 0; i < pits_.size(); ++i) {
    for (const VertexId v : pits_[i]) pit_of_[v.index()] = i;
  }
}

std::optional<Error> Surface::count_by_voronoi(unsigned k, unsigned threads) {
  auto diagram = order_k_voronoi(sites_, k, {threads});
  if (!diagram) return std::move(diagram).error();
  voronoi_.emplace(*std::move(diagram));
  graph_.count_by(*voronoi_);
  return std::nullopt;
}

std::vector<std::uint32_t> Surface::ranks() const {
  struct Key {
    double z;
    VertexId site;
  };
  std::vector<Key> keys(z_.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = {z_[i], VertexId(i)};
  std::sort(keys.begin(), keys.end(),
            [&](const Key& a, const Key& b) { return a.z != b.z ? a.z < b.z : lower(a.site, b.site); });
  std::vector<std::uint32_t> ranks(keys.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) ranks[keys[i].site.index()] = i;
  return ranks;
}

VertexId Surface::lowest(std::span<const VertexId> vertices) const noexcept {
  return *std::min_element(vertices.begin(), vertices.end(),
                           [&](VertexId u, VertexId v) { return lower(u, v); });
}

}  // namespace thalweg::detail
