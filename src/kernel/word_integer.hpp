/// Integers of one, two and four machine words: the determinants of nearly all real coordinates fit, and are
/// then computed exactly in a few dozen multiplications.
#pragma once

#include <cstdint>

#include "kernel/numbers.hpp"
#include "kernel/wide_multiply.hpp"

#if defined(THALWEG_HAS_INT128)

namespace thalweg::detail {

/// The two's complement sum of 256-bit products, least significant half first.
struct WordSum {
  Uint128 low = 0;
  Uint128 high = 0;

  /// Adds factor * other. Requires: the running sum stays below 2^255 in magnitude.
  void add_product(Uint128 factor, Int128 other) noexcept {
    const auto bits = static_cast<Uint128>(other);
    const auto f0 = static_cast<std::uint64_t>(factor), f1 = static_cast<std::uint64_t>(factor >> 64);
    const auto b0 = static_cast<std::uint64_t>(bits), b1 = static_cast<std::uint64_t>(bits >> 64);
    const Uint128 p00 = static_cast<Uint128>(f0) * b0, p01 = static_cast<Uint128>(f0) * b1;
    const Uint128 p10 = static_cast<Uint128>(f1) * b0, p11 = static_cast<Uint128>(f1) * b1;
    const Uint128 middle = (p00 >> 64) + static_cast<std::uint64_t>(p01) + static_cast<std::uint64_t>(p10);
    Uint128 product_high = p11 + (p01 >> 64) + (p10 >> 64) + (middle >> 64);
    // Taken as unsigned, a negative factor is 2^128 too large.
    if (other < 0) product_high -= factor;
    const Uint128 product_low = (middle << 64) | static_cast<std::uint64_t>(p00);
    low += product_low;
    high += product_high + static_cast<Uint128>(low < product_low);
  }

  int sign() const noexcept {
    if (static_cast<Int128>(high) < 0) return -1;
    return static_cast<int>((low | high) != 0);
  }
};

/// A difference of two places, in words. The products of two stay far inside 128 bits for coordinates of
/// WordScale::kBits.
struct WordVector {
  std::int64_t x, y;
};

inline Int128 product(std::int64_t a, std::int64_t b) noexcept {
  return static_cast<Int128>(a) * b;
}

inline Int128 cross(WordVector u, WordVector v) noexcept {
  return product(u.x, v.y) - product(u.y, v.x);
}

inline Uint128 squared_length(WordVector v) noexcept {
  return static_cast<Uint128>(product(v.x, v.x)) + static_cast<Uint128>(product(v.y, v.y));
}

/// Multiplies doubles by one power of two and turns them into integers, noting whether all of them were.
class WordScale {
 public:
  /// Coordinates of at most this many bits: see the static_assert on the determinants in predicates.cpp.
  static constexpr int kBits = 61;

  /// The scale that takes `largest`, in magnitude, into [2^(kBits - 1), 2^kBits).
  /// Range: the factor is a finite power of two, and at least 1, lest a product underflow to a false integer
  /// 0.
  explicit WordScale(double largest) noexcept {
    const int shift = kBits - 1 - exponent_of(largest);
    exact_ = shift >= 0 && shift <= kExponentBias;
    factor_ = power_of_two(exact_ ? shift : 0);
  }

  /// value * factor. Requires: |value| <= largest, exact() so far; meaningful only if exact() afterwards.
  std::int64_t operator()(double value) noexcept {
    const double scaled = value * factor_;
    const auto word = static_cast<std::int64_t>(scaled);
    exact_ &= static_cast<double>(word) == scaled;
    return word;
  }

  bool exact() const noexcept { return exact_; }

 private:
  double factor_;
  bool exact_;
};

}  // namespace thalweg::detail

#endif
