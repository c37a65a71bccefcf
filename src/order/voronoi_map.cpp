/// The step from one order of the Voronoi diagram to the next.
#include "order/voronoi_map.hpp"

#include <algorithm>
#include <numeric>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "order/voronoi_hole.hpp"

namespace thalweg::detail {
namespace {

/// Half-edges that one thread looks at before it asks for more.
constexpr std::size_t kMapChunk = 3 << 13;

/// The polygon of the sites gained around the cell of h, infinity last.
///
/// From a new vertex a0, a1, a2 the cell I + a[s+1], that left of slot s, gains a[s+2] on the edge before and
/// a[s] on the edge after: between them lies the vertex's old edge on the bisector of the two, slot s + 2.
void collect_sides(const VoronoiMap& map, std::uint32_t first, std::vector<HoleSide>& sides) {
  sides.clear();
  std::uint32_t h = first;
  do {
    if (map.is_new(h)) {
      const std::uint32_t slot = VoronoiMap::turn_cw(h);
      sides.push_back({map.corner[slot], slot - 3 * map.old_count});
    }
    h = map.next(h);
  } while (h != first);
  const auto infinity =
      std::find_if(sides.begin(), sides.end(), [](const HoleSide& s) { return s.site == kInfinity; });
  if (infinity != sides.end()) std::rotate(sides.begin(), infinity + 1, sides.end());
  THALWEG_ASSERT(sides.size() >= 2);
}

/// The cells whose lowest half-edge out of a new vertex is in one chunk, and how many vertices they will have
/// inside.
struct CellChunk {
  std::vector<std::uint32_t> first;
  std::uint64_t vertices = 0;
};

/// Every cell has at least two half-edges out of new vertices, one for each side of its hole: to look at
/// these suffices. What the walk around one cell has seen of the chunk need not be looked at again.
void find_cells_from(const VoronoiMap& map, std::size_t begin, std::size_t end, std::vector<char>& seen,
                     CellChunk& chunk) {
  seen.assign(end - begin, 0);
  for (std::size_t h = begin; h < end; ++h) {
    const auto first = static_cast<std::uint32_t>(h);
    if (seen[h - begin] != 0 || map.outside(first)) continue;
    std::uint64_t sides = 1;
    std::uint32_t lowest = first;
    for (std::uint32_t g = map.next(first); g != first; g = map.next(g)) {
      if (!map.is_new(g)) continue;
      ++sides;
      lowest = std::min(lowest, g);
      if (g >= begin && g < end) seen[g - begin] = 1;
    }
    if (lowest != first) continue;
    chunk.first.push_back(first);
    chunk.vertices += sides - 2;
  }
}

std::vector<CellChunk> find_cells(const VoronoiMap& map, unsigned threads) {
  const std::size_t offset = 3 * std::size_t{map.old_count};
  const std::size_t count = map.twin.size() - offset;
  std::vector<CellChunk> chunks((count + kMapChunk - 1) / kMapChunk);
  parallel_chunks(count, kMapChunk, threads, [&] {
    return [&, seen = std::vector<char>()](std::size_t begin, std::size_t end) mutable {
      find_cells_from(map, offset + begin, offset + end, seen, chunks[begin / kMapChunk]);
    };
  });
  return chunks;
}

}  // namespace

VoronoiMap first_order(const Triangulation& delaunay) {
  VoronoiMap map;
  map.corner.assign(delaunay.origins().begin(), delaunay.origins().end());
  map.twin.assign(delaunay.twins().begin(), delaunay.twins().end());

  // Along the hull, edge u -> v has the half-plane v, u, infinity; the next one along starts with the edge's
  // second site, so that slot 1 of the one meets slot 2 of the other.
  std::uint32_t h = 0;
  while (h < delaunay.halfedge_count() && !delaunay.on_hull(HalfedgeId(h))) ++h;
  const std::uint32_t first_ghost = map.vertex_count();
  const HalfedgeId first(h);
  HalfedgeId edge = first;
  do {
    const auto ghost = static_cast<std::uint32_t>(map.corner.size());
    const bool start = ghost == 3 * first_ghost;
    map.corner.insert(map.corner.end(),
                      {delaunay.dest(edge).index(), delaunay.origin(edge).index(), kInfinity});
    map.twin.insert(map.twin.end(), {edge.index(), start ? kNoHalfedge : ghost - 1, kNoHalfedge});
    map.twin[edge.index()] = ghost;
    if (!start) map.twin[ghost - 1] = ghost + 1;
    edge = delaunay.outgoing(delaunay.dest(edge));
  } while (edge != first);
  map.twin[3 * first_ghost + 1] = static_cast<std::uint32_t>(map.twin.size() - 1);
  map.twin.back() = 3 * first_ghost + 1;
  return map;
}

VoronoiMap next_order(const VoronoiMap& map, std::span<const Point2> sites, unsigned threads) {
  const std::vector<CellChunk> chunks = find_cells(map, threads);
  VoronoiMap result;
  result.old_count = map.vertex_count() - map.old_count;
  std::vector<std::uint64_t> starts(chunks.size() + 1, result.old_count);
  for (std::size_t i = 0; i < chunks.size(); ++i) starts[i + 1] = starts[i] + chunks[i].vertices;
  if (starts.back() >= kNoHalfedge / 3) return {};
  const auto halfedges = static_cast<std::size_t>(3 * starts.back());
  result.corner.reserve(halfedges);
  result.corner.assign(map.corner.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{map.old_count}),
                       map.corner.end());
  result.corner.resize(halfedges);
  result.twin.assign(halfedges, kNoHalfedge);

  parallel_chunks(chunks.size(), 1, threads, [&] {
    return [&, filler = HoleFiller(sites), sides = std::vector<HoleSide>()](std::size_t begin,
                                                                            std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        auto vertex = static_cast<std::uint32_t>(starts[i]);
        for (const std::uint32_t first : chunks[i].first) {
          collect_sides(map, first, sides);
          filler.fill(sides, result, vertex);
          vertex += static_cast<std::uint32_t>(sides.size() - 2);
        }
      }
    };
  });
  return result;
}

}  // namespace thalweg::detail
