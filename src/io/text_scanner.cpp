#include "io/text_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <system_error>

#include "io/number.hpp"

namespace thalweg::io {
namespace {

bool is_blank(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\r';
}

char lower(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

Error line_error(std::string_view name, std::uint64_t line, std::string_view what) {
  return {ErrorCode::malformed, std::string(name) + ":" + std::to_string(line) + ": " + std::string(what)};
}

std::string_view trimmed(std::string_view text) noexcept {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool same_word(std::string_view a, std::string_view b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char p, char q) { return lower(p) == lower(q); });
}

bool TextScanner::next_line() noexcept {
  while (!fault_ && next_ != last_) {
    cursor_ = next_;
    const void* newline = std::memchr(next_, '\n', static_cast<std::size_t>(last_ - next_));
    line_end_ = newline != nullptr ? static_cast<const char*>(newline) : last_;
    next_ = newline != nullptr ? line_end_ + 1 : last_;
    ++line_;
    while (cursor_ != line_end_ && is_blank(*cursor_)) ++cursor_;
    if (cursor_ != line_end_ && (comment_ == 0 || *cursor_ != comment_)) return true;
  }
  cursor_ = line_end_ = next_;
  return false;
}

std::string_view TextScanner::word() noexcept {
  while (cursor_ != line_end_ && is_blank(*cursor_)) ++cursor_;
  const char* start = cursor_;
  while (cursor_ != line_end_ && !is_blank(*cursor_)) ++cursor_;
  return {start, static_cast<std::size_t>(cursor_ - start)};
}

bool TextScanner::at_line_end() noexcept {
  while (cursor_ != line_end_ && is_blank(*cursor_)) ++cursor_;
  return cursor_ == line_end_;
}

bool TextScanner::try_number(double& value) noexcept {
  if (at_line_end()) return false;
  const char* end = scan_number(cursor_, line_end_, value);
  if (end == nullptr || (end != line_end_ && !is_blank(*end))) return false;
  cursor_ = end;
  return true;
}

bool TextScanner::number(double& value, std::string_view what) {
  if (try_number(value)) return true;
  const std::string_view token = word();
  if (token.empty()) return fail(std::string(what) + " is missing: the line is too short");
  return fail(std::string(what) + " " + describe(parse_number(token).fault, token));
}

bool TextScanner::whole(std::int64_t& value, std::int64_t smallest, std::int64_t largest,
                        std::string_view what) {
  const std::string_view token = word();
  const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  const char* last = token.data() + token.size();
  const auto [end, fault] = std::from_chars(token.data() + (plus ? 1 : 0), last, value);
  if (token.empty()) return fail(std::string(what) + " is missing: the line is too short");
  if (end != last || (fault != std::errc() && fault != std::errc::result_out_of_range)) {
    return fail(std::string(what) + " " + in_quotes(token) + " is not a whole number: correct it");
  }
  if (fault != std::errc() || value < smallest || value > largest) {
    return fail(std::string(what) + " " + in_quotes(token) + " is out of range: it must be between " +
                std::to_string(smallest) + " and " + std::to_string(largest));
  }
  return true;
}

bool TextScanner::fail(std::string_view what) {
  if (!fault_) fault_ = line_error(name_, line_, what);
  return false;
}

}  // namespace thalweg::io
