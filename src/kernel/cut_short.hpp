/// Arrays that end up smaller than they were made.
#pragma once

#include <cstddef>

#include "thalweg/array.hpp"

namespace thalweg::detail {

/// Gives what an array of so many bytes has behind its first `used` bytes back to the system, while the array
/// keeps the addresses. Returns whether it could.
bool release_behind(void* memory, std::size_t bytes, std::size_t used) noexcept;

/// Takes all but the first `count` elements from an array, and their memory, without moving those that are
/// left if the system lets it.
template <class T>
void cut_short(Array<T>& array, std::size_t count) {
  array.resize(count);
  if (!release_behind(array.data(), array.capacity() * sizeof(T), count * sizeof(T))) array.shrink_to_fit();
}

}  // namespace thalweg::detail
