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
  // Should memory end in the middle, what was added is the end of the arrays and goes again.
  const std::size_t before = vertices_.size(), pits = boundary_.size();
  try {
    vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
    starts_.push_back(static_cast<std::uint32_t>(vertices_.size()));
    boundary_.push_back(boundary ? 1 : 0);
  } catch (...) {
    vertices_.resize(before);
    starts_.resize(pits + 1);
    throw;
  }
}

namespace {

/// Which vertices have a strictly lower neighbour. One pass over the half-edges in the order of memory: most
/// vertices drain like this, and are spared a walk round them.
std::vector<std::uint8_t> have_lower_neighbor(const Triangulation& terrain, std::span<const double> z) {
  std::vector<std::uint8_t> drains(terrain.vertex_count(), 0);
  for (std::uint32_t f = 0; f < terrain.face_count(); ++f) {
    const Triangle corners = terrain.corners(FaceId(f));
    const std::uint32_t a = corners[0].index(), b = corners[1].index(), c = corners[2].index();
    const double least = std::min({z[a], z[b], z[c]});
    drains[a] |= static_cast<std::uint8_t>(z[a] > least);
    drains[b] |= static_cast<std::uint8_t>(z[b] > least);
    drains[c] |= static_cast<std::uint8_t>(z[c] > least);
  }
  return drains;
}

}  // namespace

Pits find_pits(const Triangulation& terrain, std::span<const double> z) {
  THALWEG_ASSERT(z.size() == terrain.vertex_count());
  Pits pits;
  const std::vector<std::uint8_t> drains_alone = have_lower_neighbor(terrain, z);
  std::vector<std::uint8_t> seen(terrain.vertex_count(), 0);
  std::vector<VertexId> flat;
  for (std::uint32_t i = 0; i < terrain.vertex_count(); ++i) {
    if (drains_alone[i] != 0 || seen[i] != 0 || terrain.isolated(VertexId(i))) continue;
    // The whole flat is flooded even after it has been seen to drain, so that no vertex is taken up twice.
    seen[i] = 1;
    flat.assign(1, VertexId(i));
    bool drains = false, boundary = false;
    for (std::size_t head = 0; head < flat.size(); ++head) {
      boundary = boundary || terrain.on_hull(flat[head]);
      drains = drains || drains_alone[flat[head].index()] != 0;
      terrain.for_each_neighbor(flat[head], [&](VertexId v) {
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
