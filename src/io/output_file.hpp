/// An output that appears whole or not at all: written to a temporary file beside the target, then renamed
/// over it.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "thalweg/result.hpp"

namespace thalweg::io {

struct OutputOptions {
  /// Whether a file that is there already may be replaced.
  bool overwrite = false;
  /// Looked at between chunks of output; once set, writing stops with ErrorCode::cancelled.
  const std::atomic<bool>* cancel = nullptr;
  /// Rows of text are printed by this many threads, 0 for all of the machine; the bytes do not depend on it.
  unsigned threads = 1;
};

/// What would keep `path` from being written: nothing, or an Error `exists` or `unwritable`. Touches nothing,
/// so that a command can refuse before it computes; `open` and `commit` check again.
std::optional<Error> check_output(const std::string& path, bool overwrite);

/// Buffered writer with a sticky error: after the first failure every write does nothing and `commit` reports
/// it.
/// "-" and /dev/stdout are stdout; devices, pipes and sockets are written in place.
/// Requires: SIGPIPE ignored by the program, if a closed pipe is to be an Error and not the end of the
/// process.
class OutputFile {
 public:
  /// Errors: exists, unwritable.
  static Result<OutputFile> open(const std::string& path, const OutputOptions& options = {});

  OutputFile(OutputFile&& other) noexcept;
  OutputFile& operator=(OutputFile&& other) noexcept;
  /// Without a commit the temporary file is removed and the target is what it was.
  ~OutputFile();

  void write(std::string_view bytes);

  /// Hands everything written so far to the system, so that a full disk shows in `error`.
  void flush();

  /// The first failure, if any. Complexity: O(1); loops may look at it to stop early.
  const std::optional<Error>& error() const noexcept { return error_; }

  /// Flushes, closes and gives the file its name. Nothing, or the first failure; then the target is
  /// untouched.
  [[nodiscard]] std::optional<Error> commit();

  /// How many threads a writer may use to print: at least 1.
  unsigned threads() const noexcept { return threads_; }

  /// Bytes accepted so far.
  std::uint64_t size() const noexcept { return size_; }

 private:
  OutputFile() = default;

  void put(const char* bytes, std::size_t count);
  void fail(ErrorCode code, int error_number);
  void discard() noexcept;

  std::string path_;       // as the user wrote it, for messages
  std::string target_;     // where the file goes, symbolic links resolved; empty if written in place
  std::string temporary_;  // empty once it is gone, and if written in place
  int descriptor_ = -1;
  bool overwrite_ = false;
  const std::atomic<bool>* cancel_ = nullptr;
  unsigned threads_ = 1;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;
  std::uint64_t size_ = 0;
  std::optional<Error> error_;
};

}  // namespace thalweg::io
