/// Memory asked for ahead of its use.
#pragma once

namespace thalweg::detail {

/// A hint that what lies at `address` will be needed soon: nothing depends on it.
inline void prefetch([[maybe_unused]] const void* address) noexcept {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
  asm volatile(
      "");  // else g++ sees a function without effect, and leaves out the calls of those that call it
#endif
}

}  // namespace thalweg::detail
