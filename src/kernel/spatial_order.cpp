/// Spatial order: keys, a radix sort, and a second look at crowded cells.
#include "kernel/spatial_order.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <utility>

#include "kernel/parallel.hpp"
#include "kernel/radix_sort.hpp"

namespace thalweg::detail {
namespace {

/// Fewer points than these a thread are not worth one.
constexpr std::size_t kThreadPoints = 1u << 16;

struct Box {
  double low_x, high_x, low_y, high_y;

  void add(Point2 p) noexcept {
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
  }
};

Box box_of(std::span<const Point2> points, unsigned threads) {
  const auto [x, y] = points.front();
  const Box first{x, x, y, y};
  std::vector<Box> boxes(parts_of(points.size(), kThreadPoints, threads), first);
  parallel_parts(points.size(), boxes.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    Box box = first;
    for (const Point2 p : points.subspan(begin, end - begin)) box.add(p);
    boxes[part] = box;
  });
  for (const Box& box : boxes) {
    boxes[0].add({box.low_x, box.low_y});
    boxes[0].add({box.high_x, box.high_y});
  }
  return boxes[0];
}

/// Where a coordinate lies in a box, as an integer of 16 bits.
///
/// cell = floor((x * shrink - corner) * grow * cells_per_unit). `shrink` is 1 unless the width of the box
/// would overflow, `grow` is 1 unless its reciprocal would: both are powers of two, so the result does not
/// change under exact scaling. Every step rounds monotonically.
struct Grid {
  double shrink = 1;
  double grow = 1;
  double cells_per_unit = 0;
  double x0 = 0, y0 = 0;

  static constexpr double kCells = 65536;

  explicit Grid(const Box& box) {
    const auto [low_x, high_x, low_y, high_y] = box;
    const double size = std::max({std::fabs(low_x), std::fabs(high_x), std::fabs(low_y), std::fabs(high_y)});
    if (size >= 0x1p1020) shrink = 0x1p-4;
    x0 = low_x * shrink;
    y0 = low_y * shrink;
    double width = std::max(high_x * shrink - x0, high_y * shrink - y0);
    if (width < 0x1p-500) grow = 0x1p600;
    width *= grow;
    if (width > 0) cells_per_unit = kCells / width;
  }

  std::uint32_t cell(double coordinate, double corner) const noexcept {
    const double scaled = (coordinate * shrink - corner) * grow * cells_per_unit;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::min(scaled, kCells - 1)));
  }

  std::uint32_t key(Point2 p) const noexcept { return spread(cell(p.x, x0)) << 1 | spread(cell(p.y, y0)); }

  /// Bit i of the lower half to bit 2i.
  static std::uint32_t spread(std::uint32_t v) noexcept {
    v = (v | v << 8) & 0x00ff00ffu;
    v = (v | v << 4) & 0x0f0f0f0fu;
    v = (v | v << 2) & 0x33333333u;
    return (v | v << 1) & 0x55555555u;
  }
};

/// Points of one cell of a grid, and the rows they come from.
struct Cell {
  std::span<std::uint32_t> rows;
  std::span<Point2> points;

  std::size_t size() const noexcept { return rows.size(); }
  Cell part(std::size_t begin, std::size_t end) const noexcept {
    return {rows.subspan(begin, end - begin), points.subspan(begin, end - begin)};
  }
};

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

/// Orders a cell as the given positions in it are.
void arrange(const Cell& cell, std::span<const std::uint32_t> positions) {
  const std::vector<Point2> points(cell.points.begin(), cell.points.end());
  const std::vector<std::uint32_t> rows(cell.rows.begin(), cell.rows.end());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    cell.points[i] = points[positions[i]];
    cell.rows[i] = rows[positions[i]];
  }
}

/// Sorts a cell, unless more than `most` points are distinct. Returns how many are.
std::uint32_t sort_many(const Cell& cell, std::size_t most) {
  std::vector<std::uint32_t> sorted(cell.size());
  std::iota(sorted.begin(), sorted.end(), 0u);
  std::sort(sorted.begin(), sorted.end(), [&cell](std::uint32_t i, std::uint32_t j) {
    return precedes(cell.points[i], cell.rows[i], cell.points[j], cell.rows[j]);
  });
  std::uint32_t distinct = 1;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    distinct += cell.points[sorted[i]] != cell.points[sorted[i - 1]];
  if (distinct <= most) arrange(cell, sorted);
  return distinct;
}

