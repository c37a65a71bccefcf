/// Crossing pairs by a sweep over extents, decided by exact orientation.
#include "terrain/crossings.hpp"

#include <algorithm>

#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {

bool cross_properly(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  return orient2d_sign(a, b, c) * orient2d_sign(a, b, d) < 0 &&
         orient2d_sign(c, d, a) * orient2d_sign(c, d, b) < 0;
}

Crossings::Crossings(const Surface& surface, std::span<const UnitExit> exits) : count_(exits.size()) {
  struct Extent {
    double x_min, x_max, y_min, y_max;
    std::uint32_t exit;
  };
  const auto at = [&](VertexId v) { return surface.sites()[v.index()]; };
  std::vector<Extent> extents;
  for (std::uint32_t i = 0; i < exits.size(); ++i) {
    const auto [x0, x1] = std::minmax(at(exits[i].exit.from).x, at(exits[i].exit.to).x);
    const auto [y0, y1] = std::minmax(at(exits[i].exit.from).y, at(exits[i].exit.to).y);
    extents.push_back({x0, x1, y0, y1, i});
  }
  std::sort(extents.begin(), extents.end(), [](const Extent& a, const Extent& b) {
    return a.x_min != b.x_min ? a.x_min < b.x_min : a.exit < b.exit;
  });
  std::vector<Extent> open;  // those that may reach the current one
  for (const Extent& e : extents) {
    std::erase_if(open, [&](const Extent& other) { return other.x_max < e.x_min; });
    for (const Extent& other : open) {
      if (other.y_max < e.y_min || e.y_max < other.y_min) continue;
      const Exit &f = exits[e.exit].exit, &g = exits[other.exit].exit;
      const bool same = f.from == g.to && f.to == g.from;
      if (same || cross_properly(at(f.from), at(f.to), at(g.from), at(g.to))) {
        pairs_.emplace_back(e.exit, other.exit);
        pairs_.emplace_back(other.exit, e.exit);
      }
    }
    open.push_back(e);
  }
  pack();
}

void Crossings::add(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs) {
  for (const auto& [a, b] : pairs) {
    pairs_.emplace_back(a, b);
    pairs_.emplace_back(b, a);
  }
  pack();
}

void Crossings::pack() {
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
  starts_.assign(count_ + 1, 0);
  others_.clear();
  for (const auto& [a, b] : pairs_) {
    ++starts_[a + std::size_t{1}];
    others_.push_back(b);
  }
  for (std::size_t i = 0; i < count_; ++i) starts_[i + 1] += starts_[i];
}

}  // namespace thalweg::detail
