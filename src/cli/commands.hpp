/// The subcommands: each declares its options and says how it is run.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "cli/console.hpp"

namespace thalweg::cli {

/// A subcommand that can be run once the command line is parsed.
struct Command {
  CLI::App* app = nullptr;
  std::function<ExitCode(Console&)> run;
};

Command add_build(CLI::App& thalweg);
Command add_check(CLI::App& thalweg);
Command add_edges(CLI::App& thalweg);
Command add_report(CLI::App& thalweg);
Command add_sweep(CLI::App& thalweg);
Command add_sample(CLI::App& thalweg);
Command add_generate(CLI::App& thalweg);
Command add_info(CLI::App& thalweg);
Command add_voronoi(CLI::App& thalweg);

}  // namespace thalweg::cli
