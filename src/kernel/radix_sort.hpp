/// Sorting rows by 32-bit keys, on all threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "thalweg/array.hpp"

namespace thalweg::detail {

/// Key in the upper half, row in the lower.
using KeyedRow = std::uint64_t;

inline KeyedRow keyed_row(std::uint32_t key, std::uint32_t row) noexcept {
  return KeyedRow{key} << 32 | row;
}
inline std::uint32_t key_of(KeyedRow k) noexcept {
  return static_cast<std::uint32_t>(k >> 32);
}
inline std::uint32_t row_of(KeyedRow k) noexcept {
  return static_cast<std::uint32_t>(k);
}

/// Sorts by key, and equal keys by row. Requires: rows ascend. The result does not depend on `threads`.
/// Complexity: O(n), for every thread.
void radix_sort(Array<KeyedRow>& keyed, unsigned threads);

/// The same in one thread and without memory of its own, for keys that may differ in their lowest `bits` bits
/// only. Returns which of `rows` and `other` has the sorted rows; the other one has nothing any more.
/// Requires: both are of the same length.
std::span<KeyedRow> radix_sort(std::span<KeyedRow> rows, std::span<KeyedRow> other, unsigned bits) noexcept;

/// Calls visit(begin, end) for each run of equal keys. Requires: sorted by key. Complexity: O(n).
template <class Visit>
void for_each_run(std::span<const KeyedRow> keyed, Visit&& visit) {
  for (std::size_t begin = 0, end = 0; begin < keyed.size(); begin = end) {
    while (end < keyed.size() && key_of(keyed[end]) == key_of(keyed[begin])) ++end;
    visit(begin, end);
  }
}

/// Sorts the rows of each run of equal keys by less(row, row). Complexity: O(n), and O(m log m) for a run of
/// m.
template <class Less>
void sort_runs(Array<KeyedRow>& keyed, Less&& less) {
  for_each_run(keyed, [&](std::size_t begin, std::size_t end) {
    std::sort(keyed.data() + begin, keyed.data() + end,
              [&](KeyedRow a, KeyedRow b) { return less(row_of(a), row_of(b)); });
  });
}

}  // namespace thalweg::detail
