/// 64 x 64 -> 128 bit products, which standard C++ does not have.
#pragma once

#include <cstdint>

namespace thalweg::detail {

#if defined(__SIZEOF_INT128__)
#define THALWEG_HAS_INT128 1
__extension__ using Int128 = __int128;
__extension__ using Uint128 = unsigned __int128;
#endif

/// The low half of a * b + addend + carry_in; `high` becomes the high half. Cannot overflow: (2^64-1)^2 + 2
/// (2^64-1) = 2^128 - 1. Schoolbook in halves of 32 bits, for machines without wide integers.
inline std::uint64_t multiply_add_in_halves(std::uint64_t a, std::uint64_t b, std::uint64_t addend,
                                            std::uint64_t carry_in, std::uint64_t& high) noexcept {
  constexpr std::uint64_t kMask = 0xffffffffu;
  const std::uint64_t low = (a & kMask) * (b & kMask);
  const std::uint64_t cross = (a >> 32) * (b & kMask) + (low >> 32);
  const std::uint64_t other = (a & kMask) * (b >> 32) + (cross & kMask);
  std::uint64_t top = (a >> 32) * (b >> 32) + (cross >> 32) + (other >> 32);
  std::uint64_t bottom = (other << 32) | (low & kMask);
  bottom += addend;
  top += static_cast<std::uint64_t>(bottom < addend);
  bottom += carry_in;
  top += static_cast<std::uint64_t>(bottom < carry_in);
  high = top;
  return bottom;
}

/// The same by the machine's own wide product where there is one.
inline std::uint64_t multiply_add(std::uint64_t a, std::uint64_t b, std::uint64_t addend,
                                  std::uint64_t carry_in, std::uint64_t& high) noexcept {
#if defined(THALWEG_HAS_INT128)
  const Uint128 product = static_cast<Uint128>(a) * b + addend + carry_in;
  high = static_cast<std::uint64_t>(product >> 64);
  return static_cast<std::uint64_t>(product);
#else
  return multiply_add_in_halves(a, b, addend, carry_in, high);
#endif
}

}  // namespace thalweg::detail
