/// Point location in the order-k Voronoi diagram: points, circumcentres, and counting with it.
///
/// The walk. A cell is the intersection of the half-planes of its edges: a point outside it is nearer to the
/// gain of some edge than to its loss. Crossing that edge replaces a site by a nearer one, so no cell is met
/// twice and the walk ends, whatever path it takes.
#include <algorithm>
#include <cmath>

#include "kernel/assert.hpp"
#include "kernel/centre_distance.hpp"
#include "kernel/parallel.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/spatial_order.hpp"
#include "order/circle_plane.hpp"
#include "order/site_index.hpp"
#include "order/voronoi_builder.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/voronoi_counter.hpp"

namespace thalweg {
namespace {

/// Compares distances to a point; ties as the perturbation has them.
struct NearerToPoint {
  std::span<const Point2> sites;
  Point2 q;

  bool operator()(std::uint32_t s, std::uint32_t t) const noexcept {
    const int sign = detail::compare_distance_sign(q, sites[s], sites[t]);
    return sign != 0 ? sign < 0 : detail::lexicographically_less(sites[s], sites[t]);
  }
};

struct NearerToCentre {
  std::span<const Point2> sites;
  detail::CircleCentre centre;

  bool operator()(std::uint32_t s, std::uint32_t t) const noexcept {
    const int sign = centre.compare(sites[s], sites[t]);
    return sign != 0 ? sign < 0 : detail::lexicographically_less(sites[s], sites[t]);
  }
};

}  // namespace

template <class Nearer>
std::uint32_t OrderKVoronoi::walk(std::uint32_t cell, Nearer&& nearer) const {
  for (std::uint32_t h = first_[cell]; h < first_[cell + 1];) {
    const Halfedge& halfedge = halfedges_[h];
    if (halfedge.gain != kNone && nearer(halfedge.gain, halfedge.loss)) {
      cell = halfedge.across;
      h = first_[cell];
    } else {
      ++h;
    }
  }
  return cell;
}

CellId OrderKVoronoi::locate(Point2 q) const {
  THALWEG_ASSERT(std::isfinite(q.x) && std::isfinite(q.y));
  return CellId(walk(cell_at_[index_->near(q)], NearerToPoint{index_->sites(), q}));
}

CellId OrderKVoronoi::locate_centre(VertexId u, VertexId v, VertexId w) const {
  const detail::CircleCentre centre(point(u), point(v), point(w));
  Point2 guess = centre.rounded();
  if (!std::isfinite(guess.x) || !std::isfinite(guess.y)) guess = point(u);
  return CellId(walk(cell_at_[index_->near(guess)], NearerToCentre{index_->sites(), centre}));
}

std::vector<VertexId> OrderKVoronoi::nearest(Point2 q) const {
  const std::span<const VertexId> set = sites(locate(q));
  std::vector<VertexId> result(set.begin(), set.end());
  std::sort(result.begin(), result.end(), [&](VertexId s, VertexId t) {
    const int sign = detail::compare_distance_sign(q, point(s), point(t));
    return sign != 0 ? sign < 0 : detail::lexicographically_less(point(s), point(t));
  });
  return result;
}

unsigned VoronoiCounter::count_in_circle(VertexId u, VertexId v, VertexId w, unsigned limit) {
  THALWEG_ASSERT(limit < diagram_->order() || diagram_->order() == diagram_->site_count());
  ++calls_;
  const detail::CirclePlane circle(diagram_->point(u), diagram_->point(v), diagram_->point(w));
  inside_.clear();
  for (const VertexId site : diagram_->sites(diagram_->locate_centre(u, v, w))) {
    if (site == u || site == v || site == w || !circle.holds(diagram_->point(site))) continue;
    inside_.push_back(site);
    if (inside_.size() > limit) break;
  }
  return static_cast<unsigned>(inside_.size());
}

namespace detail {

/// Neighbours in spatial order are near each other: each walk starts where the one before ended.
void VoronoiBuilder::locate_sites(OrderKVoronoi& diagram, unsigned threads) {
  const std::span<const Point2> sites = diagram.index_->sites();
  constexpr std::size_t kChunk = 1 << 14;
  diagram.cell_at_.resize(sites.size());
  parallel_chunks(sites.size(), kChunk, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      std::uint32_t cell = 0;
      for (std::size_t s = begin; s < end; ++s) {
        cell = diagram.walk(cell, NearerToPoint{sites, sites[s]});
        diagram.cell_at_[s] = cell;
      }
    };
  });
}

}  // namespace detail

}  // namespace thalweg
