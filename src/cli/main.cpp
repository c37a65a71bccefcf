/// The `thalweg` command as a process: its memory, streams and signals.
#include <fcntl.h>
#include <unistd.h>

#include "cli/interrupt.hpp"
#include "cli/memory.hpp"
#include "cli/run.hpp"

namespace thalweg::cli {
namespace {

/// Takes up the numbers of standard streams that the caller has closed: the next file opened would get one,
/// and with it all that is said. Opened the wrong way round, so that to use them is still an error.
void occupy_closed_streams() noexcept {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    if (::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

}  // namespace
}  // namespace thalweg::cli

int main(int argc, char** argv) {
  thalweg::cli::keep_freed_memory();
  thalweg::cli::occupy_closed_streams();
  thalweg::cli::handle_signals();
  return static_cast<int>(thalweg::cli::run(argc, argv));
}
