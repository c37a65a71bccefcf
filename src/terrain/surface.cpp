/// Elevation order and the pits at the start.
#include "terrain/surface.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace thalweg::detail {
namespace {

std::vector<std::uint32_t> ranks_of(std::span<const Point2> sites, std::span<const double> z) {
  struct Key {
    double z;
    std::uint32_t site;
  };
  std::vector<Key> keys(z.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) keys[i] = {z[i], i};
  std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if (a.z != b.z) return a.z < b.z;
    const Point2 p = sites[a.site], q = sites[b.site];
    return std::tie(p.x, p.y) < std::tie(q.x, q.y);
  });
  std::vector<std::uint32_t> ranks(keys.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) ranks[keys[i].site] = i;
  return ranks;
}

}  // namespace

Surface::Surface(std::vector<Point2> sites, std::vector<double> z, Triangulation delaunay)
    : sites_(std::move(sites)),
      z_(std::move(z)),
      delaunay_(std::move(delaunay)),
      graph_(sites_, delaunay_),
      rank_(ranks_of(sites_, z_)),
      pits_(find_pits(delaunay_, z_)),
      pit_of_(sites_.size(), kNoPit) {
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

VertexId Surface::lowest(std::span<const VertexId> vertices) const noexcept {
  return *std::min_element(vertices.begin(), vertices.end(),
                           [&](VertexId u, VertexId v) { return lower(u, v); });
}

}  // namespace thalweg::detail
