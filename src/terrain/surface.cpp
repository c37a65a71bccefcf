/// Elevation order and the pits at the start.
#include "terrain/surface.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "kernel/parallel.hpp"
#include "kernel/radix_sort.hpp"

namespace thalweg::detail {
namespace {

/// The upper half of a finite number, as an integer that grows with it.
std::uint32_t upper_half(double z) noexcept {
  constexpr std::uint32_t kSign = 0x80000000u;
  const auto bits = static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(z + 0.0) >> 32);  // -0.0 as 0.0
  return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

}  // namespace

Surface::Surface(Array<Point2> sites, Array<double> z, Triangulation delaunay, unsigned threads)
    : sites_(std::move(sites)), z_(std::move(z)), delaunay_(std::move(delaunay)) {
  parallel_both(
      threads, [this] { graph_.emplace(sites_, delaunay_); }, [this] { note_pits(); });
}

void Surface::note_pits() {
  lowest_level_ = *std::min_element(z_.begin(), z_.end());
  pits_ = find_pits(delaunay_, z_);
  pit_of_.assign(sites_.size(), kNoPit);
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
  graph_->count_by(*voronoi_);
  return std::nullopt;
}

Array<std::uint32_t> Surface::ranks(unsigned threads) const {
  Array<KeyedRow> order(z_.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = keyed_row(upper_half(z_[i]), i);
  radix_sort(order, threads);
  sort_runs(order, [&](std::uint32_t a, std::uint32_t b) { return lower(VertexId(a), VertexId(b)); });
  Array<std::uint32_t> ranks(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) ranks[row_of(order[i])] = i;
  return ranks;
}

VertexId Surface::lowest(std::span<const VertexId> vertices) const noexcept {
  return *std::min_element(vertices.begin(), vertices.end(),
                           [&](VertexId u, VertexId v) { return lower(u, v); });
}

}  // namespace thalweg::detail
