/// Huge pages or small ones, where the hypervisor takes free memory back.
///
/// It is told of free blocks from a huge page on, some seconds after they became free, and never of smaller
/// ones. So a huge page may be one that it has to find first, in 512 pieces of its own: six milliseconds,
/// when small pages from the remains of larger blocks are at hand in less than one. Which ones the system
/// hands out shows only when they are touched, and then changes: what a call has just given back is at hand
/// for a while.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>

#include "kernel/huge_pages.hpp"

namespace thalweg::detail {

/// Chooses by the time that first touches take. For many threads at once; results never depend on it.
class PageChoice {
 public:
  using Duration = std::chrono::steady_clock::duration;

  /// More than it takes to clear a huge page that is at hand, a tenth to half of a millisecond.
  static constexpr Duration kAtHand = std::chrono::milliseconds(1);
  /// What is in small pages before a huge one is tried again: trying costs one of 128.
  static constexpr std::size_t kSmallInARow = 128 * kHugePage;
  /// From here on every huge page is tried, since the memory that is at hand may end within. Less is left to
  /// the threads that are to fill it, and judged by its first page.
  static constexpr std::size_t kLong = 32 * kHugePage;

  /// How many of the first of so many bytes should be in huge pages. touch(at) touches the huge page that
  /// begins with byte `at`, and returns how long that took; small() how long as much takes in small pages.
  template <class Touch, class Small>
  std::size_t huge_bytes(std::size_t bytes, const Touch& touch, const Small& small) noexcept {
    if (take_small(bytes)) return 0;
    const std::size_t tried = bytes < kLong ? std::min(bytes, kHugePage) : bytes;
    for (std::size_t end = kHugePage; end <= tried; end += kHugePage) {
      const Duration time = touch(end - kHugePage);
      if (time <= kAtHand) continue;
      if (time <= small()) break;
      small_left_.store(kSmallInARow, std::memory_order_relaxed);
      return end;
    }
    return bytes;
  }

 private:
  /// Whether small pages are still to come, and then counts these.
  bool take_small(std::size_t bytes) noexcept {
    const std::size_t left = small_left_.load(std::memory_order_relaxed);
    if (left == 0) return false;
    small_left_.store(left - std::min(left, bytes), std::memory_order_relaxed);
    return true;
  }

  std::atomic<std::size_t> small_left_ = 0;
};

/// Asks the system for huge pages in this memory, which begins with one and has not been touched yet; if
/// somebody takes free memory back, only where they cost less than small ones.
void choose_pages(char* memory, std::size_t bytes) noexcept;

}  // namespace thalweg::detail
