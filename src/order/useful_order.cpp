/// Useful orders: of one pair by its own sleeve, of all pairs by the walk of sleeve_search.hpp.
#include "thalweg/useful_order.hpp"

#include <algorithm>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "kernel/sleeve.hpp"
#include "order/sleeve_search.hpp"

namespace thalweg {

std::optional<unsigned> useful_order(const DelaunayGraph& graph, CircleCounter& counter, VertexId u,
                                     VertexId v, unsigned limit) {
  if (graph.delaunay().joined(u, v)) return 0u;
  detail::Sleeve sleeve;
  if (!detail::find_sleeve(graph.delaunay(), graph.sites(), u, v, sleeve)) return std::nullopt;
  if (detail::SleeveSearch::is_cocircular(graph, u, v, sleeve)) return 0u;
  return detail::SleeveSearch::pair_order(graph, counter, u, v, sleeve.left, sleeve.right, limit);
}

std::vector<UsefulPair> useful_pairs_from(const DelaunayGraph& graph, VertexId p, unsigned k) {
  std::vector<UsefulPair> pairs;
  CircleCounter counter(graph);
  detail::SleeveSearch(graph, counter)
      .run(
          p, k, [](VertexId) { return true; },
          [&](VertexId q, unsigned order) {
            pairs.push_back({p, q, order});
            return false;
          });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<UsefulPair> useful_pairs(const DelaunayGraph& graph, unsigned k, unsigned threads) {
  // Chunks of sites in parallel, each into a list of its own; joined in order of sites.
  constexpr std::size_t kChunk = 1024;
  const std::size_t count = graph.sites().size();
  std::vector<std::vector<UsefulPair>> lists((count + kChunk - 1) / kChunk);
  detail::parallel_chunks(count, kChunk, threads, [&] {
    return [&, counter = CircleCounter(graph)](std::size_t begin, std::size_t end) mutable {
      std::vector<UsefulPair>& list = lists[begin / kChunk];
      detail::SleeveSearch search(graph, counter);
      for (std::size_t i = begin; i < end; ++i) {
        const VertexId u(static_cast<std::uint32_t>(i));
        search.run(
            u, k, [u](VertexId v) { return u < v; },
            [&](VertexId v, unsigned order) {
              list.push_back({u, v, order});
              return false;
            });
      }
      std::sort(list.begin(), list.end());
    };
  });
  std::vector<UsefulPair> pairs;
  std::size_t total = 0;
  for (const auto& list : lists) total += list.size();
  pairs.reserve(total);
  for (const auto& list : lists) pairs.insert(pairs.end(), list.begin(), list.end());
  return pairs;
}

}  // namespace thalweg
