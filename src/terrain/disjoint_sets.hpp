/// Disjoint sets of small numbers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace thalweg::detail {

/// Source: Tarjan; path halving, the smaller number becomes the root, so that results do not depend on the
/// order of joins.
class DisjointSets {
 public:
  explicit DisjointSets(std::uint32_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  /// The root of i: the smallest member of its set. Complexity: O(log n) amortised.
  std::uint32_t find(std::uint32_t i) noexcept {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  /// Makes one set of those of i and j; returns whether they were two.
  bool join(std::uint32_t i, std::uint32_t j) noexcept {
    i = find(i);
    j = find(j);
    if (i == j) return false;
    parent_[std::max(i, j)] = std::min(i, j);
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace thalweg::detail
