/// Building the order-k Voronoi diagram, and reading it.
#include "thalweg/order_k_voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "kernel/delaunay_sites.hpp"
#include "kernel/parallel.hpp"
#include "kernel/spatial_order.hpp"
#include "order/voronoi_builder.hpp"

namespace thalweg {
namespace detail {
namespace {

/// The diagram of sites on one line, fewer than all of them a cell: the cells are strips between parallel
/// lines, one for each k consecutive sites. Line i, between the sets from site i and from site i + 1, has a
/// vertex at infinity at each end: 2 i on the left of the direction from its loss to its gain, 2 i + 1 on the
/// right.
VoronoiMap strips(std::span<const std::uint32_t> along, unsigned k) {
  VoronoiMap map;
  const auto lines = static_cast<std::uint32_t>(along.size() - k);
  map.twin.resize(6 * std::size_t{lines});
  const auto link = [&map](std::uint32_t h, std::uint32_t g) {
    map.twin[h] = g;
    map.twin[g] = h;
  };
  for (std::uint32_t i = 0; i < lines; ++i) {
    const std::uint32_t left = 6 * i, right = 6 * i + 3;
    map.corner.insert(map.corner.end(),
                      {along[i], along[i + k], kInfinity, along[i + k], along[i], kInfinity});
    link(left, right);
    if (i == 0) {
      link(left + 2, right + 1);
    } else {
      link(left + 2, left - 6 + 1);
      link(right + 1, right - 6 + 2);
    }
    if (i + 1 == lines) link(left + 1, right + 2);
  }
  return map;
}

std::vector<std::uint32_t> along_the_line(std::span<const Point2> sites) {
  std::vector<std::uint32_t> along(sites.size());
  std::iota(along.begin(), along.end(), 0u);
  std::sort(along.begin(), along.end(),
            [&](std::uint32_t i, std::uint32_t j) { return lexicographically_less(sites[i], sites[j]); });
  return along;
}

void build_in_line(OrderKVoronoi& diagram, std::span<const Point2> sites,
                   std::span<const std::uint32_t> rows) {
  const std::vector<std::uint32_t> along = along_the_line(sites);
  VoronoiBuilder::take_map(diagram, strips(along, diagram.order()));
  std::vector<VertexId> set;
  for (unsigned i = 0; i < diagram.order(); ++i) set.emplace_back(rows[along[i]]);
  std::sort(set.begin(), set.end());
  // The lowest half-edge beside a strip but the first is slot 0 of its line; that of the first is slot 2 of
  // the first line, and so its strip is the second found.
  VoronoiBuilder::spread_sets(diagram, 1, std::move(set));
}

/// False if ids do not suffice.
bool build(OrderKVoronoi& diagram, std::span<const Point2> sites, const Triangulation& delaunay,
           unsigned threads) {
  VoronoiMap map = first_order(delaunay);
  for (unsigned i = 1; i < diagram.order(); ++i) {
    map = next_order(map, sites, threads);
    if (map.corner.empty()) return false;
  }
  VoronoiBuilder::take_map(diagram, std::move(map));
  VoronoiHalfedgeId h(0);
  while (diagram.at_infinity(h) || diagram.at_infinity(diagram.origin(h)))
    h = VoronoiHalfedgeId(h.index() + 1);
  VoronoiBuilder::spread_sets(diagram, diagram.face(h).index(), VoronoiBuilder::set_of(diagram, h));
  return true;
}

Error too_many(std::size_t count, unsigned k) {
  return {ErrorCode::too_many_points, "the Voronoi diagram of order " + std::to_string(k) + " of " +
                                          std::to_string(count) +
                                          " points has more half-edges than ids can number"};
}

}  // namespace
}  // namespace detail

Result<OrderKVoronoi> order_k_voronoi(std::span<const Point2> points, unsigned k,
                                      const OrderKVoronoiOptions& options) {
  using namespace detail;
  if (points.size() >= VertexId::kInvalid) return too_many(points.size(), k);
  std::vector<std::uint32_t> culprits;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) culprits.push_back(i);
  }
  if (!culprits.empty()) {
    return Error{
        ErrorCode::not_finite,
        std::to_string(culprits.size()) + " of the points have a coordinate that is not a finite number",
        std::move(culprits)};
  }
  const TeamScope team(resolve_threads(options.threads));
  const SpatialOrder order = spatial_order(points, options.threads);
  std::vector<std::uint32_t> rows(order.site_count());
  for (std::uint32_t s = 0; s < rows.size(); ++s) rows[s] = order.first_row(s);
  const std::span<const Point2> sites = order.sites;
  if (k == 0 || k > sites.size()) {
    return Error{k == 0 ? ErrorCode::invalid_argument : ErrorCode::too_few_points,
                 "the order of a Voronoi diagram of " + std::to_string(sites.size()) +
                     " distinct points is 1 to as many, not " + std::to_string(k)};
  }
  const Result<Triangulation> delaunay = delaunay_of_sites(sites, order.keys, options.threads);
  if (!delaunay && delaunay.error().code == ErrorCode::too_many_points) return delaunay.error();
  auto index = std::make_shared<const SiteIndex>(sites, delaunay ? &*delaunay : nullptr);
  OrderKVoronoi diagram = VoronoiBuilder::start(points, rows, k, std::move(index));
  if (k == sites.size()) {
    VoronoiBuilder::one_cell(diagram);
  } else if (!delaunay) {
    build_in_line(diagram, sites, rows);
  } else if (!build(diagram, sites, *delaunay, options.threads)) {
    return too_many(sites.size(), k);
  }
  VoronoiBuilder::locate_sites(diagram, options.threads);
  return diagram;
}

bool OrderKVoronoi::unbounded(CellId c) const noexcept {
  if (!halfedge(c).valid()) return true;
  bool result = false;
  for_each_halfedge(c, [&](VoronoiHalfedgeId h) { result = result || at_infinity(h); });
  return result;
}

// Before and after a new vertex the cell loses the same site, before and after an old one it gains the same.
Triangle OrderKVoronoi::circle(VoronoiVertexId v) const noexcept {
  const VoronoiHalfedgeId out = outgoing(v), in = prev(out);
  if (at_infinity(in)) return {gain(out), loss(out), VertexId()};
  if (loss(in) == loss(out)) return {gain(out), loss(out), gain(in)};
  return {loss(out), gain(out), loss(in)};
}

std::vector<std::pair<VertexId, VertexId>> OrderKVoronoi::delaunay_edges() const {
  std::vector<std::pair<VertexId, VertexId>> pairs;
  pairs.reserve(halfedges_.size() / 2);
  for (std::uint32_t h = 0; h < halfedges_.size(); ++h) {
    const VoronoiHalfedgeId halfedge(h);
    if (h > halfedges_[h].twin || at_infinity(halfedge)) continue;
    pairs.emplace_back(std::minmax(gain(halfedge), loss(halfedge)));
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::size_t OrderKVoronoi::memory_bytes() const noexcept {
  const auto bytes = [](const auto& array) { return array.capacity() * sizeof(array[0]); };
  return bytes(points_) + bytes(rows_) + bytes(first_) + bytes(halfedges_) + bytes(origin_) +
         bytes(outgoing_) + bytes(sets_) + bytes(cell_at_) + index_->memory_bytes();
}

}  // namespace thalweg
