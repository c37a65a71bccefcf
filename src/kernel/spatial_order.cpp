/// Spatial order: keys, a radix sort, and a second look at crowded cells.
#include "kernel/spatial_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace thalweg::detail {
namespace {

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

  explicit Grid(std::span<const Point2> points) {
    double low_x = points[0].x, high_x = low_x, low_y = points[0].y, high_y = low_y;
    for (const Point2 p : points) {
      low_x = std::min(low_x, p.x);
      high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y);
      high_y = std::max(high_y, p.y);
    }
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

/// Key in the upper half, row in the lower: sorted as one number, equal keys stay in the order of rows.
using KeyedRow = std::uint64_t;

std::uint32_t key_of(KeyedRow k) {
  return static_cast<std::uint32_t>(k >> 32);
}
std::uint32_t row_of(KeyedRow k) {
  return static_cast<std::uint32_t>(k);
}

constexpr std::uint32_t kDigitBits = 11;
constexpr std::uint32_t kDigits = 1u << kDigitBits;
constexpr int kPasses = 3;
using Histograms = std::array<std::array<std::uint32_t, kDigits>, kPasses>;

std::uint32_t digit(KeyedRow k, int pass) {
  return static_cast<std::uint32_t>(k >> (32 + kDigitBits * static_cast<std::uint32_t>(pass))) % kDigits;
}

void radix_sort(std::vector<KeyedRow>& keyed) {
  if (keyed.size() < 4 * kDigits) {
    std::sort(keyed.begin(), keyed.end());
    return;
  }
  auto histograms = std::vector<Histograms>(1);
  for (const KeyedRow k : keyed) {
    for (int pass = 0; pass < kPasses; ++pass)
      ++histograms[0][static_cast<std::size_t>(pass)][digit(k, pass)];
  }
  std::vector<KeyedRow> other(keyed.size());
  for (int pass = 0; pass < kPasses; ++pass) {
    auto& counts = histograms[0][static_cast<std::size_t>(pass)];
    if (counts[digit(keyed[0], pass)] == keyed.size()) continue;
    std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), 0u);
    for (const KeyedRow k : keyed) other[counts[digit(k, pass)]++] = k;
    keyed.swap(other);
  }
}

struct Site {
  Point2 point;
  std::uint32_t row;    ///< the lowest of its rows
  std::uint32_t begin;  ///< where its rows begin in the lexicographically sorted cell
  std::uint32_t end;
  std::uint32_t key = 0;
};

/// Orders the distinct sites of one cell, lexicographically sorted before: again by keys if there are many.
void order_cell(std::span<Site> sites, int level) {
  if (sites.size() <= kCellSites || level == kKeyLevels) return;
  {
    std::vector<Point2> points(sites.size());
    std::vector<std::uint32_t> keys(sites.size());
    std::transform(sites.begin(), sites.end(), points.begin(), [](const Site& s) { return s.point; });
    morton_keys(points, keys);
    for (std::size_t i = 0; i < sites.size(); ++i) sites[i].key = keys[i];
  }
  std::stable_sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) { return a.key < b.key; });
  for (std::size_t begin = 0, end = 0; begin < sites.size(); begin = end) {
    while (end < sites.size() && sites[end].key == sites[begin].key) ++end;
    order_cell(sites.subspan(begin, end - begin), level + 1);
  }
}

/// Orders rows of equal key. Writes to `starts` where each site begins, counted from `offset`.
/// Returns the number of distinct sites.
std::uint32_t order_run(std::span<std::uint32_t> rows, std::span<const Point2> points, std::uint32_t offset,
                        std::vector<std::uint32_t>& starts) {
  starts.clear();
  std::sort(rows.begin(), rows.end(), [points](std::uint32_t i, std::uint32_t j) {
    if (lexicographically_less(points[i], points[j])) return true;
    return points[i] == points[j] && i < j;
  });
  std::vector<Site> sites;
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || points[rows[i]] != points[rows[i - 1]]) sites.push_back({points[rows[i]], rows[i], i, i});
    sites.back().end = i + 1;
  }
  if (sites.size() > kCellSites) {
    order_cell(sites, 1);
    const std::vector<std::uint32_t> sorted(rows.begin(), rows.end());
    auto out = rows.begin();
    for (const Site& s : sites) out = std::copy(sorted.begin() + s.begin, sorted.begin() + s.end, out);
  }
  std::uint32_t start = offset;
  for (const Site& s : sites) {
    starts.push_back(start);
    start += s.end - s.begin;
  }
  return static_cast<std::uint32_t>(sites.size());
}

}  // namespace

void morton_keys(std::span<const Point2> points, std::span<std::uint32_t> keys) {
  if (points.empty()) return;
  const Grid grid(points);
  for (std::size_t i = 0; i < points.size(); ++i) keys[i] = grid.key(points[i]);
}

SpatialOrder spatial_order(std::span<const Point2> points, unsigned) {
  SpatialOrder order;
  if (points.empty()) return order;
  const auto count = static_cast<std::uint32_t>(points.size());
  std::vector<KeyedRow> keyed(count);
  const Grid grid(points);
  for (std::uint32_t i = 0; i < count; ++i) keyed[i] = KeyedRow{grid.key(points[i])} << 32 | i;
  radix_sort(keyed);

  order.rows.resize(count);
  order.keys.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    order.rows[i] = row_of(keyed[i]);
    order.keys[i] = key_of(keyed[i]);
  }
  keyed = {};

  // Cells of several points: order them, and from the first duplicate on keep the starts of all sites.
  bool duplicates = false;
  std::vector<std::uint32_t> starts;
  std::uint32_t sites = 0;
  for (std::uint32_t begin = 0, end = 0; begin < count; begin = end) {
    const std::uint32_t key = order.keys[begin];
    for (end = begin + 1; end < count && order.keys[end] == key;) ++end;
    std::uint32_t distinct = 1;
    starts.assign(1, begin);
    if (end - begin > 1) {
      distinct = order_run(std::span(order.rows).subspan(begin, end - begin), points, begin, starts);
    }
    if (distinct < end - begin && !duplicates) {
      duplicates = true;
      order.starts.resize(begin);
      std::iota(order.starts.begin(), order.starts.end(), 0u);
    }
    if (duplicates) order.starts.insert(order.starts.end(), starts.begin(), starts.end());
    std::fill_n(order.keys.begin() + sites, distinct, key);
    sites += distinct;
  }
  order.keys.resize(sites);
  if (duplicates) order.starts.push_back(count);
  return order;
}

}  // namespace thalweg::detail
