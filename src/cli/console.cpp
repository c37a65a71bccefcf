/// What the command says to a person.
#include "cli/console.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "cli/interrupt.hpp"

namespace thalweg::cli {
namespace {

/// Whether stdout is a pipe that nobody reads any more.
bool stdout_has_no_reader() noexcept {
  pollfd out{STDOUT_FILENO, 0, 0};
  return ::poll(&out, 1, 0) > 0 && (out.revents & POLLERR) != 0;
}

}  // namespace

void Console::configure(Bar bar, bool quiet, bool verbose) noexcept {
  quiet_ = quiet;
  verbose_ = verbose && !quiet;
  draws_ = !quiet && (bar == Bar::always || (bar == Bar::automatic && ::isatty(STDERR_FILENO) == 1));
}

ExitCode Console::fail(const Error& error) {
  // Whatever went wrong after Ctrl-C, a read cut short say, went wrong because of it.
  if (error.code == ErrorCode::cancelled || interrupted())
    return fail(ExitCode::interrupted, "interrupted: no unfinished output is left");
  const ExitCode code = exit_code_of(error.code);
  if (code == ExitCode::output && stdout_has_no_reader()) {
    erase_bar();
    return code;
  }
  return fail(code, error.message);
}

ExitCode Console::fail(ExitCode code, std::string_view message) {
  say("thalweg: error: ", message);
  return code;
}

void Console::warn(std::string_view message) {
  if (!quiet_) say("thalweg: warning: ", message);
}

void Console::note(std::string_view line) {
  if (!quiet_) say("", line);
}

void Console::detail(std::string_view line) {
  if (verbose_) say("", line);
}

void Console::say(std::string_view prefix, std::string_view message) {
  erase_bar();
  std::string line(prefix);
  line += message;
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void Console::progress(std::string_view stage, double fraction) {
  if (!draws_) return;
  const auto now = std::chrono::steady_clock::now();
  // A stage may be announced once and then last for minutes, so a new one is never passed over.
  if (drawn_ && stage == stage_ && now - last_draw_ < std::chrono::milliseconds(100)) return;
  last_draw_ = now;
  stage_ = stage;
  drawn_ = true;
  constexpr int kWidth = 30;
  const double share = std::clamp(fraction, 0.0, 1.0);
  const auto filled = static_cast<std::size_t>(share * kWidth);
  std::string line = "\r\033[K";
  line += stage;
  line += " [";
  line.append(filled, '#').append(kWidth - filled, ' ');
  std::array<char, 16> percent{};
  std::snprintf(percent.data(), percent.size(), "] %3d%%", static_cast<int>(share * 100));
  line += percent.data();
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void Console::erase_bar() {
  if (!drawn_) return;
  drawn_ = false;
  std::fputs("\r\033[K", stderr);
}

}  // namespace thalweg::cli
