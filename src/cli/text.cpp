/// Numbers as people type and read them.
#include "cli/text.hpp"

#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <system_error>

namespace thalweg::cli {

std::optional<std::uint64_t> parse_whole(std::string_view text, std::uint64_t most) noexcept {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value);
  if (text.empty() || fault != std::errc{} || stop != end || value > most) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> parse_bytes(std::string_view text) noexcept {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (text.empty() || fault != std::errc{} || !std::isfinite(value) || value < 0) return std::nullopt;
  std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  while (!unit.empty() && unit.front() == ' ') unit.remove_prefix(1);
  if (!unit.empty()) {
    const char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(unit.front())));
    const std::size_t power = std::string_view("BKMGT").find(letter);
    if (power == std::string_view::npos) return std::nullopt;
    unit.remove_prefix(1);
    if (power > 0 && !unit.empty() && (unit.front() == 'i' || unit.front() == 'I')) unit.remove_prefix(1);
    if (power > 0 && !unit.empty() && (unit.front() == 'b' || unit.front() == 'B')) unit.remove_prefix(1);
    if (!unit.empty()) return std::nullopt;
    value = std::ldexp(value, static_cast<int>(10 * power));
  }
  if (value >= 0x1p64) return std::nullopt;
  return static_cast<std::uint64_t>(value);
}

std::optional<double> parse_seconds(std::string_view text) noexcept {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, value, std::chars_format::fixed);
  if (text.empty() || fault != std::errc{} || stop != end || !std::isfinite(value) || value < 0) {
    return std::nullopt;
  }
  return value;
}

std::optional<OrderRange> parse_range(std::string_view text) noexcept {
  constexpr std::uint64_t kMost = std::numeric_limits<unsigned>::max() - 1;
  const std::size_t dots = text.find("..");
  const auto first = parse_whole(text.substr(0, dots), kMost);
  const auto last = dots == std::string_view::npos ? first : parse_whole(text.substr(dots + 2), kMost);
  if (!first || !last || *first > *last) return std::nullopt;
  return OrderRange{static_cast<unsigned>(*first), static_cast<unsigned>(*last)};
}

std::string format_bytes(std::uint64_t bytes) {
  if (bytes < 1024) return counted(bytes, "byte", "bytes");
  constexpr std::array<const char*, 4> kUnits = {" KB", " MB", " GB", " TB"};
  double value = static_cast<double>(bytes) / 1024;
  std::size_t unit = 0;
  for (; value >= 1024 && unit + 1 < kUnits.size(); ++unit) value /= 1024;
  return format_fixed(value, value < 10 ? 1 : 0) + kUnits[unit];
}

std::string format_fixed(double value, int digits) {
  std::array<char, 400> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.*f", digits, value);
  return std::string(buffer.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  std::string text = std::to_string(count);
  text += ' ';
  text += count == 1 ? one : many;
  return text;
}

}  // namespace thalweg::cli
