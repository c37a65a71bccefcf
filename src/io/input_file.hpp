/// The content of an input, and the refusal of content that no reader here can use.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/format.hpp"
#include "io/read_options.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// An input on its way into memory: its beginning is loaded, as much of it as a reader asks for, the rest is
/// read in blocks that the reader owns. It is read, not mapped: a mapped file that another program shortens
/// kills the reader.
class InputFile {
 public:
  /// Opens `path`, "-" is stdin, and loads its beginning: the first kFirstLoad bytes, or all. Errors:
  /// unreadable, with the reason; malformed if it is empty; cancelled.
  static Result<InputFile> open(const std::string& path, const ReadOptions& options);

  InputFile(InputFile&& other) noexcept;
  InputFile& operator=(InputFile&& other) noexcept;
  ~InputFile();

  const std::string& name() const noexcept { return name_; }  ///< for messages: the path, or <stdin>

  /// What is loaded.
  std::string_view bytes() const noexcept { return {data_.get(), loaded_}; }
  /// What is loaded, without a UTF-8 byte order mark.
  std::string_view text() const noexcept;
  /// Whether all is loaded, or was read.
  bool at_end() const noexcept { return at_end_; }
  /// The size of all of it, as far as can be known now: pipes do not tell before their end.
  std::optional<std::uint64_t> size() const noexcept;

  /// Loads at least as much again. Invalidates what bytes() and text() gave.
  std::optional<Error> load_more();
  /// Loads all. Invalidates what bytes() and text() gave.
  std::optional<Error> load_all();

  /// Lets `read` begin after the first `count` bytes. Requires: that many loaded.
  void seek(std::size_t count) noexcept { position_ = count; }
  /// Reads the next `count` bytes, fewer only at the end, and returns how many. Errors: unreadable,
  /// cancelled.
  Result<std::size_t> read(char* out, std::size_t count);
  /// Bytes that `read` has still to give, if known.
  std::optional<std::uint64_t> unread() const noexcept;

  /// An error about the file as a whole: "NAME: what".
  Error error(ErrorCode code, std::string_view what) const;

  static constexpr std::size_t kFirstLoad = std::size_t{1} << 18;

 private:
  InputFile() = default;

  std::optional<Error> load(std::size_t capacity);
  Result<std::size_t> read_descriptor(char* out, std::size_t count);

  std::string name_;
  int descriptor_ = -1;
  bool owned_ = false;
  bool at_end_ = false;
  const std::atomic<bool>* cancel_ = nullptr;
  std::optional<std::uint64_t> expected_;  // by the size of a regular file
  std::unique_ptr<char[]> data_;
  std::size_t loaded_ = 0;
  std::size_t position_ = 0;  // of the next byte for `read`, within the loaded ones
  std::uint64_t taken_ = 0;   // from the descriptor
};

/// Opens `path` and loads all of it. Errors: as open.
Result<InputFile> read_input(const std::string& path, const ReadOptions& options);

/// The format of an input: as asked for, else by suffix; stdin by its first bytes. Errors: unreadable, with
/// advice, for compressed files and for binary formats that are not ours; invalid_argument for unknown
/// suffixes and names.
Result<Format> format_of_input(const InputFile& input, const std::string& path, const ReadOptions& options);

/// Why what is loaded of `input` is no text that lines can be read from (NUL bytes, UTF-16, line ends of old
/// Macs), if it is none. Requires: a line end, or all, loaded.
std::optional<Error> find_text_fault(const InputFile& input);

/// The same of NUL bytes alone, in a further part of the text that begins on line `first_line`.
std::optional<Error> find_nul(const InputFile& input, std::string_view part, std::uint64_t first_line);

}  // namespace thalweg::io
