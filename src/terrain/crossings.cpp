/// Crossing pairs among exits that pass the same triangles, decided by exact orientation.
#include "terrain/crossings.hpp"

#include <algorithm>

#include "kernel/predicates_inline.hpp"
#include "kernel/sleeve.hpp"

namespace thalweg::detail {
namespace {

/// Real terrain has a few pairs an exit: some hundred thousand at a million sites.
constexpr std::size_t kMostPairs = 20'000'000;

}  // namespace

bool cross_properly(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  return orient2d_sign(a, b, c) * orient2d_sign(a, b, d) < 0 &&
         orient2d_sign(c, d, a) * orient2d_sign(c, d, b) < 0;
}

std::optional<std::vector<ExitPair>> meeting_pairs(const Surface& surface, std::span<const UnitExit> exits) {
  const Triangulation& t = surface.delaunay();
  std::vector<std::pair<FaceId, std::uint32_t>> visits;
  Sleeve sleeve;
  for (std::uint32_t i = 0; i < exits.size(); ++i) {
    const VertexId p = exits[i].exit.from, q = exits[i].exit.to;
    if (t.joined(p, q)) {
      for (const HalfedgeId h : {t.find_halfedge(p, q), t.find_halfedge(q, p)}) {
        if (h.valid()) visits.emplace_back(Triangulation::face(h), i);
      }
    } else if (find_sleeve(t, surface.sites(), p, q, sleeve)) {
      for (const FaceId f : sleeve.faces) visits.emplace_back(f, i);
    }
  }
  std::sort(visits.begin(), visits.end());
  std::vector<ExitPair> pairs;
  for (std::size_t begin = 0, end = 0; begin < visits.size(); begin = end) {
    while (end < visits.size() && visits[end].first == visits[begin].first) ++end;
    if ((end - begin) * (end - begin) / 2 + pairs.size() > kMostPairs) return std::nullopt;
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = i + 1; j < end; ++j) pairs.emplace_back(visits[i].second, visits[j].second);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

Crossings::Crossings(const Surface& surface, std::span<const UnitExit> exits) : count_(exits.size()) {
  const auto at = [&](VertexId v) { return surface.sites()[v.index()]; };
  if (const auto meeting = meeting_pairs(surface, exits)) {
    complete_ = true;
    for (const auto& [i, j] : *meeting) {
      const Exit &f = exits[i].exit, &g = exits[j].exit;
      const bool same = f.from == g.to && f.to == g.from;
      if (same || cross_properly(at(f.from), at(f.to), at(g.from), at(g.to))) {
        pairs_.emplace_back(i, j);
        pairs_.emplace_back(j, i);
      }
    }
  }
  pack();
}

void Crossings::add(std::span<const ExitPair> pairs) {
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
