/// A radix sort from the lowest digit up. Threads first share the rows by ranges of keys: each then sorts
/// what no other touches, where three passes of them all would have each read at each pass what others wrote.
#include "kernel/radix_sort.hpp"

#include <array>
#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "kernel/parallel.hpp"

namespace thalweg::detail {
namespace {

/// Fewer rows than these a thread are not worth one.
constexpr std::size_t kThreadRows = 1u << 16;

/// Fewer than these are compared.
constexpr std::size_t kFewRows = 96;

/// Digits of few rows, whose counts cost as much as the rows; and of many, for a pass less.
constexpr unsigned kShortDigit = 8, kLongDigit = 11;

/// How long digits should be at most, for so many rows.
unsigned longest_digit(std::size_t rows) noexcept {
  return std::clamp(static_cast<unsigned>(std::bit_width(rows)) - 1, kShortDigit, kLongDigit);
}

/// Where the ranges of keys begin after the first: at quantiles of a sample. It is taken by the golden ratio,
/// for steps of one length may meet the same column of a grid again and again.
std::vector<std::uint32_t> range_starts(std::span<const KeyedRow> rows, std::size_t ranges) {
  constexpr std::size_t kSampleOfRange = 512;
  constexpr std::uint32_t kGolden = 0x9e3779b9u;
  std::vector<std::uint32_t> sample(kSampleOfRange * ranges);
  std::uint32_t position = 0;
  for (std::uint32_t& key : sample)
    key = key_of(rows[std::uint64_t{position += kGolden} * rows.size() >> 32]);
  std::sort(sample.begin(), sample.end());
  std::vector<std::uint32_t> starts(ranges - 1);
  for (std::size_t r = 0; r < starts.size(); ++r) starts[r] = sample[(r + 1) * kSampleOfRange];
  return starts;
}

/// Copies rows range by range of their keys, in the order they have. Returns where in `to` each range begins,
/// and the end.
std::vector<std::uint32_t> share_out(std::span<const KeyedRow> rows, std::span<KeyedRow> to,
                                     std::size_t ranges) {
  const std::vector<std::uint32_t> starts = range_starts(rows, ranges);
  const auto range_of = [&starts](KeyedRow k) {
    std::size_t range = 0;
    for (const std::uint32_t start : starts) range += key_of(k) >= start;
    return range;
  };
  using Counts = std::vector<std::uint32_t>;
  std::vector<Counts> counts(ranges);  // of every thread's rows, those of each range; then their places
  parallel_parts(rows.size(), ranges, [&](std::size_t part, std::size_t begin, std::size_t end) {
    Counts count(ranges, 0);
    for (const KeyedRow k : rows.subspan(begin, end - begin)) ++count[range_of(k)];
    counts[part] = std::move(count);
  });
  Counts begins;
  std::uint32_t place = 0;
  for (std::size_t range = 0; range < ranges; ++range) {
    begins.push_back(place);
    for (Counts& count : counts) place += std::exchange(count[range], place);
  }
  begins.push_back(place);
  parallel_parts(rows.size(), ranges, [&](std::size_t part, std::size_t begin, std::size_t end) {
    Counts next = std::move(counts[part]);
    for (const KeyedRow k : rows.subspan(begin, end - begin)) to[next[range_of(k)]++] = k;
  });
  return begins;
}

}  // namespace

/// A pass for each digit, from one array to the other.
std::span<KeyedRow> radix_sort(std::span<KeyedRow> rows, std::span<KeyedRow> other, unsigned bits) noexcept {
  if (rows.size() < kFewRows) {
    std::sort(rows.begin(), rows.end());
    return rows;
  }
  const unsigned longest = longest_digit(rows.size());
  const unsigned passes = (bits + longest - 1) / longest;
  for (unsigned pass = 0, low = 0; pass < passes; ++pass) {
    const unsigned digit_bits = (bits - low + passes - pass - 1) / (passes - pass);
    const std::uint32_t digits = 1u << digit_bits;
    const auto digit = [shift = 32 + low, digits](KeyedRow k) {
      return static_cast<std::uint32_t>(k >> shift) & (digits - 1);
    };
    std::array<std::uint32_t, 1u << kLongDigit> next;
    std::fill_n(next.begin(), digits, 0u);
    for (const KeyedRow k : rows) ++next[digit(k)];
    std::uint32_t place = 0;
    for (std::uint32_t& count : std::span(next).first(digits)) place += std::exchange(count, place);
    for (const KeyedRow k : rows) other[next[digit(k)]++] = k;
    std::swap(rows, other);
    low += digit_bits;
  }
  return rows;
}

void radix_sort(Array<KeyedRow>& keyed, unsigned threads) {
  constexpr unsigned kKeyBits = 32;
  Array<KeyedRow> other(keyed.size());
  const std::size_t ranges = parts_of(keyed.size(), kThreadRows, threads);
  if (ranges == 1) {
    if (radix_sort(keyed, other, kKeyBits).data() == other.data()) keyed.swap(other);
    return;
  }
  const std::vector<std::uint32_t> begins = share_out(keyed, other, ranges);
  parallel_parts(ranges, ranges, [&](std::size_t range, std::size_t, std::size_t) {
    const std::size_t begin = begins[range], size = begins[range + 1] - begin;
    const std::span<KeyedRow> shared = std::span(other).subspan(begin, size);
    const std::span<KeyedRow> wanted = std::span(keyed).subspan(begin, size);
    const std::span<KeyedRow> sorted = radix_sort(shared, wanted, kKeyBits);
    if (sorted.data() != wanted.data()) std::copy(sorted.begin(), sorted.end(), wanted.begin());
  });
}

}  // namespace thalweg::detail
