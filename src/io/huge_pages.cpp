/// The hint for huge pages, where the system takes one.
#include "io/huge_pages.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>

namespace thalweg::io {

void prefer_huge_pages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes) noexcept {
#if defined(MADV_HUGEPAGE)
  static const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t before = reinterpret_cast<std::uintptr_t>(data) % page;
  static_cast<void>(::madvise(static_cast<char*>(data) - before, bytes + before, MADV_HUGEPAGE));
#endif
}

}  // namespace thalweg::io
