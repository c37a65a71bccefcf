/// Settings of glibc's allocator, and a heap of huge pages.
#include "cli/memory.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

// The address sanitizer has an allocator of its own, and pairs every delete with its own new.
#if defined(__SANITIZE_ADDRESS__)
#define THALWEG_OWN_HEAP 0
#elif defined(__has_feature)
#define THALWEG_OWN_HEAP !__has_feature(address_sanitizer)
#else
#define THALWEG_OWN_HEAP 1
#endif

#if defined(__GLIBC__) && THALWEG_OWN_HEAP
#include <malloc.h>

#include "io/huge_pages.hpp"

namespace thalweg::cli {
namespace {

constexpr int kMegabyte = 1 << 20;
constexpr int kOwnMapping = 32 * kMegabyte;  // glibc's allocator keeps no more than this in its heap
constexpr int kSmall = kMegabyte / 16;       // less than this is not worth a look at the heap

/// Huge pages for what the heap has grown by since the last call.
void prefer_huge_pages_in_heap() noexcept {
  static std::atomic<char*> end_before = nullptr;
  char* const end = static_cast<char*>(sbrk(0));
  char* const begin = end_before.exchange(end);
  if (begin != nullptr && begin < end) io::prefer_huge_pages(begin, static_cast<std::size_t>(end - begin));
}

/// Then nothing is reserved that may not be needed.
bool is_limited(decltype(RLIMIT_AS) resource) noexcept {
  rlimit limit{};
  return getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace

void keep_freed_memory() noexcept {
  mallopt(M_MMAP_THRESHOLD, kOwnMapping);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
  if (!is_limited(RLIMIT_AS) && !is_limited(RLIMIT_DATA)) mallopt(M_TOP_PAD, 64 * kMegabyte);
  prefer_huge_pages_in_heap();
}

}  // namespace thalweg::cli

/// The command's own: whoever asks for much is about to touch it.
void* operator new(std::size_t size) {
  void* const block = std::malloc(size == 0 ? 1 : size);
  if (block == nullptr) throw std::bad_alloc();
  if (size >= std::size_t{thalweg::cli::kOwnMapping}) {
    thalweg::io::prefer_huge_pages(block, size);
  } else if (size >= std::size_t{thalweg::cli::kSmall}) {
    thalweg::cli::prefer_huge_pages_in_heap();
  }
  return block;
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}

#else

void thalweg::cli::keep_freed_memory() noexcept {}

#endif
