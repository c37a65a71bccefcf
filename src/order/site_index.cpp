/// Levels of Delaunay graphs.
#include "order/site_index.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernel/delaunay_sites.hpp"
#include "kernel/spatial_order.hpp"

namespace thalweg::detail {
namespace {

constexpr std::size_t kStride = 24;
constexpr std::size_t kFewSites = 24;

/// Beyond this many radii only the direction of a query matters, for a hint.
constexpr double kFar = 1e3;

}  // namespace

void SiteIndex::join(Level& level, const Triangulation& delaunay) {
  level.starts.reserve(delaunay.vertex_count() + std::size_t{1});
  level.starts.push_back(0);
  // Euler: as many edges as vertices and faces less one, and every edge from both its ends.
  level.neighbors.reserve(2 * (std::size_t{delaunay.vertex_count()} + delaunay.face_count() - 1));
  for (std::uint32_t i = 0; i < delaunay.vertex_count(); ++i) {
    delaunay.for_each_neighbor(VertexId(i), [&](VertexId v) { level.neighbors.push_back(v.index()); });
    level.starts.push_back(static_cast<std::uint32_t>(level.neighbors.size()));
  }
}

/// Sites on one line: each has the one before it and the one after it as neighbours.
void SiteIndex::join_in_line(Level& level) {
  const auto count = static_cast<std::uint32_t>(level.sites.size());
  std::vector<std::uint32_t> sorted(count), place(count);
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::sort(sorted.begin(), sorted.end(), [&](std::uint32_t i, std::uint32_t j) {
    return lexicographically_less(level.sites[i], level.sites[j]);
  });
  for (std::uint32_t i = 0; i < count; ++i) place[sorted[i]] = i;
  level.starts.push_back(0);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (place[i] > 0) level.neighbors.push_back(sorted[place[i] - 1]);
    if (place[i] + 1 < count) level.neighbors.push_back(sorted[place[i] + 1]);
    level.starts.push_back(static_cast<std::uint32_t>(level.neighbors.size()));
  }
}

SiteIndex::SiteIndex(std::span<const Point2> sites, const Triangulation* delaunay) {
  Point2 low = sites[0], high = sites[0];
  for (const Point2 p : sites) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  centre_ = {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2};
  radius_ = std::max(high.x / 2 - low.x / 2, high.y / 2 - low.y / 2);

  levels_.emplace_back().sites.assign(sites.begin(), sites.end());
  delaunay != nullptr ? join(levels_[0], *delaunay) : join_in_line(levels_[0]);
  while (levels_.back().sites.size() > kFewSites) {
    const std::vector<Point2>& lower = levels_.back().sites;
    std::vector<Point2> sample;
    for (std::size_t i = kStride / 2; i < lower.size(); i += kStride) sample.push_back(lower[i]);
    // The order in the sample's own bounding box may differ from that in the box of all.
    const SpatialOrder order = spatial_order(sample, 1);
    Level level;
    level.sites.assign(order.sites.begin(), order.sites.end());
    for (const std::uint32_t i : order.rows)
      level.below.push_back(static_cast<std::uint32_t>(kStride / 2 + kStride * i));
    const Result<Triangulation> mesh = delaunay_of_sites(level.sites, order.keys, 1);
    mesh ? join(level, *mesh) : join_in_line(level);
    levels_.push_back(std::move(level));
  }
}

/// From site to nearest neighbour until none is nearer. Squares that overflow or are NaN end the walk.
std::uint32_t SiteIndex::descend(const Level& level, std::uint32_t site, Point2 q) noexcept {
  const auto distance = [&](std::uint32_t s) {
    const double x = level.sites[s].x - q.x, y = level.sites[s].y - q.y;
    return x * x + y * y;
  };
  double nearest = distance(site);
  for (;;) {
    std::uint32_t best = site;
    for (std::uint32_t i = level.starts[site]; i < level.starts[site + 1]; ++i) {
      const double d = distance(level.neighbors[i]);
      if (d < nearest) {
        nearest = d;
        best = level.neighbors[i];
      }
    }
    if (best == site) return site;
    site = best;
  }
}

std::uint32_t SiteIndex::near(Point2 q) const noexcept {
  const double x = q.x / 2 - centre_.x / 2, y = q.y / 2 - centre_.y / 2;
  const double far = std::max(std::fabs(x), std::fabs(y));
  if (far > kFar * radius_ && far < HUGE_VAL) {
    const double reach = kFar * radius_;
    q = {centre_.x + x / far * reach, centre_.y + y / far * reach};
  }
  std::uint32_t site = 0;
  for (std::size_t i = levels_.size(); i-- > 0;) {
    site = descend(levels_[i], site, q);
    if (i > 0) site = levels_[i].below[site];
  }
  return site;
}

std::size_t SiteIndex::memory_bytes() const noexcept {
  std::size_t bytes = 0;
  for (const Level& level : levels_) {
    bytes += level.sites.capacity() * sizeof(Point2) +
             4 * (level.starts.capacity() + level.neighbors.capacity() + level.below.capacity());
  }
  return bytes;
}

}  // namespace thalweg::detail
