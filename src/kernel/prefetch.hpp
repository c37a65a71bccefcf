/// Memory asked for ahead of its use.
#pragma once

namespace thalweg::detail {

/// A hint that what lies at `address` will be needed soon: nothing depends on it.
inline void prefetch([[maybe_unused]] const void* address) noexcept {
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
  // Without this g++ sees a function without effect, and leaves out the calls of functions that do nothing
  // else.
  asm volatile("");
#endif
}

}  // namespace thalweg::detail
