/// Few points are sorted by insertion, many by the keys of their box.
#include "kernel/cell_sorter.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "kernel/spatial_order.hpp"

namespace thalweg::detail {
namespace {

/// By points, then by rows.
bool precedes(Point2 p, std::uint32_t p_row, Point2 q, std::uint32_t q_row) noexcept {
  return lexicographically_less(p, q) || (p == q && p_row < q_row);
}

/// Sorts a cell of at most kCellSites points. Returns how many are distinct.
std::uint32_t sort_few(const Cell& cell) noexcept {
  for (std::size_t i = 1; i < cell.size(); ++i) {
    const Point2 point = cell.points[i];
    const std::uint32_t row = cell.rows[i];
    std::size_t place = i;
    for (; place > 0 && precedes(point, row, cell.points[place - 1], cell.rows[place - 1]); --place) {
      cell.points[place] = cell.points[place - 1];
      cell.rows[place] = cell.rows[place - 1];
    }
    cell.points[place] = point;
    cell.rows[place] = row;
  }
  std::uint32_t distinct = 1;
  for (std::size_t i = 1; i < cell.size(); ++i) distinct += cell.points[i] != cell.points[i - 1];
  return distinct;
}

}  // namespace

/// Puts the point that is at position(i) at i, for every i.
template <class Position>
void CellSorter::arrange(const Cell& cell, const Position& position) {
  points_.assign(cell.points.begin(), cell.points.end());
  rows_.assign(cell.rows.begin(), cell.rows.end());
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const std::uint32_t from = position(i);
    cell.points[i] = points_[from];
    cell.rows[i] = rows_[from];
  }
}

/// Sorts a cell, unless more than `most` points are distinct. Returns how many are.
std::uint32_t CellSorter::sort_many(const Cell& cell, std::size_t most) {
  std::vector<std::uint32_t> sorted(cell.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::sort(sorted.begin(), sorted.end(), [&cell](std::uint32_t i, std::uint32_t j) {
    return precedes(cell.points[i], cell.rows[i], cell.points[j], cell.rows[j]);
  });
  std::uint32_t distinct = 1;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    distinct += cell.points[sorted[i]] != cell.points[sorted[i - 1]];
  if (distinct <= most) arrange(cell, [&sorted](std::size_t i) { return sorted[i]; });
  return distinct;
}

/// Orders one cell: in its own box, cell by cell, if it has many sites, else lexicographically. Returns the
/// number of distinct points.
///
/// Whether they are many must not depend on duplicates. More different keys than kCellSites prove it cheaply.
std::uint32_t CellSorter::order(const Cell& cell, int level) {
  if (cell.size() <= kCellSites) return sort_few(cell);
  if (level == kKeyLevels) return sort_many(cell, cell.size());
  Array<KeyedRow> keyed(cell.size());
  const MortonGrid grid(box_of(cell.points));
  for (std::uint32_t i = 0; i < keyed.size(); ++i) keyed[i] = keyed_row(grid.key(cell.points[i]), i);
  radix_sort(keyed, 1);
  std::uint32_t different = 1;
  for (std::size_t i = 1; i < keyed.size(); ++i) different += key_of(keyed[i]) != key_of(keyed[i - 1]);
  if (different <= kCellSites) {
    const std::uint32_t distinct = sort_many(cell, kCellSites);
    if (distinct <= kCellSites) return distinct;
  }
  return order_runs(cell, keyed, level + 1);
}

/// Arranges a cell as its sorted keys are, whose rows are positions in it, and orders what has the same key
/// at this level. Returns the number of distinct points.
std::uint32_t CellSorter::order_runs(const Cell& cell, std::span<const KeyedRow> sorted, int level) {
  arrange(cell, [sorted](std::size_t i) { return row_of(sorted[i]); });
  std::uint32_t distinct = 0;
  for_each_run(sorted, [&](std::size_t begin, std::size_t end) {
    distinct += end - begin == 1 ? 1 : order(cell.part(begin, end), level);
  });
  return distinct;
}

std::uint32_t CellSorter::order_by_keys(const Cell& cell, std::span<std::uint32_t> keys, unsigned bits) {
  keyed_.resize(cell.size());
  other_.resize(cell.size());
  for (std::uint32_t i = 0; i < keyed_.size(); ++i) keyed_[i] = keyed_row(keys[i], i);
  const std::span<const KeyedRow> sorted = radix_sort(keyed_, other_, bits);
  std::transform(sorted.begin(), sorted.end(), keys.begin(), key_of);
  return order_runs(cell, sorted, 1);
}

}  // namespace thalweg::detail
