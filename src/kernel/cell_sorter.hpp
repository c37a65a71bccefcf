/// Ordering the points of cells: by keys, then those of one key in their own box, a few levels deep, and what
/// is left lexicographically.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "kernel/morton_grid.hpp"
#include "kernel/radix_sort.hpp"
#include "thalweg/array.hpp"
#include "thalweg/point.hpp"

namespace thalweg::detail {

/// Points that lie together, and the rows they come from.
struct Cell {
  std::span<std::uint32_t> rows;
  std::span<Point2> points;

  std::size_t size() const noexcept { return rows.size(); }
  Cell part(std::size_t begin, std::size_t end) const noexcept {
    return {rows.subspan(begin, end - begin), points.subspan(begin, end - begin)};
  }
};

/// Orders one cell after the other, in memory that it keeps.
class CellSorter {
 public:
  /// Orders points and keys by keys, and points of the same key as all cells are. Returns how many are
  /// distinct. Requires: rows ascend; keys are those of the points in one grid and differ in the lowest
  /// `bits` bits only. Complexity: O(n), and a comparison sort within crowded cells of the last level.
  std::uint32_t order_by_keys(const Cell& cell, std::span<std::uint32_t> keys, unsigned bits);

 private:
  std::uint32_t order(const Cell& cell, int level);
  std::uint32_t order_runs(const Cell& cell, std::span<const KeyedRow> sorted, int level);
  std::uint32_t sort_many(const Cell& cell, std::size_t most);
  template <class Position>
  void arrange(const Cell& cell, const Position& position);

  Array<KeyedRow> keyed_, other_;
  Array<Point2> points_;
  Array<std::uint32_t> rows_;
};

}  // namespace thalweg::detail
