/// Reasons: from the exits already known, and a search beyond k for the pits that have none.
#include "terrain/reasons.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "order/sleeve_search.hpp"

namespace thalweg::detail {
namespace {

/// Answers for the least order <= k of an exit of any flat.
class KnownExits {
 public:
  KnownExits(const Surface& surface, std::span<const Exit> exits, unsigned k)
      : surface_(surface), k_(k), by_source_(exits.begin(), exits.end()), counter_(surface.graph()) {
    std::sort(by_source_.begin(), by_source_.end(), [](const Exit& a, const Exit& b) {
      return a.from != b.from ? a.from < b.from : a.order < b.order;
    });
  }

  std::optional<unsigned> least_order(std::span<const VertexId> flat) {
    std::optional<unsigned> least;
    for (const VertexId p : flat) {
      const auto order = exits_known(flat, p) ? from_list(flat, p) : from_search(flat, p);
      if (order && (!least || *order < *least)) least = order;
    }
    return least;
  }

 private:
  /// Whether the list holds all exits of p out of the flat: those out of its Delaunay pit, if the flat has
  /// all of that. A vertex that has become part of a pit has none in the list, nor has one whose lake was cut
  /// in two any to the other part.
  bool exits_known(std::span<const VertexId> flat, VertexId p) {
    const std::uint32_t pit = surface_.pit_of(p);
    if (pit == Surface::kNoPit) return false;
    if (pit != last_pit_ || flat.data() != last_flat_) {
      last_pit_ = pit;
      last_flat_ = flat.data();
      const auto members = surface_.pits()[pit];
      last_is_whole_ = std::includes(flat.begin(), flat.end(), members.begin(), members.end());
    }
    return last_is_whole_;
  }

  bool leads_out(std::span<const VertexId> flat, VertexId p, VertexId q) const {
    return surface_.z(q) < surface_.z(p) ||
           (surface_.z(q) == surface_.z(p) && !std::binary_search(flat.begin(), flat.end(), q));
  }

  std::optional<unsigned> from_list(std::span<const VertexId> flat, VertexId p) const {
    auto it = std::lower_bound(by_source_.begin(), by_source_.end(), p,
                               [](const Exit& exit, VertexId v) { return exit.from < v; });
    for (; it != by_source_.end() && it->from == p; ++it) {
      if (leads_out(flat, p, it->to)) return it->order;
    }
    return std::nullopt;
  }

  std::optional<unsigned> from_search(std::span<const VertexId> flat, VertexId p) {
    std::optional<unsigned> least;
    unsigned limit = k_;
    SleeveSearch(surface_.graph(), counter_)
        .run(
            p, limit, [&](VertexId q) { return leads_out(flat, p, q); },
            [&](VertexId, unsigned order) {
              if (!least || order < *least) least = order;
              return order == 0;
            });
    return least;
  }

  const Surface& surface_;
  unsigned k_;
  std::vector<Exit> by_source_;
  CircleCounter counter_;
  std::uint32_t last_pit_ = Surface::kNoPit;
  const VertexId* last_flat_ = nullptr;
  bool last_is_whole_ = false;
};

}  // namespace

Explained explain_pits(const Surface& surface, const Pits& pits, std::span<const Exit> exits, unsigned k,
                       Method method, const Watch& watch) {
  Explained explained;
  KnownExits known(surface, exits, k);
  std::vector<std::vector<VertexId>> stuck;
  std::vector<std::size_t> stuck_pits;
  for (std::uint32_t i = 0; i < pits.size() && !watch.stopped(); ++i) {
    RemainingPit pit;
    pit.vertex = surface.lowest(pits[i]);
    pit.vertices = static_cast<std::uint32_t>(pits[i].size());
    pit.boundary = pits.boundary(i);
    pit.order_needed = known.least_order(pits[i]);
    if (pit.order_needed) {
      pit.reason = method == Method::delaunay ? PitReason::kept : PitReason::conflict;
    } else {
      pit.reason = PitReason::unremovable;
      stuck.emplace_back(pits[i].begin(), pits[i].end());
      stuck_pits.push_back(i);
    }
    explained.pits.push_back(pit);
  }
  const LeastOrders least = least_exit_orders(surface, stuck, k, watch.threads, watch.cancel);
  for (std::size_t i = 0; i < least.of_flat.size(); ++i)
    explained.pits[stuck_pits[i]].order_needed = least.of_flat[i];
  explained.order_searched = least.searched;
  return explained;
}

}  // namespace thalweg::detail
