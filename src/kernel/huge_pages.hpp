/// Huge pages: fresh memory costs a visit to the system for every page that is touched first, from a quarter
/// of a microsecond to ten under some hypervisors. A page of 2 MB costs little more than one of its 512 small
/// ones.
#pragma once

#include <cstddef>

namespace thalweg::detail {

/// As x86-64 has them, and ARM with small pages of 4 KB. Where they are larger, only the advantage is lost.
inline constexpr std::size_t kHugePage = std::size_t{1} << 21;

/// Less than this is left in small pages. A huge one is cleared in the time in which 8 of them are touched
/// under some hypervisors, and 200 elsewhere: with 32 little is lost anywhere.
inline constexpr std::size_t kLeastOfHugePage = kHugePage / 16;

/// Whether memory can be had from the system in huge pages. Not under the address sanitizer, which guards
/// only what operator new returns.
bool can_map_huge_pages() noexcept;

/// Memory that begins with a huge page and is made of them, but for a rest that is less than
/// kLeastOfHugePage; nullptr if there is no more. Requires: can_map_huge_pages().
void* map_huge_pages(std::size_t bytes) noexcept;
/// Gives back what map_huge_pages(bytes) returned.
void unmap_huge_pages(void* memory, std::size_t bytes) noexcept;
/// Gives back what is in whole huge pages behind the first `used` bytes of it; the addresses are kept.
bool release_huge_pages(void* memory, std::size_t bytes, std::size_t used) noexcept;

/// While one exists, what this thread gives back is kept for what it asks for next: pages need not be cleared
/// again. All goes to the system as soon as nothing that is kept is large enough, so that arrays never take
/// more than they once needed. Not for long work: what is kept is lost to all others.
class KeptPages {
 public:
  KeptPages() noexcept;
  ~KeptPages();
  KeptPages(const KeptPages&) = delete;
  KeptPages& operator=(const KeptPages&) = delete;
};

}  // namespace thalweg::detail
