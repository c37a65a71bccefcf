/// Flooding flats, with what one flood has learnt passed on to the next.
#include "terrain/flats.hpp"

#include <algorithm>

namespace thalweg::detail {

void FlatSearch::next_epoch() {
  epoch_ += 2;
  if (epoch_ == 0) {
    std::fill(stamp_.begin(), stamp_.end(), 0);
    epoch_ = 2;
  }
}

/// Floods the flat of v until it drains; returns whether it is a pit. A flood that drains stops early and
/// leaves part of its flat unseen; its vertices are stamped as draining, so that a later flood that meets one
/// knows that it drains too.
bool FlatSearch::flood(const Triangulation& t, VertexId v) {
  const double level = surface_->z(v);
  bool drains = false;
  flat_.assign(1, v);
  stamp_[v.index()] = epoch_;
  for (std::size_t head = 0; head < flat_.size() && !drains; ++head) {
    t.for_each_neighbor(flat_[head], [&](VertexId w) {
      const double z = surface_->z(w);
      if (z < level) drains = true;
      if (z != level || stamp_[w.index()] == epoch_) return;
      if (stamp_[w.index()] == epoch_ + 1) {
        drains = true;
        return;
      }
      stamp_[w.index()] = epoch_;
      flat_.push_back(w);
    });
  }
  visits_ += flat_.size();
  if (drains) {
    for (const VertexId w : flat_) stamp_[w.index()] = epoch_ + 1;
  }
  return !drains;
}

bool FlatSearch::on_pit(const Triangulation& t, VertexId v) {
  next_epoch();
  return flood(t, v);
}

std::uint32_t FlatSearch::pits_touching(const Triangulation& t, std::span<const VertexId> vertices) {
  next_epoch();
  std::uint32_t pits = 0;
  for (const VertexId v : vertices) {
    if (stamp_[v.index()] == epoch_ || stamp_[v.index()] == epoch_ + 1) continue;
    if (flood(t, v)) ++pits;
  }
  return pits;
}

}  // namespace thalweg::detail
