/// Arrays that are not zeroed before they are filled: the threads that fill them are then the first to touch
/// their memory, and no time goes into zeros.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "thalweg/export.hpp"

namespace thalweg::detail {

/// Memory of so many elements of so many bytes: of operator new, but from 128 KB on straight from the
/// system in huge pages, where it has them. Touching it for the first time is then up to fifty times cheaper,
/// and so is reaching far into it; small pages are taken where a hypervisor makes them the cheaper ones.
/// Throws std::bad_alloc: out of line, so that users may compile without exceptions.
THALWEG_EXPORT void* allocate_array(std::size_t count, std::size_t size);
/// Gives back what allocate_array(count, size) returned.
THALWEG_EXPORT void deallocate_array(void* memory, std::size_t count, std::size_t size) noexcept;

/// An allocator for std::vector under which elements that are not given are default-initialised: numbers have
/// no value yet.
template <class T>
struct UninitializedAllocator {
  using value_type = T;

  UninitializedAllocator() = default;
  template <class U>
  UninitializedAllocator(const UninitializedAllocator<U>&) noexcept {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_array(count, sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept { deallocate_array(memory, count, sizeof(T)); }

  template <class U>
  void construct(U* place) noexcept {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(static_cast<Arguments&&>(arguments)...);
  }

  friend bool operator==(const UninitializedAllocator&, const UninitializedAllocator&) noexcept {
    return true;
  }
};

template <class T>
using Array = std::vector<T, UninitializedAllocator<T>>;

}  // namespace thalweg::detail