/// Orders one cell: in its own box, cell by cell, if it has many sites, else lexicographically. Returns the
/// number of distinct points.
///
/// Whether they are many must not depend on duplicates. More different keys than kCellSites prove it cheaply.
std::uint32_t order_cell(const Cell& cell, int level) {
  if (cell.size() <= kCellSites) return sort_few(cell);
  if (level == kKeyLevels) return sort_many(cell, cell.size());
  Array<KeyedRow> keyed(cell.size());
  const Grid grid(box_of(cell.points, 1));
  for (std::uint32_t i = 0; i < keyed.size(); ++i) keyed[i] = keyed_row(grid.key(cell.points[i]), i);
  radix_sort(keyed, 1);
  std::uint32_t different = 1;
  for (std::size_t i = 1; i < keyed.size(); ++i) different += key_of(keyed[i]) != key_of(keyed[i - 1]);
  if (different <= kCellSites) {
    const std::uint32_t distinct = sort_many(cell, kCellSites);
    if (distinct <= kCellSites) return distinct;
  }
  std::vector<std::uint32_t> positions(cell.size());
  std::transform(keyed.begin(), keyed.end(), positions.begin(), row_of);
  arrange(cell, positions);
  std::uint32_t distinct = 0;
  for_each_run(keyed, [&](std::size_t begin, std::size_t end) {
    distinct += end - begin == 1 ? 1 : order_cell(cell.part(begin, end), level + 1);
  });
  return distinct;
}

/// Orders what is within every cell. Returns whether any two points are equal.
bool order_cells(SpatialOrder& order, unsigned threads) {
  const Cell all{order.rows, order.sites};
  const std::span<const std::uint32_t> keys = order.keys;
  const std::size_t parts = parts_of(all.size(), kThreadPoints, threads);
  std::atomic<bool> duplicates{false};
  parallel_parts(all.size(), parts, [&](std::size_t, std::size_t begin, std::size_t end) {
    // A cell belongs to the part in which it begins.
    while (begin < end && begin > 0 && keys[begin] == keys[begin - 1]) ++begin;
    while (begin < end) {
      std::size_t next = begin + 1;
      while (next < keys.size() && keys[next] == keys[begin]) ++next;
      if (next - begin > 1 && order_cell(all.part(begin, next), 1) < next - begin) duplicates = true;
      begin = next;
    }
  });
  return duplicates;
}

/// Notes where the rows of each site start, and keeps one key and one point a site.
void part_sites(SpatialOrder& order) {
  std::uint32_t sites = 0;
  for (std::uint32_t i = 0; i < order.rows.size(); ++i) {
    if (i > 0 && order.sites[i] == order.sites[sites - 1]) continue;
    order.starts.push_back(i);
    order.keys[sites] = order.keys[i];
    order.sites[sites++] = order.sites[i];
  }
  order.keys.resize(sites);
  order.sites.resize(sites);
  order.starts.push_back(static_cast<std::uint32_t>(order.rows.size()));
}

}  // namespace

void morton_keys(std::span<const Point2> points, std::span<std::uint32_t> keys) {
  if (points.empty()) return;
  const Grid grid(box_of(points, 1));
  for (std::size_t i = 0; i < points.size(); ++i) keys[i] = grid.key(points[i]);
}

SpatialOrder spatial_order(std::span<const Point2> points, unsigned threads) {
  SpatialOrder order;
  if (points.empty()) return order;
  Array<KeyedRow> keyed(points.size());
  const Grid grid(box_of(points, threads));
  parallel_for(points.size(), threads, [&](std::size_t i) {
    keyed[i] = keyed_row(grid.key(points[i]), static_cast<std::uint32_t>(i));
  });
  radix_sort(keyed, threads);

  order.rows = Array<std::uint32_t>(points.size());
  order.keys = Array<std::uint32_t>(points.size());
  order.sites = Array<Point2>(points.size());
  parallel_for(points.size(), threads, [&](std::size_t i) {
    order.rows[i] = row_of(keyed[i]);
    order.keys[i] = key_of(keyed[i]);
  });
  parallel_for(points.size(), threads, [&](std::size_t i) { order.sites[i] = points[order.rows[i]]; });
  keyed = Array<KeyedRow>();
  if (order_cells(order, threads)) part_sites(order);
  return order;
}

}  // namespace thalweg::detail
