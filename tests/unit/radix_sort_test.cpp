/// Sorting rows by keys, whatever the number of threads; and runs of equal keys by comparison.
#include "kernel/radix_sort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace {

using thalweg::detail::Array;
using thalweg::detail::key_of;
using thalweg::detail::keyed_row;
using thalweg::detail::KeyedRow;
using thalweg::detail::row_of;

/// Rows with `different` keys spread over all 32 bits.
Array<KeyedRow> rows_with_keys(std::uint32_t count, std::uint32_t different) {
  std::minstd_rand random(7);
  Array<KeyedRow> rows(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto key = static_cast<std::uint32_t>(random() % different) * (0xffffffffu / different);
    rows[i] = keyed_row(key, i);
  }
  return rows;
}

void expect_sorted(const Array<KeyedRow>& rows) {
  std::vector<KeyedRow> expected(rows.begin(), rows.end());
  std::sort(expected.begin(), expected.end());  // as numbers: by key, then by row
  for (const unsigned threads : {1u, 2u, 5u}) {
    Array<KeyedRow> sorted = rows;
    thalweg::detail::radix_sort(sorted, threads);
    EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), expected.begin(), expected.end()))
        << rows.size() << " rows, " << threads << " threads";
  }
}

TEST(RadixSort, SortsByKeyThenByRowForAnyNumberOfThreads) {
  for (const std::uint32_t count : {0u, 1u, 95u, 96u, 1000u, 8191u, 8192u, 300'000u}) {
    expect_sorted(rows_with_keys(count, 1000));
  }
}

TEST(RadixSort, SortsKeysThatThreadsCannotShareWell) {
  for (const std::uint32_t different : {1u, 2u, 3u, 1u << 30}) {
    expect_sorted(rows_with_keys(200'000, different));
  }
  Array<KeyedRow> crowd = rows_with_keys(200'000, 1);
  crowd[99'999] = keyed_row(0xffffffffu, 99'999);
  expect_sorted(crowd);
}

TEST(RadixSort, SortsKeysThatDifferInTheirLowestBitsOnly) {
  for (const std::uint32_t count : {0u, 1u, 2u, 95u, 96u, 700u, 5000u}) {
    for (unsigned bits = 0; bits <= 32; ++bits) {
      Array<KeyedRow> rows = rows_with_keys(count, 3000), other(count);
      const auto upper = static_cast<std::uint32_t>(~std::uint64_t{0} << bits);
      for (KeyedRow& row : rows) row = keyed_row((key_of(row) & ~upper) | (0xa5a5a5a5u & upper), row_of(row));
      std::vector<KeyedRow> expected(rows.begin(), rows.end());
      std::sort(expected.begin(), expected.end());
      const std::span<const KeyedRow> sorted = thalweg::detail::radix_sort(rows, other, bits);
      ASSERT_TRUE(sorted.data() == rows.data() || sorted.data() == other.data());
      ASSERT_TRUE(std::equal(sorted.begin(), sorted.end(), expected.begin(), expected.end()))
          << count << " rows, " << bits << " bits";
    }
  }
}

TEST(RadixSort, SortsRunsOfEqualKeysByComparison) {
  Array<KeyedRow> rows = rows_with_keys(20'000, 300);
  thalweg::detail::radix_sort(rows, 1);
  thalweg::detail::sort_runs(rows, [](std::uint32_t a, std::uint32_t b) { return a > b; });
  EXPECT_TRUE(std::is_sorted(rows.begin(), rows.end(), [](KeyedRow a, KeyedRow b) {
    return key_of(a) != key_of(b) ? key_of(a) < key_of(b) : row_of(a) > row_of(b);
  }));
}

}  // namespace
