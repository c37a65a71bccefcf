/// Searching exits from pits, in parallel, and the reach bound.
#include "terrain/exits.hpp"

#include <algorithm>
#include <tuple>

#include "kernel/parallel.hpp"
#include "order/sleeve_search.hpp"
#include "terrain/disjoint_sets.hpp"

namespace thalweg::detail {
namespace {

bool is_cancelled(const std::atomic<bool>* cancel) {
  return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

/// Steps that finding the least orders may be expected to take in all: some tenths of a second.
constexpr std::uint64_t kStepBudget = 20'000'000;

/// What a walk of order k is expected to take: about 1200 steps at k = 8, 7800 at 16 and 55,000 at 32 were
/// measured.
constexpr std::uint64_t expected_steps(std::uint64_t k) {
  return 2 * k * k * k + 10;
}

/// Whether a flat is all that lies at or below its height, so that nothing at all could drain it.
bool is_bottom(const Surface& surface, std::span<const VertexId> flat) {
  if (surface.rank(surface.lowest(flat)) != 0) return false;
  const double level = surface.z(flat[0]);
  const auto not_above =
      std::count_if(surface.z().begin(), surface.z().end(), [&](double z) { return z <= level; });
  return static_cast<std::size_t>(not_above) == flat.size();
}

/// The least order of an exit of the flat in (known, limit], if any.
std::optional<unsigned> least_order_within(const Surface& surface, SleeveSearch& search,
                                           std::span<const VertexId> flat, unsigned known, unsigned limit) {
  std::optional<unsigned> least;
  for (const VertexId p : flat) {
    const double level = surface.z(p);
    const bool spent = search.run(
        p, limit,
        [&](VertexId q) {
          return surface.z(q) < level ||
                 (surface.z(q) == level && !std::binary_search(flat.begin(), flat.end(), q));
        },
        [&](VertexId, unsigned order) {
          least = order;
          limit = order - 1;  // only a smaller one is of interest now
          return limit <= known;
        });
    if (spent) break;
  }
  return least;
}

}  // namespace

std::vector<Exit> find_exits(const Surface& surface, unsigned k, unsigned threads,
                             const std::atomic<bool>* cancel) {
  constexpr std::size_t kChunk = 64;
  const Pits& pits = surface.pits();
  std::vector<std::vector<Exit>> lists((pits.size() + kChunk - 1) / kChunk);
  parallel_chunks(pits.size(), kChunk, threads, [&] {
    return [&, counter = CircleCounter(surface.graph())](std::size_t begin, std::size_t end) mutable {
      if (is_cancelled(cancel)) return;
      std::vector<Exit>& list = lists[begin / kChunk];
      SleeveSearch search(surface.graph(), counter);
      for (std::size_t i = begin; i < end; ++i) {
        const auto pit = static_cast<std::uint32_t>(i);
        for (const VertexId p : pits[pit]) {
          const double level = surface.z(p);
          unsigned limit = k;
          search.run(
              p, limit,
              [&](VertexId q) {
                return surface.z(q) < level || (surface.z(q) == level && surface.pit_of(q) != pit);
              },
              [&](VertexId q, unsigned order) {
                list.push_back({p, q, order});
                return false;
              });
        }
      }
    };
  });
  std::vector<Exit> exits;
  for (const auto& list : lists) exits.insert(exits.end(), list.begin(), list.end());
  std::sort(exits.begin(), exits.end(), [&](const Exit& a, const Exit& b) {
    return std::tuple(a.order, surface.rank(a.from), surface.rank(a.to)) <
           std::tuple(b.order, surface.rank(b.from), surface.rank(b.to));
  });
  return exits;
}

std::span<const Exit> exits_up_to(std::span<const Exit> exits, unsigned k) {
  const auto end =
      std::partition_point(exits.begin(), exits.end(), [k](const Exit& exit) { return exit.order <= k; });
  return exits.first(static_cast<std::size_t>(end - exits.begin()));
}

std::uint32_t reach_bound(const Surface& surface, std::span<const Exit> exits) {
  const std::uint32_t count = surface.pits().size();
  DisjointSets groups(count);
  std::vector<std::uint8_t> drains(count, 0);
  for (const Exit& exit : exits) {
    const std::uint32_t pit = surface.pit_of(exit.from), other = surface.pit_of(exit.to);
    const bool level = surface.z(exit.from) == surface.z(exit.to);
    // Equal ground on no pit is a flat that drains in the Delaunay triangulation, by edges of useful order 0.
    if (!level || other == Surface::kNoPit) {
      drains[pit] = 1;
    } else {
      groups.join(pit, other);
    }
  }
  std::vector<std::uint8_t> group_drains(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (drains[i] != 0) group_drains[groups.find(i)] = 1;
  }
  std::uint32_t bound = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (groups.find(i) == i && group_drains[i] == 0) ++bound;
  }
  return bound;
}

LeastOrders least_exit_orders(const Surface& surface, const std::vector<std::vector<VertexId>>& flats,
                              unsigned known, unsigned threads, const std::atomic<bool>* cancel) {
  LeastOrders result{known, std::vector<std::optional<unsigned>>(flats.size())};
  std::vector<std::uint8_t> settled(flats.size(), 0);
  for (std::size_t i = 0; i < flats.size(); ++i) settled[i] = is_bottom(surface, flats[i]) ? 1 : 0;
  const auto sites = static_cast<unsigned>(surface.sites().size());
  std::uint64_t used = 0;
  while (result.searched < sites && !is_cancelled(cancel)) {
    const unsigned limit = std::max(result.searched + 1, std::min(sites, 2 * result.searched));
    for (std::size_t i = 0; i < flats.size(); ++i) {
      if (settled[i] == 0) used += flats[i].size() * expected_steps(limit);
    }
    if (used > kStepBudget) break;
    parallel_chunks(flats.size(), 16, threads, [&] {
      return [&, counter = CircleCounter(surface.graph())](std::size_t begin, std::size_t end) mutable {
        SleeveSearch search(surface.graph(), counter);
        for (std::size_t i = begin; i < end && !is_cancelled(cancel); ++i) {
          if (settled[i] != 0) continue;
          result.of_flat[i] = least_order_within(surface, search, flats[i], result.searched, limit);
          if (result.of_flat[i]) settled[i] = 1;
        }
      };
    });
    result.searched = limit;
    if (std::find(settled.begin(), settled.end(), 0) == settled.end()) break;
  }
  return result;
}

}  // namespace thalweg::detail
