/// Ctrl-C and its kin.
#include "cli/interrupt.hpp"

#include <signal.h>
#include <unistd.h>

#include "cli/exit_code.hpp"

namespace thalweg::cli {
namespace {

// A signal handler has no other way to tell the program.
std::atomic<bool> interrupted_flag{false};
std::atomic<bool> writing_flag{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a handler may only touch lock-free atomics");

void on_signal(int) noexcept {
  if (interrupted_flag.exchange(true) && !writing_flag.load()) {
    ::_exit(static_cast<int>(ExitCode::interrupted));
  }
}

}  // namespace

void handle_signals() noexcept {
  struct sigaction action {};
  sigemptyset(&action.sa_mask);
  action.sa_handler = on_signal;
  // No SA_RESTART: a read that waits for a terminal or a pipe must return, so that the flag is looked at.
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A reader that has gone and a limit on the size of files are errors of the write, which cleans up.
  action.sa_handler = SIG_IGN;
  sigaction(SIGPIPE, &action, nullptr);
  sigaction(SIGXFSZ, &action, nullptr);
}

const std::atomic<bool>& interrupted() noexcept {
  return interrupted_flag;
}

WritingOutputs::WritingOutputs() noexcept {
  writing_flag.store(true);
}
WritingOutputs::~WritingOutputs() {
  writing_flag.store(false);
}

}  // namespace thalweg::cli
