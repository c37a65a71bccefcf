/// The whole content of an input, and the refusal of content that no reader here can use.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/format.hpp"
#include "io/read_options.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// A file in memory. It is read, not mapped: a mapped file that another program shortens kills the reader.
struct InputFile {
  std::string name;  ///< for messages: the path, or <stdin>
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  std::string_view bytes() const noexcept { return {data.get(), size}; }
  /// The content without a UTF-8 byte order mark.
  std::string_view text() const noexcept;
  /// An error about the file as a whole: "NAME: what".
  Error error(ErrorCode code, std::string_view what) const;
};

/// Reads all of `path`; "-" is stdin. Errors: unreadable, with the reason; malformed if it is empty;
/// cancelled.
Result<InputFile> read_input(const std::string& path, const ReadOptions& options);

/// The format of an input: as asked for, else by suffix; stdin by its first bytes. Errors: unreadable, with
/// advice, for compressed files and for binary formats that are not ours; invalid_argument for unknown
/// suffixes and names.
Result<Format> format_of_input(const InputFile& input, const std::string& path, const ReadOptions& options);

/// Why `input` is no text that lines can be read from (NUL bytes, UTF-16, line ends of old Macs), if it is
/// none.
std::optional<Error> find_text_fault(const InputFile& input);

}  // namespace thalweg::io
