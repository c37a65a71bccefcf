/// How a text of rows and columns is laid out: what separates its columns, and which of them are x, y and z.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_file.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

struct TableLayout {
  char delimiter = ' ';                           ///< , ; or tab; a space stands for any run of blanks
  std::array<std::size_t, 3> column = {0, 1, 2};  ///< of x, y, z, from 0
  std::string_view body;                          ///< from the first row of data on, as far as it is loaded
  std::uint64_t first_line = 1;                   ///< the line number where `body` begins
};

/// Whether the lines that decide the layout are all in this beginning of a text.
bool has_opening(std::string_view beginning);

/// The layout of a text, of which at least the opening is loaded. A first line without numbers, or with the
/// names of columns, is a header; so is the last comment before the first row, if it names as many columns as
/// the row has. Without a header x, y, z are the first three columns. Errors: malformed, naming the line, if
/// there is no row or a column cannot be found; invalid_argument for `columns`.
Result<TableLayout> find_layout(const InputFile& input, std::string_view columns);

/// The fields of a line, blanks and quotes around each removed.
void split_fields(std::string_view line, char delimiter, std::vector<std::string_view>& fields);

/// Whether a line is skipped: blank, or a comment (# or //).
bool is_comment_or_blank(std::string_view line) noexcept;

}  // namespace thalweg::io
