/// Signed integers of a fixed capacity on the stack, for the exact stage of the predicates.
///
/// Every finite double is an integer multiple of 2^-1074 of at most 2098 bits, so a polynomial of bounded
/// degree in doubles is an integer of bounded size. The capacity is part of the type and grows with each
/// operation: that no result overflows is checked by the compiler, and nothing is allocated.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "kernel/numbers.hpp"
#include "kernel/wide_multiply.hpp"

namespace thalweg::detail {

/// Sign and magnitude, least significant limb first. Invariant: the limb below `size` is not 0; limbs from
/// `size` on are garbage; zero has size 0 and is not negative.
template <int Capacity>
struct BigInteger {
  int size = 0;
  bool negative = false;
  std::uint64_t limb[Capacity];  // deliberately not initialised: a kilobyte of zeros a call would dominate

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  BigInteger() noexcept {}

  int sign() const noexcept { return size == 0 ? 0 : negative ? -1 : 1; }

  void trim() noexcept {
    while (size > 0 && limb[size - 1] == 0) --size;
    if (size == 0) negative = false;
  }
};

/// The largest double has 1024 bits before the point and the smallest 1074 after it: 2098 bits, 33 limbs.
inline constexpr int kCoordinateLimbs = 33;
static_assert(64 * kCoordinateLimbs >= 1024 + 1074);

using BigCoordinate = BigInteger<kCoordinateLimbs>;

/// value / 2^unit. Requires: unit <= lowest_bit(value), so that this is an integer.
inline BigCoordinate to_integer(double value, int unit) noexcept {
  Parts parts = take_apart(value);
  BigCoordinate result;
  if (parts.mantissa == 0) return result;
  const int zeros = std::countr_zero(parts.mantissa);
  parts.mantissa >>= zeros;
  const int shift = parts.exponent + zeros - unit;
  const int first = shift / 64;
  const int offset = shift % 64;
  std::fill_n(result.limb, first, std::uint64_t{0});
  result.limb[first] = parts.mantissa << offset;
  result.size = first + 1;
  const std::uint64_t carried = offset == 0 ? 0 : parts.mantissa >> (64 - offset);
  if (carried != 0) result.limb[result.size++] = carried;
  result.negative = parts.negative;
  return result;
}

template <int N, int M>
int compare_magnitude(const BigInteger<N>& a, const BigInteger<M>& b) noexcept {
  if (a.size != b.size) return a.size < b.size ? -1 : 1;
  for (int i = a.size - 1; i >= 0; --i) {
    if (a.limb[i] != b.limb[i]) return a.limb[i] < b.limb[i] ? -1 : 1;
  }
  return 0;
}

/// result = |a| + |b|, for |a| of at least as many limbs as |b|.
template <int N, int M, int R>
void add_magnitude(const BigInteger<N>& a, const BigInteger<M>& b, BigInteger<R>& result) noexcept {
  std::uint64_t carry = 0;
  for (int i = 0; i < a.size; ++i) {
    const std::uint64_t other = i < b.size ? b.limb[i] : 0;
    const std::uint64_t sum = a.limb[i] + other;
    result.limb[i] = sum + carry;
    carry = static_cast<std::uint64_t>(sum < other) | static_cast<std::uint64_t>(result.limb[i] < sum);
  }
  result.size = a.size;
  if (carry != 0) result.limb[result.size++] = carry;
}

/// result = |a| - |b|, for |a| >= |b|.
template <int N, int M, int R>
void subtract_magnitude(const BigInteger<N>& a, const BigInteger<M>& b, BigInteger<R>& result) noexcept {
  std::uint64_t borrow = 0;
  for (int i = 0; i < a.size; ++i) {
    const std::uint64_t other = i < b.size ? b.limb[i] : 0;
    const std::uint64_t difference = a.limb[i] - other;
    result.limb[i] = difference - borrow;
    borrow = static_cast<std::uint64_t>(a.limb[i] < other) | static_cast<std::uint64_t>(difference < borrow);
  }
  result.size = a.size;
  result.trim();
}

/// a + b, or a - b if `minus`.
template <int N, int M>
auto sum(const BigInteger<N>& a, const BigInteger<M>& b, bool minus) noexcept {
  BigInteger<std::max(N, M) + 1> result;
  const bool b_negative = b.negative != minus;
  if (a.negative == b_negative) {
    result.negative = a.negative;
    if (a.size >= b.size) {
      add_magnitude(a, b, result);
    } else {
      add_magnitude(b, a, result);
    }
  } else if (compare_magnitude(a, b) >= 0) {
    result.negative = a.negative;
    subtract_magnitude(a, b, result);
  } else {
    result.negative = b_negative;
    subtract_magnitude(b, a, result);
  }
  result.trim();
  return result;
}

template <int N, int M>
auto operator+(const BigInteger<N>& a, const BigInteger<M>& b) noexcept {
  return sum(a, b, false);
}

template <int N, int M>
auto operator-(const BigInteger<N>& a, const BigInteger<M>& b) noexcept {
  return sum(a, b, true);
}

template <int N, int M>
auto operator*(const BigInteger<N>& a, const BigInteger<M>& b) noexcept {
  BigInteger<N + M> result;
  if (a.size == 0 || b.size == 0) return result;
  result.size = a.size + b.size;
  std::fill_n(result.limb, a.size, std::uint64_t{0});
  for (int j = 0; j < b.size; ++j) {
    std::uint64_t carry = 0;
    for (int i = 0; i < a.size; ++i) {
      result.limb[i + j] = multiply_add(a.limb[i], b.limb[j], result.limb[i + j], carry, carry);
    }
    result.limb[a.size + j] = carry;
  }
  result.negative = a.negative != b.negative;
  result.trim();
  return result;
}

}  // namespace thalweg::detail
