/// Doubles seen as integers times powers of two: what the exact stages of the predicates are built from.
#pragma once

#include <bit>
#include <cfloat>
#include <cstdint>
#include <limits>

// Every sign rests on each operation being rounded once, as written. clang++ has no macros for the single
// parts of -ffast-math but a pragma against the one that matters.
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0)
#error "thalweg needs IEEE 754 arithmetic: compile without -ffast-math and its parts"
#endif
#if FLT_EVAL_METHOD != 0
#error "thalweg needs double arithmetic without excess precision: on x86-32 compile with -msse2 -mfpmath=sse"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#pragma clang fp reassociate(off)
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif

namespace thalweg::detail {

static_assert(std::numeric_limits<double>::is_iec559 && DBL_MANT_DIG == 53 && DBL_MAX_EXP == 1024);

/// The largest relative error of one operation that neither overflows nor underflows, to nearest.
inline constexpr double kUnitRoundoff = DBL_EPSILON / 2;
static_assert(kUnitRoundoff == 0x1p-53);

inline constexpr int kExponentBias = 1023;

/// The e with 2^e <= |value| < 2^(e+1); -1023 for zero and denormals, 1024 for infinities and NaN.
inline int exponent_of(double value) noexcept {
  return static_cast<int>((std::bit_cast<std::uint64_t>(value) >> 52) & 0x7ff) - kExponentBias;
}

/// 2^exponent. Requires: -1022 <= exponent <= 1023.
inline double power_of_two(int exponent) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + kExponentBias) << 52);
}

inline int sign_of(double value) noexcept {
  return static_cast<int>(value > 0) - static_cast<int>(value < 0);
}

/// A finite double taken apart: (negative ? -1 : 1) * mantissa * 2^exponent.
struct Parts {
  std::uint64_t mantissa;
  int exponent;
  bool negative;
};

inline Parts take_apart(double value) noexcept {
  constexpr std::uint64_t kHiddenBit = std::uint64_t{1} << 52;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const bool negative = (bits >> 63) != 0;
  const std::uint64_t fraction = bits & (kHiddenBit - 1);
  const int exponent = exponent_of(value);
  if (exponent == -kExponentBias) return {fraction, 1 - kExponentBias - 52, negative};
  return {fraction | kHiddenBit, exponent - 52, negative};
}

/// The exponent of the lowest bit set in `value`, or `otherwise` for zero.
inline int lowest_bit(double value, int otherwise) noexcept {
  const Parts parts = take_apart(value);
  return parts.mantissa == 0 ? otherwise : parts.exponent + std::countr_zero(parts.mantissa);
}

}  // namespace thalweg::detail
