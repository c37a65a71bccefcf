/// Memory for arrays: large ones come from the system in huge pages, where it has them.
#include "thalweg/array.hpp"

#include <new>

#include "kernel/cut_short.hpp"
#include "kernel/huge_pages.hpp"

namespace thalweg::detail {
namespace {

bool is_mapped(std::size_t bytes) noexcept {
  return bytes >= kLeastOfHugePage && can_map_huge_pages();
}

}  // namespace

void* allocate_array(std::size_t count, std::size_t size) {
  if (count > static_cast<std::size_t>(-1) / size) throw std::bad_array_new_length();
  const std::size_t bytes = count * size;
  if (!is_mapped(bytes)) return ::operator new(bytes);
  if (void* memory = map_huge_pages(bytes)) return memory;
  throw std::bad_alloc();
}

void deallocate_array(void* memory, std::size_t count, std::size_t size) noexcept {
  const std::size_t bytes = count * size;
  if (is_mapped(bytes)) {
    unmap_huge_pages(memory, bytes);
  } else {
    ::operator delete(memory);
  }
}

bool release_behind(void* memory, std::size_t bytes, std::size_t used) noexcept {
  return is_mapped(bytes) && release_huge_pages(memory, bytes, used);
}

}  // namespace thalweg::detail
