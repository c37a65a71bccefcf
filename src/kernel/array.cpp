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

constexpr std::size_t kHugePage = std::size_t{1} << 21;

/// A hint only: nothing depends on it, and outside Linux it does nothing. Requires: memory that was not
/// touched yet, or the hint is useless.
void prefer_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::size_t kWorthwhile = 2 * kHugePage;
  if (bytes < kWorthwhile) return;
  const long page = sysconf(_SC_PAGESIZE);
  if (page <= 0) return;
  // From the page of the first byte: what an allocator puts before it in a mapping of its own must not cost a
  // huge page. A refusal (an old kernel, a setting) changes nothing but the speed.
  const std::size_t before = reinterpret_cast<std::uintptr_t>(data) % static_cast<std::size_t>(page);
  static_cast<void>(madvise(static_cast<char*>(data) - before, bytes + before, MADV_HUGEPAGE));
#endif
}

/// Where allocators give an array a mapping of its own (glibc: from 32 MB on, always), whole huge pages of
/// it, with room for what they put before it: Linux then begins the mapping with a huge page, and none of it
/// is small ones.
std::size_t whole_huge_pages(std::size_t bytes) noexcept {
  constexpr std::size_t kOwnMapping = std::size_t{32} << 20, kHeader = 64;
  if (bytes < kOwnMapping || bytes > static_cast<std::size_t>(-1) / 2) return bytes;
  return (bytes + kHeader + kHugePage - 1) / kHugePage * kHugePage - kHeader;
}

}  // namespace

void* allocate_array(std::size_t count, std::size_t size) {
  if (count > static_cast<std::size_t>(-1) / size) throw std::bad_array_new_length();
  const std::size_t bytes = whole_huge_pages(count * size);
  void* memory = ::operator new(bytes);
  prefer_huge_pages(memory, bytes);
  return memory;
}

void deallocate_array(void* memory) noexcept {
  ::operator delete(memory);
}

}  // namespace thalweg::detail
