/// Memory for large arrays, with the hint for huge pages where the system takes one.
#include "thalweg/array.hpp"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace thalweg::detail {
namespace {

/// A hint only: nothing depends on it, and outside Linux it does nothing. Requires: memory that was not
/// touched yet, or the hint is useless.
void prefer_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t kWorthwhile = std::size_t{4} << 20;
  if (bytes < kWorthwhile) return;
  const long page = sysconf(_SC_PAGESIZE);
  if (page <= 0) return;
  // Only whole pages of ours: the first and the last may hold something else too.
  const std::size_t skip = -reinterpret_cast<std::uintptr_t>(data) % static_cast<std::size_t>(page);
  const std::size_t length = (bytes - skip) / static_cast<std::size_t>(page) * static_cast<std::size_t>(page);
  // A refusal (an old kernel, a setting) changes nothing but the speed.
  static_cast<void>(madvise(static_cast<char*>(data) + skip, length, MADV_HUGEPAGE));
#endif
}

}  // namespace

void* allocate_array(std::size_t count, std::size_t size) {
  if (count > static_cast<std::size_t>(-1) / size) throw std::bad_array_new_length();
  const std::size_t bytes = count * size;
  void* memory = ::operator new(bytes);
  prefer_huge_pages(memory, bytes);
  return memory;
}

void deallocate_array(void* memory) noexcept {
  ::operator delete(memory);
}

}  // namespace thalweg::detail
