#include "io/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "io/decimal.hpp"

namespace thalweg::io {
namespace {

bool is_digit(char c) noexcept {
  return c >= '0' && c <= '9';
}

// from_chars says "out of range" for 1e999 and for 1e-999 alike, and leaves the value alone. What tells them
// apart is the place of the leading digit: the decimal exponent of the number written scientifically.
bool is_tiny(const char* first, const char* last) noexcept {
  constexpr long kFar = 1000000000;
  long exponent = -1;  // of the digit under way
  bool seen_point = false;
  bool seen_digit = false;
  for (; first != last && *first != 'e' && *first != 'E'; ++first) {
    if (*first == '.') {
      seen_point = true;
    } else if (is_digit(*first)) {
      seen_digit |= *first != '0';
      if (seen_digit && !seen_point) ++exponent;
      if (!seen_digit && seen_point) --exponent;
    }
  }
  long written = 0;
  if (first != last) {
    ++first;
    const bool negative = first != last && *first == '-';
    if (first != last && !is_digit(*first)) ++first;
    for (; first != last && is_digit(*first); ++first)
      written = std::min(kFar, 10 * written + (*first - '0'));
    if (negative) written = -written;
  }
  return exponent + written < 0;
}

struct Scanned {
  const char* end;  // nullptr: nothing like a number
  double value;     // NaN and infinite included; infinite for overflow too
  bool overflow;
};

Scanned scan(const char* first, const char* last) noexcept {
  const char* start = first;
  if (start != last && *start == '+') {
    ++start;
    if (start != last && (*start == '-' || *start == '+')) return {nullptr, 0, false};
  }
  double value = 0;
  if (const char* const simple = scan_decimal(start, last, value)) return {simple, value, false};
  const auto [end, fault] = std::from_chars(start, last, value);
  if (fault == std::errc()) return {end, value, false};
  if (fault != std::errc::result_out_of_range) return {nullptr, 0, false};
  const double sign = *start == '-' ? -1.0 : 1.0;
  if (is_tiny(start, end)) return {end, std::copysign(0.0, sign), false};
  return {end, std::copysign(std::numeric_limits<double>::infinity(), sign), true};
}

bool has_decimal_comma(std::string_view token) noexcept {
  const std::size_t comma = token.find(',');
  if (comma == std::string_view::npos || comma == 0 || comma + 1 == token.size()) return false;
  return is_digit(token[comma - 1]) && is_digit(token[comma + 1]) &&
         token.find_first_not_of("+-0123456789.,eE") == std::string_view::npos;
}

}  // namespace

const char* scan_number(const char* first, const char* last, double& value) noexcept {
  if (const char* end = scan_decimal(first, last, value)) return end;
  const Scanned scanned = scan(first, last);
  if (scanned.end == nullptr || !std::isfinite(scanned.value)) return nullptr;
  value = scanned.value;
  return scanned.end;
}

ParsedNumber parse_number(std::string_view token) noexcept {
  if (token.empty()) return {0, NumberFault::empty};
  const char* last = token.data() + token.size();
  const Scanned scanned = scan(token.data(), last);
  if (scanned.end != last) {
    return {0, has_decimal_comma(token) ? NumberFault::decimal_comma : NumberFault::not_a_number};
  }
  if (scanned.overflow) return {scanned.value, NumberFault::overflow};
  if (std::isnan(scanned.value)) return {scanned.value, NumberFault::nan};
  if (std::isinf(scanned.value)) return {scanned.value, NumberFault::infinite};
  return {scanned.value, NumberFault::none};
}

std::string describe(NumberFault fault, std::string_view token) {
  switch (fault) {
    case NumberFault::empty:
      return "has no value: fill it in or remove the row";
    case NumberFault::nan:
      return in_quotes(token) + " is NaN, not a number: correct or remove it";
    case NumberFault::infinite:
      return in_quotes(token) + " is infinite: correct or remove it";
    case NumberFault::overflow:
      return in_quotes(token) + " is too large for a double: correct or remove it";
    case NumberFault::decimal_comma:
      return in_quotes(token) + " has a decimal comma: write it with a decimal point";
    default:
      return in_quotes(token) + " is not a number: correct or remove it";
  }
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  constexpr char kHex[] = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    } else {
      out += {'\\', 'x', kHex[byte >> 4], kHex[byte & 15]};
    }
  }
  return out += text.size() > kLongest ? "...\"" : "\"";
}

namespace {

// Most coordinates are whole numbers of thousandths, and those need no search for the shortest decimal. Let m
// be value * 1000 rounded. If m / 1000, rounded as IEEE does, is `value`, then the decimal m/1000 reads back
// to `value`; and below 10^15 decimals of 15 digits are further apart than doubles, so no other decimal as
// short does. Strip the zeros at its end and it is the shortest. Returns nullptr if `value` is not such a
// number.
char* put_thousandths(char* out, double value) noexcept {
  constexpr double kLimit = 1e12;
  if (!(std::fabs(value) < kLimit)) return nullptr;
  const auto thousandths = static_cast<std::int64_t>(value * 1000 + (value < 0 ? -0.5 : 0.5));
  if (static_cast<double>(thousandths) / 1000 != value) return nullptr;
  if (std::signbit(value)) *out++ = '-';  // -0 too
  const auto magnitude = static_cast<std::uint64_t>(thousandths < 0 ? -thousandths : thousandths);
  out = put_number(out, magnitude / 1000);
  std::uint64_t rest = magnitude % 1000;
  if (rest == 0) return out;
  *out++ = '.';
  for (std::uint64_t unit = 100; rest != 0; unit /= 10) {
    *out++ = static_cast<char>('0' + rest / unit);
    rest %= unit;
  }
  return out;
}

}  // namespace

char* put_number(char* out, double value) noexcept {
  if (char* end = put_thousandths(out, value)) return end;
  const double size = std::fabs(value);
  if (size >= 1e-5 && size < 1e15)
    return std::to_chars(out, out + kNumberSize, value, std::chars_format::fixed).ptr;
  return std::to_chars(out, out + kNumberSize, value).ptr;
}

char* put_number(char* out, std::uint64_t value) noexcept {
  return std::to_chars(out, out + kNumberSize, value).ptr;
}

}  // namespace thalweg::io
