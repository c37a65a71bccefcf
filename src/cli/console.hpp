/// What the command says to a person, all of it on stderr: errors, warnings, notes and a progress bar.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "cli/exit_code.hpp"
#include "thalweg/result.hpp"

namespace thalweg::cli {

/// When a progress bar is drawn: on a terminal, anyway, not at all.
enum class Bar { automatic, always, never };

/// One a process, used from the main thread alone.
class Console {
 public:
  Console() = default;
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;
  ~Console() { erase_bar(); }

  /// Quiet: errors alone, whatever else is asked.
  void configure(Bar bar, bool quiet, bool verbose) noexcept;

  /// "thalweg: error: ..." and the exit code to end with. Any error after Ctrl-C is said to be that; a pipe
  /// whose reader has gone is not worth a word.
  ExitCode fail(const Error& error);
  /// The same for what has no ErrorCode.
  ExitCode fail(ExitCode code, std::string_view message);

  void warn(std::string_view message);
  void note(std::string_view line);    ///< a line of the report
  void detail(std::string_view line);  ///< with -v only
  bool quiet() const noexcept { return quiet_; }

  /// Draws the bar at `fraction` in [0, 1]; within a stage at most ten times a second, however often it is
  /// called.
  void progress(std::string_view stage, double fraction);
  void erase_bar();

 private:
  void say(std::string_view prefix, std::string_view message);

  bool draws_ = false;
  bool quiet_ = false;
  bool verbose_ = false;
  bool drawn_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point last_draw_ = {};
};

}  // namespace thalweg::cli
