/// The useful order of a pair of sites: the least k for which some order-k triangulation joins them.
#pragma once

#include <optional>
#include <vector>

#include "thalweg/circle_count.hpp"
#include "thalweg/export.hpp"

namespace thalweg {

/// A pair of sites with its useful order.
struct UsefulPair {
  VertexId u;          ///< one of the two
  VertexId v;          ///< the other
  unsigned order = 0;  ///< the least k for which some order-k triangulation joins them
  /// By u, then v, then order.
  friend auto operator<=>(const UsefulPair&, const UsefulPair&) = default;
};

/// The useful order of the pair u, v, or limit + 1 if it is more than `limit`; nothing if a site lies on the
/// open segment. Requires: u and v distinct, neither isolated. Exact. Complexity: O(degree + crossed edges +
/// limit), crossed edges at most about 2 limit unless sites are cocircular. Source: Gudmundsson, Hammar, van
/// Kreveld 2002, Lemma 5 and after; stated for degenerate position in src/order/.
THALWEG_EXPORT std::optional<unsigned> useful_order(const DelaunayGraph& graph, CircleCounter& counter,
                                                    VertexId u, VertexId v, unsigned limit);

/// All pairs of useful order at most k that contain p, as {p, q, order}, ordered by q. Exact. Degenerate:
/// none for an isolated vertex. Complexity: independent of the number of sites: O(k) sites are in reach
/// on the average, each takes O(k) steps.
THALWEG_EXPORT std::vector<UsefulPair> useful_pairs_from(const DelaunayGraph& graph, VertexId p, unsigned k);

/// All pairs of useful order at most k, each once with u < v, sorted. Uniform sites have about 3.53 n, 4.09
/// n, 4.96 n, 6.17 n pairs of useful order at most 1, 2, 4, 8. Exact. The result does not depend on `threads`
/// (0 = all of the machine). Complexity: n times that of useful_pairs_from, and sorting.
THALWEG_EXPORT std::vector<UsefulPair> useful_pairs(const DelaunayGraph& graph, unsigned k,
                                                    unsigned threads = 1);

}  // namespace thalweg
