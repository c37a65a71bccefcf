/// Counting sites in a circle by a search of the Delaunay graph.
///
/// Why the search is complete. Lift every site to the paraboloid; the sites strictly inside a circle are
/// those below a plane, and the triangulation is the lower hull of the lifted sites, those on one empty
/// circle lifted a little further, by infinitesimal amounts, to choose its diagonals. On a lower hull every
/// vertex that does not minimise a linear function has a neighbour where that function is smaller. So from
/// every site below the plane a path of edges descends, relative to the plane, to the lowest one; an
/// infinitesimal lift turns no strict "below" around, so the path stays below: the sites inside induce a
/// connected graph. It remains to enter it from a corner u of the triangle. Grow a circle inside the given
/// one, touching it at u, from nothing until sites lie on it; they are strictly inside the given one. It is
/// empty, so its sites are the corners of a convex polygon whose sides are in every Delaunay triangulation,
/// and u is a corner.
#include "thalweg/circle_count.hpp"

#include <algorithm>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "order/circle_plane.hpp"

namespace thalweg {

DelaunayGraph::DelaunayGraph(std::span<const Point2> sites, const Triangulation& delaunay)
    : sites_(sites), delaunay_(&delaunay) {
  THALWEG_ASSERT(sites.size() == delaunay.vertex_count());
  const std::uint32_t count = delaunay.vertex_count();
  starts_.resize(count + std::size_t{1});
  starts_[0] = 0;
  // Every edge once from each of its half-edges, and a hull edge once more from its only one.
  neighbors_.reserve(delaunay.halfedge_count() + std::size_t{count} / 16);
  for (std::uint32_t i = 0; i < count; ++i) {
    delaunay.for_each_neighbor(VertexId(i), [&](VertexId v) { neighbors_.push_back(v); });
    starts_[i + 1] = static_cast<std::uint32_t>(neighbors_.size());
  }
}

CircleCounter::CircleCounter(const DelaunayGraph& graph) : graph_(&graph), stamp_(graph.sites().size(), 0u) {
  if (graph.voronoi() != nullptr) located_.emplace(*graph.voronoi());
}

unsigned CircleCounter::count_in_circle(VertexId u, VertexId v, VertexId w, unsigned limit,
                                        std::span<const VertexId> known) {
  ++calls_;
  const OrderKVoronoi* diagram = graph_->voronoi();
  const bool is_deep_enough =
      diagram != nullptr && (limit < diagram->order() || diagram->order() == diagram->site_count());
  if (!is_deep_enough) return crawl(u, v, w, limit, known);
  const unsigned count = located_->count_in_circle(u, v, w, limit);
  inside_count_ = located_->inside().size();
  make_room(1 + inside_count_);
  std::copy(located_->inside().begin(), located_->inside().end(), queue_.begin() + 1);
  return count;
}

/// Lets both lists hold so many vertices, whatever they hold now.
void CircleCounter::make_room(std::size_t size) {
  if (size <= queue_.size()) return;
  queue_.resize(2 * size);
  fresh_.resize(2 * size);
}

unsigned CircleCounter::crawl(VertexId u, VertexId v, VertexId w, unsigned limit,
                              std::span<const VertexId> known) {
  if (++epoch_ == 0) {
    std::fill(stamp_.begin(), stamp_.end(), 0);
    epoch_ = 1;
  }
  const detail::CirclePlane circle(graph_->point(u), graph_->point(v), graph_->point(w));
  THALWEG_ASSERT(detail::orient2d_sign(graph_->point(u), graph_->point(v), graph_->point(w)) > 0);
  // Copies, which the compiler can keep in registers: no store can change them.
  const std::uint32_t epoch = epoch_;
  std::uint32_t* const stamp = stamp_.data();
  const Point2* const sites = graph_->sites().data();
  stamp[u.index()] = stamp[v.index()] = stamp[w.index()] = epoch;

  make_room(1 + known.size());
  queue_[0] = u;
  std::size_t size = 1;
  for (const VertexId site : known) {
    if (stamp[site.index()] == epoch) continue;
    THALWEG_ASSERT(circle.holds(graph_->point(site)));
    stamp[site.index()] = epoch;
    queue_[size++] = site;
  }
  // The sites inside are connected: a corner is only needed to find the first of them.
  for (std::size_t head = size == 1 ? 0 : 1; head < size && size - 1 <= limit; ++head) {
    // Which neighbours are new, and which of these are inside, is a toss of a coin: both are appended without
    // a branch on it.
    const auto neighbors = graph_->neighbors(queue_[head]);
    make_room(size + neighbors.size());
    VertexId* const fresh = fresh_.data();
    std::size_t fresh_count = 0;
    for (const VertexId site : neighbors) {
      fresh[fresh_count] = site;
      fresh_count += stamp[site.index()] != epoch ? 1 : 0;
      stamp[site.index()] = epoch;
    }
    VertexId* const queue = queue_.data();
    for (std::size_t i = 0; i < fresh_count; ++i) {
      queue[size] = fresh[i];
      size += circle.holds(sites[fresh[i].index()]) ? 1 : 0;
    }
  }
  inside_count_ = size - 1;
  return static_cast<unsigned>(std::min<std::size_t>(inside_count_, limit + std::size_t{1}));
}

std::vector<std::uint32_t> face_orders(const DelaunayGraph& graph, const Triangulation& triangulation,
                                       unsigned limit, unsigned threads) {
  std::vector<std::uint32_t> orders(triangulation.face_count());
  constexpr std::size_t kChunk = 1 << 14;
  detail::parallel_chunks(orders.size(), kChunk, threads, [&] {
    return [&, counter = CircleCounter(graph)](std::size_t begin, std::size_t end) mutable {
      for (std::size_t i = begin; i < end; ++i) {
        const Triangle t = triangulation.corners(FaceId(static_cast<std::uint32_t>(i)));
        orders[i] = counter.count_in_circle(t[0], t[1], t[2], limit);
      }
    };
  });
  return orders;
}

}  // namespace thalweg
