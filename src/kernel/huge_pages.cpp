/// Huge pages of Linux; elsewhere there are none.
#include "kernel/huge_pages.hpp"

#if defined(__linux__)
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <array>
#include <cstdint>

#include "kernel/assert.hpp"
#include "kernel/page_choice.hpp"

namespace thalweg::detail {

#if defined(__linux__) && defined(MADV_HUGEPAGE)

namespace {

std::size_t small_page() noexcept {
  static const long bytes = sysconf(_SC_PAGESIZE);
  return bytes > 0 ? static_cast<std::size_t>(bytes) : kHugePage;
}

/// What is missing to a multiple of a page.
std::size_t missing(std::size_t bytes, std::size_t page) noexcept {
  return (page - bytes % page) % page;
}

/// Whole pages: huge ones, but for a rest that is not worth one.
std::size_t length_of(std::size_t bytes) noexcept {
  return bytes + missing(bytes, bytes % kHugePage >= kLeastOfHugePage ? kHugePage : small_page());
}

std::size_t below_huge_page(const void* memory) noexcept {
  return missing(reinterpret_cast<std::uintptr_t>(memory), kHugePage);
}

/// Ranges of whole huge pages that were given back.
class Kept {
 public:
  /// The first `bytes` of a range, or nullptr. What is left of its last huge page goes to the system.
  char* take(std::size_t bytes) noexcept {
    const std::size_t whole = bytes + missing(bytes, kHugePage);
    for (std::size_t i = 0; i < count_; ++i) {
      Range& range = ranges_[i];
      if (range.bytes < whole) continue;
      char* const memory = range.begin;
      if (whole > bytes) munmap(memory + bytes, whole - bytes);
      range = {memory + whole, range.bytes - whole};
      if (range.bytes == 0) range = ranges_[--count_];
      return memory;
    }
    return nullptr;
  }

  /// Keeps the whole huge pages of a range.
  void give(char* memory, std::size_t bytes) noexcept {
    const std::size_t rest = bytes % kHugePage;
    if (rest > 0) munmap(memory + (bytes - rest), rest);
    if (bytes == rest) return;
    if (count_ == ranges_.size()) release();
    ranges_[count_++] = {memory, bytes - rest};
  }

  void release() noexcept {
    while (count_ > 0) {
      --count_;
      munmap(ranges_[count_].begin, ranges_[count_].bytes);
    }
  }

  unsigned scopes = 0;  ///< of KeptPages

 private:
  struct Range {
    char* begin;
    std::size_t bytes;
  };
  std::array<Range, 16> ranges_{};
  std::size_t count_ = 0;
};

thread_local Kept kept;

}  // namespace

KeptPages::KeptPages() noexcept {
  ++kept.scopes;
}

KeptPages::~KeptPages() {
  if (--kept.scopes == 0) kept.release();
}

bool can_map_huge_pages() noexcept {
#if defined(__has_feature)
  return !__has_feature(address_sanitizer);
#elif defined(__SANITIZE_ADDRESS__)
  return false;
#else
  return true;
#endif
}

void* map_huge_pages(std::size_t bytes) noexcept {
  if (bytes > static_cast<std::size_t>(-1) / 2) return nullptr;
  const std::size_t length = length_of(bytes);
  if (char* const memory = kept.take(length)) return memory;
  kept.release();
  void* const mapping =
      mmap(nullptr, length + kHugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapping == MAP_FAILED) return nullptr;
  // Mappings begin with any small page: what is before the first huge one and behind the end goes back.
  const std::size_t before = below_huge_page(mapping);
  char* const memory = static_cast<char*>(mapping) + before;
  if (before > 0) munmap(mapping, before);
  munmap(memory + length, kHugePage - before);
  choose_pages(memory, length);
  return memory;
}

void unmap_huge_pages(void* memory, std::size_t bytes) noexcept {
  THALWEG_ASSERT(below_huge_page(memory) == 0);
  if (kept.scopes > 0) {
    kept.give(static_cast<char*>(memory), length_of(bytes));
  } else {
    munmap(memory, length_of(bytes));
  }
}

bool release_huge_pages(void* memory, std::size_t bytes, std::size_t used) noexcept {
  const std::size_t begin = used + missing(used, kHugePage), end = length_of(bytes);
  return begin >= end || madvise(static_cast<char*>(memory) + begin, end - begin, MADV_DONTNEED) == 0;
}

#else

KeptPages::KeptPages() noexcept = default;
KeptPages::~KeptPages() = default;

bool can_map_huge_pages() noexcept {
  return false;
}
void* map_huge_pages(std::size_t) noexcept {
  return nullptr;
}
void unmap_huge_pages(void*, std::size_t) noexcept {}
bool release_huge_pages(void*, std::size_t, std::size_t) noexcept {
  return false;
}

#endif

}  // namespace thalweg::detail
