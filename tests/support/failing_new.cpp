#include "support/failing_new.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> left = -1;  // calls that still succeed; negative: all
std::atomic<bool> only_one = false;
std::atomic<long> failed = 0;
std::atomic<long> live = 0;

/// Counts down to 0 and stays there, or goes on to -1 if only one call is to fail.
bool may_allocate() noexcept {
  long now = left.load();
  while (now >= 0 && !(now == 0 && !only_one) && !left.compare_exchange_weak(now, now - 1)) {
  }
  if (now == 0) ++failed;
  return now != 0;
}

void* allocate(std::size_t size) noexcept {
  void* const memory = may_allocate() ? std::malloc(size == 0 ? 1 : size) : nullptr;
  if (memory != nullptr) ++live;
  return memory;
}

void release(void* memory) noexcept {
  if (memory != nullptr) --live;
  std::free(memory);
}

void start(long after, bool one) noexcept {
  left = -1;
  failed = 0;
  only_one = one;
  left = after;
}

}  // namespace

void fail_allocations(long after) {
  start(after, false);
}

void fail_one_allocation(long after) {
  start(after, true);
}

long failed_allocations() {
  return failed;
}

long live_allocations() {
  return live;
}

void* operator new(std::size_t size) {
  if (void* memory = allocate(size)) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size);
}

void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  release(memory);
}
