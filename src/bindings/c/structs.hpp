/// Structs that may grow at their end: the caller's `struct_size` says how much of one the caller knows.
#pragma once

#include <cstddef>
#include <cstring>

namespace thalweg::bindings {

/// No struct will ever be larger: a size beyond was never set.
inline constexpr std::size_t kLargestStruct = 4096;

/// Whether a caller can have set this size. `least` is that of the struct's first version.
constexpr bool plausible_size(std::size_t size, std::size_t least) noexcept {
  return size >= least && size <= kLargestStruct;
}

/// Whether the part of the caller's struct that this library does not know is all zeros: asks for nothing.
template <class Struct>
bool asks_for_nothing_new(const Struct* theirs) noexcept {
  const auto* bytes = reinterpret_cast<const unsigned char*>(theirs);
  for (std::size_t i = sizeof(Struct); i < theirs->struct_size; ++i) {
    if (bytes[i] != 0) return false;
  }
  return true;
}

/// Copies what both sides know into the caller's struct and zeros what only the caller knows.
template <class Struct>
void give(Struct* theirs, Struct ours, std::size_t struct_size) noexcept {
  ours.struct_size = struct_size;
  const std::size_t known = struct_size < sizeof(Struct) ? struct_size : sizeof(Struct);
  std::memcpy(theirs, &ours, known);
  std::memset(reinterpret_cast<unsigned char*>(theirs) + known, 0, struct_size - known);
}

}  // namespace thalweg::bindings
