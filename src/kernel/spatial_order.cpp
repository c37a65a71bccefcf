/// Spatial order: keys, a radix sort, and a second look at crowded cells.
#include "kernel/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "kernel/parallel.hpp"
#include "kernel/prefetch.hpp"
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

/// Sorts the rows of a cell by their points, then by number. Returns the number of distinct points.
std::uint32_t sort_lexicographically(std::span<std::uint32_t> rows, std::span<const Point2> points) {
  struct Placed {
    Point2 point;
    std::uint32_t row;
  };
  std::array<Placed, kCellSites> few;  // the rule: what is nearby in the cell is far apart among the points
  std::vector<Placed> many(rows.size() > few.size() ? rows.size() : 0);
  const std::span<Placed> placed = many.empty() ? std::span(few).first(rows.size()) : std::span(many);
  std::transform(rows.begin(), rows.end(), placed.begin(), [points](std::uint32_t row) {
    return Placed{points[row], row};
  });
  std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) {
    if (lexicographically_less(a.point, b.point)) return true;
    return a.point == b.point && a.row < b.row;
  });
  std::uint32_t distinct = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    rows[i] = placed[i].row;
    distinct += i == 0 || placed[i].point != placed[i - 1].point;
  }
  return distinct;
}

/// Orders the rows of one cell: in the cell's own box, cell by cell, if they are many sites, else
/// lexicographically. Returns the number of distinct points.
///
/// Whether they are many must not depend on duplicates. More different keys than kCellSites prove it cheaply.
std::uint32_t order_cell(std::span<std::uint32_t> rows, std::span<const Point2> points, int level) {
  if (rows.size() <= kCellSites || level == kKeyLevels) return sort_lexicographically(rows, points);
  Array<KeyedRow> keyed(rows.size());
  {
    std::vector<Point2> gathered(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) gathered[i] = points[rows[i]];
    const Grid grid(box_of(gathered, 1));
    for (std::size_t i = 0; i < rows.size(); ++i) keyed[i] = keyed_row(grid.key(gathered[i]), rows[i]);
  }
  radix_sort(keyed, 1);
  std::uint32_t different = 1;
  for (std::size_t i = 1; i < keyed.size(); ++i) different += key_of(keyed[i]) != key_of(keyed[i - 1]);
  if (different <= kCellSites) {
    const std::uint32_t distinct = sort_lexicographically(rows, points);
    if (distinct <= kCellSites) return distinct;
  }
  std::transform(keyed.begin(), keyed.end(), rows.begin(), row_of);
  std::uint32_t distinct = 0;
  for_each_run(keyed, [&](std::size_t begin, std::size_t end) {
    distinct += end - begin == 1 ? 1 : order_cell(rows.subspan(begin, end - begin), points, level + 1);
  });
  return distinct;
}

/// Orders the rows within every cell. Returns whether any two points are equal.
bool order_cells(std::span<std::uint32_t> rows, std::span<const std::uint32_t> keys,
                 std::span<const Point2> points, std::size_t parts) {
  std::atomic<bool> duplicates{false};
  parallel_parts(rows.size(), parts, [&](std::size_t, std::size_t begin, std::size_t end) {
    // A cell belongs to the part in which it begins.
    const auto in_earlier_part = [&](std::size_t i) { return i > 0 && keys[i] == keys[i - 1]; };
    // The points of a cell lie all over memory: those of a coming one are asked for in time.
    const auto approach = [&](std::size_t i) {
      constexpr std::size_t kAhead = 64;
      const std::size_t coming = i + kAhead;
      if (coming + 1 < rows.size() && (keys[coming] == keys[coming - 1] || keys[coming] == keys[coming + 1]))
        prefetch(&points[rows[coming]]);
    };
    while (begin < end && in_earlier_part(begin)) ++begin;
    while (begin < end) {
      std::size_t next = begin + 1;
      approach(begin);
      for (; next < rows.size() && keys[next] == keys[begin]; ++next) approach(next);
      if (next - begin > 1) {
        const auto cell = rows.subspan(begin, next - begin);
        if (order_cell(cell, points, 1) < cell.size()) duplicates = true;
      }
      begin = next;
    }
  });
  return duplicates;
}

/// Notes where the rows of each site start, and keeps one key a site.
void part_sites(SpatialOrder& order, std::span<const Point2> points) {
  std::uint32_t sites = 0;
  for (std::uint32_t i = 0; i < order.rows.size(); ++i) {
    if (i > 0 && points[order.rows[i]] == points[order.rows[i - 1]]) continue;
    order.starts.push_back(i);
    order.keys[sites++] = order.keys[i];
  }
  order.keys.resize(sites);
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
  parallel_for(points.size(), threads, [&](std::size_t i) {
    order.rows[i] = row_of(keyed[i]);
    order.keys[i] = key_of(keyed[i]);
  });
  keyed = Array<KeyedRow>();
  if (order_cells(order.rows, order.keys, points, parts_of(points.size(), kThreadPoints, threads)))
    part_sites(order, points);
  return order;
}

}  // namespace thalweg::detail
