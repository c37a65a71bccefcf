/// Large arrays in large pages: touching fresh memory for the first time is then several times cheaper, and
/// so is reaching far into it. A hint only: nothing depends on it, and outside Linux it does nothing.
#pragma once

#include <cstddef>
#include <vector>

namespace thalweg::detail {

/// Asks the system to back these bytes with huge pages, if there are enough of them to matter.
/// Requires: memory that was not touched yet, or the hint is useless.
void prefer_huge_pages(void* data, std::size_t bytes) noexcept;

/// `count` zeros. Complexity: O(count); throws std::bad_alloc.
template <class T>
std::vector<T> large_vector(std::size_t count) {
  std::vector<T> result;
  result.reserve(count);
  prefer_huge_pages(result.data(), count * sizeof(T));
  result.resize(count);
  return result;
}

}  // namespace thalweg::detail
