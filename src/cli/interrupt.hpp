/// Ctrl-C and its kin: they set a flag that everything long polls, so that no output is ever left half.
#pragma once

#include <atomic>

namespace thalweg::cli {

/// SIGINT and SIGTERM set the flag; a second one ends the process at once, unless outputs are being written,
/// which is quick to stop. SIGPIPE and SIGXFSZ are ignored: a closed pipe, a file that may not grow are
/// errors.
void handle_signals() noexcept;

/// The flag, for the `cancel` of the library and of files.
const std::atomic<bool>& interrupted() noexcept;

/// While one lives, a second signal waits for the first to be obeyed: temporary files are about.
class WritingOutputs {
 public:
  WritingOutputs() noexcept;
  ~WritingOutputs();
  WritingOutputs(const WritingOutputs&) = delete;
  WritingOutputs& operator=(const WritingOutputs&) = delete;
};

}  // namespace thalweg::cli
