/// Huge pages: the first touch of fresh memory is what they make cheap. A page of 4 KB costs from a quarter of
/// a microsecond to ten (under some hypervisors), one of 2 MB, which is 512 of them, some hundred.
#pragma once

#include <cstddef>

namespace thalweg::detail {

/// As x86-64 has them, and ARM with pages of 4 KB. Where they are larger, nothing is lost but the advantage.
inline constexpr std::size_t kHugePage = std::size_t{1} << 21;

/// Asks the system for huge pages wherever whole ones lie in this memory. A hint only: nothing depends on it,
/// outside Linux it does nothing, and it is useless for what was touched already.
void prefer_huge_pages(void* data, std::size_t bytes) noexcept;

}  // namespace thalweg::detail
