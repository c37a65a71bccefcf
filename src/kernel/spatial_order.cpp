/// Spatial order: points are dealt out to ranges of keys, and each range is ordered while the inner caches
/// hold it.
#include "kernel/spatial_order.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>
#include <utility>

#include "kernel/cell_sorter.hpp"
#include "kernel/morton_grid.hpp"
#include "kernel/parallel.hpp"

namespace thalweg::detail {
namespace {

/// Fewer points than these a thread are not worth one.
constexpr std::size_t kThreadPoints = 1u << 16;

/// Of points that are ordered at a time: with the scratch for it they fit into the inner caches.
constexpr std::size_t kRangePoints = 1u << 11;

BoundingBox box_of_all(std::span<const Point2> points, unsigned threads) {
  std::vector<BoundingBox> boxes(parts_of(points.size(), kThreadPoints, threads));
  parallel_parts(points.size(), boxes.size(), [&](std::size_t part, std::size_t begin, std::size_t end) {
    boxes[part] = box_of(points.subspan(begin, end - begin));
  });
  for (const BoundingBox& box : boxes) {
    boxes[0].add({box.low_x, box.low_y});
    boxes[0].add({box.high_x, box.high_y});
  }
  return boxes[0];
}

/// Ranges of keys, each with some thousand points unless more have keys that agree in their upper half.
/// Ranges begin where one of the upper bits changes.
class KeyRanges {
 public:
  KeyRanges(std::span<const Point2> points, unsigned threads)
      : points_(points),
        grid_(box_of_all(points, threads)),
        shift_(32 - prefix_bits(points.size())),
        parts_(parts_of(points.size(), kThreadPoints, threads)) {
    divide(count_prefixes());
  }

  std::size_t size() const noexcept { return ranges_.size(); }

  /// Copies all points where their ranges are, each with its row and its key, in ascending order of rows.
  void deal_out(SpatialOrder& order);

  /// Orders what has been dealt out to a range. Returns whether points are equal.
  bool put_in_order(SpatialOrder& order, std::size_t range, CellSorter& cells) const {
    const auto [begin, size, bits] = ranges_[range];
    const Cell cell{std::span(order.rows).subspan(begin, size), std::span(order.sites).subspan(begin, size)};
    return cells.order_by_keys(cell, std::span(order.keys).subspan(begin, size), bits) < size;
  }

 private:
  using Counts = Array<std::uint32_t>;

  struct Range {
    std::uint32_t begin, size;
    unsigned bits;  ///< the lowest, in which its keys may differ
  };

  /// More than kRangePoints where there would be more ranges than memory can be written to at a time.
  std::size_t wanted_size() const noexcept {
    constexpr std::size_t kMostRanges = 1u << 11;
    return std::max(kRangePoints, points_.size() / kMostRanges);
  }
  /// Upper bits that ranges may begin with: some points a prefix.
  static unsigned prefix_bits(std::size_t points) noexcept {
    constexpr unsigned kMost = 16, kPointsBits = 4;
    return std::min(kMost, static_cast<unsigned>(std::bit_width(points)) - kPointsBits);
  }
  std::size_t prefix_of(std::uint32_t key) const noexcept { return key >> shift_; }

  std::vector<Counts> count_prefixes() const;
  void divide(const std::vector<Counts>& counts);

  std::span<const Point2> points_;
  MortonGrid grid_;
  unsigned shift_;  ///< bits below a prefix
  std::size_t parts_;
  Array<std::uint16_t> range_of_;  ///< by prefix
  std::vector<Range> ranges_;
  std::vector<std::vector<std::uint32_t>> places_;  ///< for each part of the points, its place in each range
};

/// For each part of the points, how many have each prefix.
std::vector<KeyRanges::Counts> KeyRanges::count_prefixes() const {
  std::vector<Counts> counts(parts_);
  parallel_parts(points_.size(), parts_, [&](std::size_t part, std::size_t begin, std::size_t end) {
    Counts count(std::size_t{1} << (32 - shift_), 0u);
    for (const Point2 p : points_.subspan(begin, end - begin)) ++count[prefix_of(grid_.key(p))];
    counts[part] = std::move(count);
  });
  return counts;
}

void KeyRanges::divide(const std::vector<Counts>& counts) {
  const std::size_t wanted = wanted_size();
  range_of_ = Array<std::uint16_t>(counts[0].size(), std::uint16_t{0});
  places_.resize(parts_);
  std::size_t first = 0;  // prefix of the current range
  std::uint32_t place = 0;
  for (std::size_t prefix = 0; prefix < range_of_.size(); ++prefix) {
    std::uint32_t size = 0;
    for (const Counts& count : counts) size += count[prefix];
    if (size == 0) continue;
    if (ranges_.empty() || ranges_.back().size >= wanted) {
      ranges_.push_back({place, 0, 0});
      for (auto& places : places_) places.push_back(0);
      first = prefix;
    }
    for (std::size_t part = 0; part < parts_; ++part) places_[part].back() += counts[part][prefix];
    range_of_[prefix] = static_cast<std::uint16_t>(ranges_.size() - 1);
    ranges_.back().size += size;
    ranges_.back().bits = static_cast<unsigned>(std::bit_width(prefix ^ first)) + shift_;
    place += size;
  }
  for (std::size_t range = 0; range < ranges_.size(); ++range) {
    place = ranges_[range].begin;
    for (auto& places : places_) place += std::exchange(places[range], place);
  }
}

void KeyRanges::deal_out(SpatialOrder& order) {
  parallel_parts(points_.size(), parts_, [&](std::size_t part, std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> next = std::move(places_[part]);
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t key = grid_.key(points_[i]);
      const std::uint32_t place = next[range_of_[prefix_of(key)]]++;
      order.sites[place] = points_[i];
      order.rows[place] = static_cast<std::uint32_t>(i);
      order.keys[place] = key;
    }
  });
}

/// The points as they come, with rows and keys, and these put in order. Returns whether points are equal.
bool order_few(std::span<const Point2> points, SpatialOrder& order) {
  std::iota(order.rows.begin(), order.rows.end(), 0u);
  std::copy(points.begin(), points.end(), order.sites.begin());
  morton_keys(points, order.keys);
  constexpr unsigned kKeyBits = 32;
  return CellSorter().order_by_keys({order.rows, order.sites}, order.keys, kKeyBits) < points.size();
}

/// The same, range by range of keys.
bool order_many(std::span<const Point2> points, unsigned threads, SpatialOrder& order) {
  KeyRanges ranges(points, threads);
  ranges.deal_out(order);
  std::atomic<bool> duplicates{false};
  const auto workers = static_cast<unsigned>(parts_of(points.size(), kThreadPoints, threads));
  parallel_chunks(ranges.size(), 1, workers, [&] {
    return [&, cells = CellSorter()](std::size_t begin, std::size_t end) mutable {
      for (std::size_t range = begin; range < end; ++range) {
        if (ranges.put_in_order(order, range, cells)) duplicates = true;
      }
    };
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
  const MortonGrid grid(box_of(points));
  for (std::size_t i = 0; i < points.size(); ++i) keys[i] = grid.key(points[i]);
}

SpatialOrder spatial_order(std::span<const Point2> points, unsigned threads) {
  SpatialOrder order;
  order.rows = Array<std::uint32_t>(points.size());
  order.keys = Array<std::uint32_t>(points.size());
  order.sites = Array<Point2>(points.size());
  if (points.empty()) return order;
  const bool duplicates =
      points.size() <= kRangePoints ? order_few(points, order) : order_many(points, threads, order);
  if (duplicates) part_sites(order);
  return order;
}

}  // namespace thalweg::detail
