/// Decimal text to the nearest double, for the numbers that data files are full of: at most 19 digits and a
/// small power of ten. Everything else is left to std::from_chars, which the caller falls back on.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace thalweg::io {

/// The low half of a * b + addend; `high` becomes the high half. In halves of 32 bits where the compiler has
/// no wider numbers.
inline std::uint64_t multiply_add(std::uint64_t a, std::uint64_t b, std::uint64_t addend,
                                  std::uint64_t& high) noexcept {
#if defined(__SIZEOF_INT128__)
  __extension__ using Wide = unsigned __int128;
  const Wide sum = static_cast<Wide>(a) * b + addend;
  high = static_cast<std::uint64_t>(sum >> 64);
  return static_cast<std::uint64_t>(sum);
#else
  constexpr std::uint64_t kLow = 0xffffffffu;
  const std::uint64_t low = (a & kLow) * (b & kLow) + (addend & kLow);
  const std::uint64_t cross = (a >> 32) * (b & kLow) + (low >> 32) + (addend >> 32);
  const std::uint64_t other = (a & kLow) * (b >> 32) + (cross & kLow);
  high = (a >> 32) * (b >> 32) + (cross >> 32) + (other >> 32);
  return other << 32 | (low & kLow);
#endif
}

/// The largest power of five below 2^63 is 5^27.
inline constexpr int kLargestPower = 27;

/// 5^k with its highest bit shifted to the top, and what division by it needs.
struct PowerOfFive {
  std::uint64_t divisor = 0;     ///< 5^k << shift, at least 2^63
  std::uint64_t reciprocal = 0;  ///< floor((2^128 - 1) / divisor) - 2^64
  int shift = 0;
};

inline constexpr std::array<PowerOfFive, kLargestPower + 1> kPowersOfFive = [] {
  std::array<PowerOfFive, kLargestPower + 1> powers{};
  std::uint64_t five = 1;
  for (PowerOfFive& power : powers) {
    power.shift = std::countl_zero(five);
    power.divisor = five << power.shift;
    // Long division of 2^128 - 1 - 2^64 divisor, bit by bit; the high half is below the divisor.
    std::uint64_t rest = ~power.divisor;
    for (int bit = 0; bit < 64; ++bit) {
      const bool carry = rest >> 63 != 0;
      rest = rest << 1 | 1;
      power.reciprocal <<= 1;
      if (carry || rest >= power.divisor) {
        rest -= power.divisor;
        power.reciprocal |= 1;
      }
    }
    five *= 5;
  }
  return powers;
}();

/// 2^exponent. Requires: the exponent of a normal double.
inline double power_of_two(int exponent) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
}

/// floor(high:low / divisor), with the lowest bit set if the division leaves a rest ("sticky").
/// Requires: high < divisor. Source: Moeller and Granlund, Improved division by invariant integers, 2011,
/// algorithm 4.
inline std::uint64_t sticky_quotient(std::uint64_t high, std::uint64_t low,
                                     const PowerOfFive& power) noexcept {
  std::uint64_t quotient = 0;
  const std::uint64_t fraction = multiply_add(power.reciprocal, high, low, quotient);
  quotient += high + 1;
  std::uint64_t rest = low - quotient * power.divisor;
  const std::uint64_t too_large = -static_cast<std::uint64_t>(rest > fraction);  // all ones, or zero
  quotient += too_large;
  rest += too_large & power.divisor;
  if (rest >= power.divisor) [[unlikely]] {
    ++quotient;
    rest -= power.divisor;
  }
  return quotient | static_cast<std::uint64_t>(rest != 0);
}

/// The double nearest to digits * 10^exponent, ties to even.
/// Exact: a quotient of two exact doubles is rounded once (Clinger 1990). Otherwise, with 62 bits or more and
/// a sticky bit below them the conversion to 53 bits is the only rounding; the power of two only moves the
/// exponent, far from either end of its range. Requires: digits != 0, |exponent| <= kLargestPower, rounding
/// to nearest.
inline double nearest_double(std::uint64_t digits, int exponent) noexcept {
  constexpr std::array<double, 23> kExactPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                   1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                   1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  // Below 2^53, and far enough for the digits of a full double to be predictably on one side.
  if (digits < 1000000000000000 && exponent <= 0 && exponent >= -22) {
    return static_cast<double>(static_cast<std::int64_t>(digits)) /
           kExactPowers[static_cast<std::size_t>(-exponent)];
  }
  const int zeros = std::countl_zero(digits);
  const std::uint64_t normal = digits << zeros;
  if (exponent <= 0) {
    const PowerOfFive& power = kPowersOfFive[static_cast<std::size_t>(-exponent)];
    // Divided as digits * 2^62, so that the quotient fits a signed number, whose conversion is the faster.
    const std::uint64_t quotient = sticky_quotient(normal >> 2, normal << 62, power);
    return static_cast<double>(static_cast<std::int64_t>(quotient)) *
           power_of_two(power.shift - zeros + exponent - 62);
  }
  const PowerOfFive& power = kPowersOfFive[static_cast<std::size_t>(exponent)];
  std::uint64_t high = 0;
  const std::uint64_t low = multiply_add(normal, power.divisor, 0, high);
  const std::uint64_t sticky = high >> 1 | (high & 1) | static_cast<std::uint64_t>(low != 0);
  return static_cast<double>(static_cast<std::int64_t>(sticky)) *
         power_of_two(65 - zeros - power.shift + exponent);
}

