/// Counting the sites inside a circle by point location, as the paper has it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/export.hpp"
#include "thalweg/order_k_voronoi.hpp"

namespace thalweg {

/// Answers the question of `CircleCounter` with an order-k Voronoi diagram: locate the centre of the circle;
/// the k sites of its cell are the nearest, so those inside the circle, if they are fewer than k, are among
/// them. The diagram is shared among counters.
class THALWEG_EXPORT VoronoiCounter {
 public:
  /// Requires: `diagram` outlives the counter. To count up to k sites its order must be k + 1 (or all sites).
  explicit VoronoiCounter(const OrderKVoronoi& diagram) noexcept : diagram_(&diagram) {}

  /// The number of sites strictly inside the circle through u, v, w, or limit + 1 if there are more than
  /// `limit`. Degenerate: sites on the circle do not count. Requires: u, v, w counter-clockwise; limit <
  /// diagram.order(), unless that is the number of sites. Exact. Complexity: O(log n + k) expected.
  /// Source: Theorem 6 of the paper.
  unsigned count_in_circle(VertexId u, VertexId v, VertexId w, unsigned limit);

  /// The sites that the last `count_in_circle` found inside: all of them, if they were not more than its
  /// limit. Requires: it has been called.
  std::span<const VertexId> inside() const noexcept { return inside_; }

  /// How often `count_in_circle` was called.
  std::uint64_t calls() const noexcept { return calls_; }

 private:
  const OrderKVoronoi* diagram_;
  std::vector<VertexId> inside_;
  std::uint64_t calls_ = 0;
};

}  // namespace thalweg
