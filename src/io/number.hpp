/// Numbers from and to decimal text, exactly: what is written reads back to the same double, whatever the
/// locale.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace thalweg::io {

enum class NumberFault { none, empty, not_a_number, nan, infinite, overflow, decimal_comma };

struct ParsedNumber {
  double value = 0;
  NumberFault fault = NumberFault::none;
};

/// The double nearest to the decimal number that `token` is, all of it; a leading + is legal, a number too
/// small for a double is zero. Every token that is no finite double is a fault, with `value` NaN or infinite
/// where it says so.
ParsedNumber parse_number(std::string_view token) noexcept;

/// Parses the number at `first` and returns where it ends, or nullptr if no finite number is there. The
/// character after it is the caller's to check. Agrees with parse_number.
const char* scan_number(const char* first, const char* last, double& value) noexcept;

/// What is wrong, in words: the token is quoted, cut to a sane length, and freed of control characters.
/// Requires: fault != none.
std::string describe(NumberFault fault, std::string_view token);

/// `text` in double quotes, at most 40 bytes of it, with bytes outside printable ASCII as \xNN.
std::string in_quotes(std::string_view text);

/// Enough room for any number that put_number writes.
inline constexpr std::size_t kNumberSize = 32;

/// Writes the shortest decimal that reads back to the same double, without exponent where that is readable
/// (1e-5 <= |value| < 1e15), and returns its end. Requires: value finite; kNumberSize bytes at `out`.
char* put_number(char* out, double value) noexcept;

/// Writes a whole number and returns its end. Requires: kNumberSize bytes at `out`.
char* put_number(char* out, std::uint64_t value) noexcept;

}  // namespace thalweg::io
