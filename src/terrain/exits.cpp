/// Searching exits from pits, in parallel, and the reach bound.
#include "terrain/exits.hpp"

#include <algorithm>

#include "kernel/parallel.hpp"
#include "kernel/predicates_inline.hpp"
#include "order/sleeve_search.hpp"
#include "terrain/disjoint_sets.hpp"

namespace thalweg::detail {
namespace {

bool is_cancelled(const std::atomic<bool>* cancel) {
  return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

/// What finding the least orders may be expected to take in all, in units of about a nanosecond: a tenth
/// of a second.
constexpr std::uint64_t kWorkBudget = 100'000'000;

/// What a search of order k is expected to take: 16 microseconds were measured at k = 8, and up to four times
/// as much at each doubling.
constexpr std::uint64_t expected_work(std::uint64_t k) {
  return 200 * k * k + 3000;
}

/// Whether a flat is all that lies at or below its height, so that nothing at all could drain it.
bool is_bottom(const Surface& surface, std::span<const VertexId> flat) {
  const double level = surface.z(flat[0]);
  if (level != surface.lowest_level()) return false;
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

/// Whether a triangle at p and the one across from p lie on one empty circle.
bool at_cocircular_face(const Surface& surface, VertexId p) {
  const Triangulation& t = surface.delaunay();
  const auto at = [&](VertexId v) { return surface.sites()[v.index()]; };
  for (HalfedgeId h = t.outgoing(p), first = h; h.valid();) {
    const HalfedgeId far = Triangulation::next(h), across = t.twin(far);
    if (across.valid() && incircle_sign(at(p), at(t.origin(far)), at(t.dest(far)), at(t.apex(across))) == 0)
      return true;
    h = t.turn_ccw(h);
    if (h == first) break;
  }
  return false;
}

/// The vertices of a pit that can have exits of order <= k: those near its shore. The sites on one side of a
/// sleeve are a path of Delaunay edges from p to q, of at most k sites unless the whole sleeve is cocircular
/// (sleeve_search.hpp). The last of them is next to q and so not on the pit, which does not drain; so at most
/// k - 1 edges lead from p to a vertex on the shore. Spares a large lake a search from every vertex of it.
std::vector<VertexId> near_shore(const Surface& surface, std::span<const VertexId> pit, unsigned k) {
  constexpr std::size_t kSmall = 256;
  if (pit.size() <= kSmall) return {pit.begin(), pit.end()};
  const auto place = [&](VertexId v) {
    return static_cast<std::size_t>(std::lower_bound(pit.begin(), pit.end(), v) - pit.begin());
  };
  const std::uint32_t number = surface.pit_of(pit[0]);
  std::vector<std::uint8_t> is_near(pit.size(), 0);
  std::vector<VertexId> reached, front;
  for (const VertexId v : pit) {
    const auto neighbors = surface.graph().neighbors(v);
    const bool on_shore = std::any_of(neighbors.begin(), neighbors.end(),
                                      [&](VertexId w) { return surface.pit_of(w) != number; });
    if (!on_shore && !at_cocircular_face(surface, v)) continue;
    is_near[place(v)] = 1;
    reached.push_back(v);
    if (on_shore) front.push_back(v);
  }
  for (unsigned distance = 1; distance < k && !front.empty(); ++distance) {
    std::vector<VertexId> next;
    for (const VertexId v : front) {
      for (const VertexId w : surface.graph().neighbors(v)) {
        if (surface.pit_of(w) != number || is_near[place(w)] == 2) continue;
        if (is_near[place(w)] == 0) reached.push_back(w);
        is_near[place(w)] = 2;  // its turn in the flood has come
        next.push_back(w);
      }
    }
    front = std::move(next);
  }
  return reached;
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
        for (const VertexId p : near_shore(surface, pits[pit], k)) {
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
    if (a.order != b.order) return a.order < b.order;
    return a.from != b.from ? surface.lower(a.from, b.from) : surface.lower(a.to, b.to);
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
      if (settled[i] == 0) used += flats[i].size() * expected_work(limit);
    }
    if (used > kWorkBudget) break;
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
