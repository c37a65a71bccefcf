/// The whole command but for what belongs to a process: streams and signals.
#pragma once

#include "cli/exit_code.hpp"

namespace thalweg::cli {

/// Finds the subcommand that the arguments name, runs it, and turns whatever happens into an exit code; what
/// went wrong is said on stderr. Requires: argv as main gets it.
ExitCode run(int argc, char** argv);

}  // namespace thalweg::cli
