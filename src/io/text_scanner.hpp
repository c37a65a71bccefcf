/// Lines and blank-separated words of a text, with line numbers for messages: the base of the readers of
/// grids and meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "thalweg/result.hpp"

namespace thalweg::io {

/// The error "NAME:LINE: what".
Error line_error(std::string_view name, std::uint64_t line, std::string_view what);

/// `text` without blanks (space, tab, carriage return) at either end.
std::string_view trimmed(std::string_view text) noexcept;

/// Whether the two are the same but for the case of ASCII letters.
bool same_word(std::string_view a, std::string_view b) noexcept;

/// A cursor over a text that the caller keeps alive. After the first fault it stays where it is: `next_line`
/// is false.
class TextScanner {
 public:
  /// `comment`: lines whose first word starts with it are skipped; 0 for none.
  TextScanner(std::string_view text, std::string_view name, char comment = '#',
              std::uint64_t first_line = 1) noexcept
      : next_(text.data()),
        last_(text.data() + text.size()),
        name_(name),
        comment_(comment),
        line_(first_line - 1) {}

  /// Moves to the next line that is not blank and not a comment. False at the end of the text and after a
  /// fault.
  bool next_line() noexcept;

  /// The next word of the line; empty at its end.
  std::string_view word() noexcept;

  /// Whether the line has no more words.
  bool at_line_end() noexcept;

  /// What is left of the line, trimmed.
  std::string_view rest() const noexcept {
    return trimmed({cursor_, static_cast<std::size_t>(line_end_ - cursor_)});
  }

  /// The next word as a finite number. False, with a fault that calls it `what`, if it is none.
  bool number(double& value, std::string_view what);

  /// As `number`, but a false answer leaves the cursor before the word and sets no fault.
  bool try_number(double& value) noexcept;

  /// The next word as a whole number in [smallest, largest]. False, with a fault, if it is none.
  bool whole(std::int64_t& value, std::int64_t smallest, std::int64_t largest, std::string_view what);

  /// Sets the fault "NAME:LINE: what" unless there is one already. Always false.
  bool fail(std::string_view what);

  std::uint64_t line_number() const noexcept { return line_; }
  /// The text after the current line.
  std::string_view remaining() const noexcept { return {next_, static_cast<std::size_t>(last_ - next_)}; }
  const std::optional<Error>& fault() const noexcept { return fault_; }

 private:
  const char* next_;  // start of the line after this one
  const char* last_;
  const char* cursor_ = nullptr;
  const char* line_end_ = nullptr;
  std::string_view name_;
  char comment_;
  std::uint64_t line_;
  std::optional<Error> fault_;
};

}  // namespace thalweg::io
