/// A radix sort from the lowest digit up. Threads first share the rows by ranges of keys: each then sorts
/// what no other touches, where three passes of them all would have each read at each pass what others wrote.
#include "kernel/radix_sort.hpp"

#include <array>
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
/// From as many on the counts of long digits are worth a pass less.
constexpr std::size_t kManyRows = 1u << 13;

constexpr std::uint32_t passes_of(std::uint32_t digit_bits) noexcept {
  return (32 + digit_bits - 1) / digit_bits;
}

/// The stable sort by key, from `rows` to `other` and back, a pass for each digit: it ends in `other` after
/// an odd number of passes, else in `rows`.
template <std::uint32_t kDigitBits>
void sort_by_digits(std::span<KeyedRow> rows, std::span<KeyedRow> other) noexcept {
  constexpr std::uint32_t kDigits = 1u << kDigitBits;
  for (std::uint32_t pass = 0; pass < passes_of(kDigitBits); ++pass) {
    const auto digit = [pass](KeyedRow k) {
      return static_cast<std::uint32_t>(k >> (32 + kDigitBits * pass)) % kDigits;
    };
    std::array<std::uint32_t, kDigits> next{};
    for (const KeyedRow k : rows) ++next[digit(k)];
    std::uint32_t place = 0;
    for (std::uint32_t& count : next) place += std::exchange(count, place);
    for (const KeyedRow k : rows) other[next[digit(k)]++] = k;
    std::swap(rows, other);
  }
}

/// Digits of many rows: three passes.
constexpr std::uint32_t kLongDigit = 11;
/// Digits of some: four passes.
constexpr std::uint32_t kShortDigit = 8;
static_assert(passes_of(kLongDigit) % 2 == 1 && passes_of(kShortDigit) % 2 == 0, "where results are");

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

void radix_sort(Array<KeyedRow>& keyed, unsigned threads) {
  if (keyed.size() < kFewRows) {
    std::sort(keyed.begin(), keyed.end());
    return;
  }
  Array<KeyedRow> other(keyed.size());
  if (keyed.size() < kManyRows) {
    sort_by_digits<kShortDigit>(keyed, other);
    return;
  }
  const std::size_t ranges = parts_of(keyed.size(), kThreadRows, threads);
  if (ranges == 1) {
    sort_by_digits<kLongDigit>(keyed, other);
    keyed.swap(other);
    return;
  }
  const std::vector<std::uint32_t> begins = share_out(keyed, other, ranges);
  parallel_parts(ranges, ranges, [&](std::size_t range, std::size_t, std::size_t) {
    const std::size_t begin = begins[range], size = begins[range + 1] - begin;
    sort_by_digits<kLongDigit>(std::span(other).subspan(begin, size), std::span(keyed).subspan(begin, size));
  });
}

}  // namespace thalweg::detail