/// The number that eight digits make, each the value of a byte, the first in the lowest.
inline std::uint64_t eight_digits(std::uint64_t bytes) noexcept {
  bytes = bytes * 10 + (bytes >> 8);  // pairs, in every second byte
  const std::uint64_t left = (bytes & 0x000000ff000000ffu) * (100 + (std::uint64_t{1000000} << 32));
  const std::uint64_t right = (bytes >> 16 & 0x000000ff000000ffu) * (1 + (std::uint64_t{10000} << 32));
  return (left + right) >> 32;
}

/// Appends the digits at `at` to the number `digits`, wrapping around, and returns their end. Runs of digits
/// have all lengths, which no branch predicts, so up to eight are taken without one.
inline const char* take_digits(const char* at, const char* last, std::uint64_t& digits) noexcept {
  constexpr std::array<std::uint64_t, 8> kPowers = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000};
  while (std::endian::native == std::endian::little && last - at >= 8) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, at, sizeof bytes);
    bytes ^= 0x3030303030303030u;  // digits become 0 to 9
    // The high bit of each byte above 9; carries reach only bytes after the first of these.
    const std::uint64_t others = ((bytes + 0x7676767676767676u) | bytes) & 0x8080808080808080u;
    if (others != 0) {
      const int count = std::countr_zero(others) / 8;
      bytes = bytes << (56 - 8 * count) << 8;  // zeros before the digits
      digits = digits * kPowers[static_cast<std::size_t>(count)] + eight_digits(bytes);
      return at + count;
    }
    digits = digits * 100000000 + eight_digits(bytes);
    at += 8;
  }
  for (; at != last && static_cast<unsigned char>(*at - '0') < 10; ++at)
    digits = digits * 10 + static_cast<unsigned char>(*at - '0');
  return at;
}

/// Parses [-]digits[.digits][e[+-]digits] at `first` and returns its end; nullptr if it is not that, or too
/// long or too far from 1 to be done here. Agrees with std::from_chars bit for bit.
inline const char* scan_decimal(const char* first, const char* last, double& value) noexcept {
  constexpr std::ptrdiff_t kMostDigits = 19;  // fit 64 bits
  const char* at = first;
  const bool negative = at != last && *at == '-';
  if (negative) ++at;
  const char* const start = at;
  std::uint64_t digits = 0;
  at = take_digits(at, last, digits);
  std::ptrdiff_t count = at - start;
  std::ptrdiff_t exponent = 0;
  if (at != last && *at == '.') {
    const char* const fraction = ++at;
    at = take_digits(at, last, digits);
    exponent = fraction - at;
    count -= exponent;
  }
  if (count == 0) return nullptr;
  if (count > kMostDigits) [[unlikely]] {
    for (const char* zero = start; zero != at && (*zero == '0' || *zero == '.'); ++zero)
      count -= *zero == '0' ? 1 : 0;
    if (count > kMostDigits) return nullptr;
  }
  if (at != last && (*at | 0x20) == 'e') [[unlikely]] {
    const char* digit = at + 1;
    const bool down = digit != last && *digit == '-';
    if (digit != last && (*digit == '-' || *digit == '+')) ++digit;
    std::uint64_t written = 0;
    at = take_digits(digit, last, written);
    if (at == digit || at - digit > 4) return nullptr;
    exponent += down ? -static_cast<std::ptrdiff_t>(written) : static_cast<std::ptrdiff_t>(written);
  }
  if (digits == 0) {
    value = negative ? -0.0 : 0.0;
    return at;
  }
  if (exponent < -kLargestPower || exponent > kLargestPower) return nullptr;
  const double magnitude = nearest_double(digits, static_cast<int>(exponent));
  value = negative ? -magnitude : magnitude;
  return at;
}

}  // namespace thalweg::io
