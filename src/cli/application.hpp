/// The whole command line of `thalweg`, declared in one place: what is parsed, --help and the manual page are
/// made of it.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

#include "cli/commands.hpp"

namespace thalweg::cli {

/// Declares everything on an empty app and returns the subcommands in the order in which they are shown.
/// Requires: `root` outlives them.
std::vector<Command> declare(CLI::App& root);

}  // namespace thalweg::cli
