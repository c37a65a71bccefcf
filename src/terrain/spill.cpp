/// Spill levels: the terrain is flooded from below, and where two lakes meet the one with the higher bottom
/// has found its way out.
#include <algorithm>
#include <limits>
#include <numeric>

#include "kernel/assert.hpp"
#include "terrain/disjoint_sets.hpp"
#include "thalweg/drainage.hpp"

namespace thalweg {

std::vector<double> spill_levels(const Triangulation& terrain, std::span<const Point3> points,
                                 const Pits& pits) {
  THALWEG_ASSERT(points.size() == terrain.vertex_count());
  const auto count = static_cast<std::uint32_t>(points.size());
  std::vector<std::uint32_t> order(count), rank(count);
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t u, std::uint32_t v) {
    const Point3 &p = points[u], &q = points[v];
    if (p.z != q.z) return p.z < q.z;
    return p.x != q.x ? p.x < q.x : p.y < q.y;
  });
  for (std::uint32_t i = 0; i < count; ++i) rank[order[i]] = i;

  // Sets of ranks: the root of a set, its smallest member, is its bottom.
  detail::DisjointSets lakes(count);
  std::vector<double> level(count, std::numeric_limits<double>::infinity());
  for (std::uint32_t i = 0; i < count; ++i) {
    if (terrain.isolated(VertexId(order[i]))) continue;
    terrain.for_each_neighbor(VertexId(order[i]), [&](VertexId w) {
      const std::uint32_t j = rank[w.index()];
      if (j > i) return;
      const std::uint32_t mine = lakes.find(i), other = lakes.find(j);
      if (mine != other) level[std::max(mine, other)] = points[order[i]].z;
      lakes.join(mine, other);
    });
  }
  std::vector<double> result;
  result.reserve(pits.size());
  for (std::uint32_t i = 0; i < pits.size(); ++i) {
    std::uint32_t bottom = count;
    for (const VertexId v : pits[i]) bottom = std::min(bottom, rank[v.index()]);
    result.push_back(level[bottom]);
  }
  return result;
}

}  // namespace thalweg
