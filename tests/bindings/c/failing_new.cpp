#include "failing_new.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> left = -1;

/// Counts down to 0 and stays there; negative numbers stay as they are.
bool may_allocate() noexcept {
  long now = left.load();
  while (now > 0 && !left.compare_exchange_weak(now, now - 1)) {
  }
  return now != 0;
}

}  // namespace

void fail_allocations(long after) {
  left = after;
}

void* operator new(std::size_t size) {
  if (void* memory = may_allocate() ? std::malloc(size == 0 ? 1 : size) : nullptr) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return may_allocate() ? std::malloc(size == 0 ? 1 : size) : nullptr;
}

void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
