/// Pits by flooding flats: each flat once, all of it or until it drains.
#include "thalweg/pits.hpp"

#include <algorithm>

#include "kernel/assert.hpp"

namespace thalweg {

PitCount Pits::count() const noexcept {
  PitCount count;
  count.total = size();
  for (const std::uint8_t b : boundary_) count.boundary += b != 0 ? 1u : 0u;
  count.interior = count.total - count.boundary;
  return count;
}

void Pits::add(std::span<const VertexId> vertices, bool boundary) {
  vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
  starts_.push_back(static_cast<std::uint32_t>(vertices_.size()));
  boundary_.push_back(boundary ? 1 : 0);
}

Pits find_pits(const Triangulation& terrain, std::span<const double> z) {
  THALWEG_ASSERT(z.size() == terrain.vertex_count());
  Pits pits;
  std::vector<std::uint8_t> seen(terrain.vertex_count(), 0);
  std::vector<VertexId> flat;
  for (std::uint32_t i = 0; i < terrain.vertex_count(); ++i) {
    if (seen[i] != 0 || terrain.isolated(VertexId(i))) continue;
    // The whole flat is flooded even after it has been seen to drain, so that no vertex is taken up twice.
    seen[i] = 1;
    flat.assign(1, VertexId(i));
    bool drains = false, boundary = false;
    for (std::size_t head = 0; head < flat.size(); ++head) {
      boundary = boundary || terrain.on_hull(flat[head]);
      terrain.for_each_neighbor(flat[head], [&](VertexId v) {
        if (z[v.index()] < z[i]) drains = true;
        if (z[v.index()] == z[i] && seen[v.index()] == 0) {
          seen[v.index()] = 1;
          flat.push_back(v);
        }
      });
    }
    if (drains) continue;
    std::sort(flat.begin(), flat.end());
    pits.add(flat, boundary);
  }
  return pits;
}

}  // namespace thalweg
