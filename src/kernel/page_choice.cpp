/// Pages of fresh memory under Linux; elsewhere there is no choice.
#include "kernel/page_choice.hpp"

#if defined(__linux__)
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <charconv>
#include <system_error>

namespace thalweg::detail {

#if defined(__linux__) && defined(MADV_HUGEPAGE)

namespace {

/// A refusal (an old kernel, a setting) changes nothing but the speed.
void advise(char* memory, std::size_t bytes, int advice) noexcept {
  if (bytes > 0) static_cast<void>(madvise(memory, bytes, advice));
}

/// Whether the hypervisor has asked to be told of free memory. The kernel says from which order of blocks on
/// it is, and -1, signed or not, if nobody has asked.
bool is_free_memory_reported() noexcept {
  const int file = open("/sys/module/page_reporting/parameters/page_reporting_order", O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  char text[16];
  const ssize_t length = read(file, text, sizeof text);
  close(file);
  unsigned order = 0;
  return length > 0 && std::from_chars(text, text + length, order).ec == std::errc() && order < 64;
}

/// How long the system takes for the first touch of one byte in each small page of fresh memory.
PageChoice::Duration time_of_touching(char* memory, std::size_t bytes) noexcept {
  constexpr std::size_t kLeastPage = 4096;
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < bytes; i += kLeastPage) *const_cast<volatile char*>(memory + i) = 0;
  return std::chrono::steady_clock::now() - start;
}

/// How long a huge page takes in small ones, from a part of them.
PageChoice::Duration time_of_small_pages() noexcept {
  constexpr std::size_t kPart = 8;
  void* const mapping =
      mmap(nullptr, kHugePage / kPart, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapping == MAP_FAILED) return PageChoice::Duration::max();
  char* const memory = static_cast<char*>(mapping);
  advise(memory, kHugePage / kPart, MADV_NOHUGEPAGE);
  const auto time = time_of_touching(memory, kHugePage / kPart);
  munmap(mapping, kHugePage / kPart);
  return time * kPart;
}

}  // namespace

void choose_pages(char* memory, std::size_t bytes) noexcept {
  static const bool is_reported = is_free_memory_reported();
  static PageChoice choice;
  advise(memory, bytes, MADV_HUGEPAGE);
  if (!is_reported) return;
  const auto touch = [memory](std::size_t at) noexcept { return time_of_touching(memory + at, 1); };
  const std::size_t huge = choice.huge_bytes(bytes, touch, time_of_small_pages);
  advise(memory + huge, bytes - huge, MADV_NOHUGEPAGE);
}

#else

void choose_pages(char*, std::size_t) noexcept {}

#endif

}  // namespace thalweg::detail
