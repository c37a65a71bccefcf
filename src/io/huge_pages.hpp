/// Huge pages for what is read into vectors, and for the command's heap.
#pragma once

#include <cstddef>

namespace thalweg::io {

/// Asks the system for huge pages wherever whole ones lie in this memory, which makes it several times
/// cheaper to touch for the first time. Begins with the small page of the first byte: what an allocator has
/// put before it must not cost a huge page. Only a hint: a refusal changes nothing but the speed.
void prefer_huge_pages(void* data, std::size_t bytes) noexcept;

}  // namespace thalweg::io
