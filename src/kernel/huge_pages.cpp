/// The hint for huge pages, where the system takes one.
#include "kernel/huge_pages.hpp"

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#endif

namespace thalweg::detail {

void prefer_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  if (bytes < kHugePage) return;
  const long page = sysconf(_SC_PAGESIZE);
  if (page <= 0) return;
  // From the page of the first byte: what the allocator put before it must not cost a huge page.
  const std::size_t before = reinterpret_cast<std::uintptr_t>(data) % static_cast<std::size_t>(page);
  // A refusal (an old kernel, a setting) changes nothing but the speed.
  static_cast<void>(madvise(static_cast<char*>(data) - before, bytes + before, MADV_HUGEPAGE));
#endif
}

}  // namespace thalweg::detail
