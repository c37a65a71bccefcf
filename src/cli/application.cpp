/// The root of the command line.
#include "cli/application.hpp"

#include "thalweg/version.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  thalweg build points.xyz -o terrain.ply          the main job\n"
    "  thalweg check terrain.ply -k 8                   is it a triangulation of order 8?\n"
    "  thalweg sweep points.xyz -k 0..10                what would each order gain?\n"
    "\n"
    "Exit codes: 0 done; 1 internal error; 2 usage; 3 bad input; 4 verification failed or pits left;\n"
    "5 out of memory; 6 output exists or cannot be written; 130 interrupted.\n"
    "`thalweg COMMAND --help` tells the options of a command.";

}  // namespace

std::vector<Command> declare(CLI::App& root) {
  root.name("thalweg");
  root.description("Terrains without false pits: elevation points in, a triangulation of order k out.");
  root.footer(kFooter);
  root.require_subcommand(1);
  root.set_version_flag("--version", version());
  std::vector<Command> commands = {add_build(root), add_check(root),   add_edges(root),
                                   add_sweep(root), add_sample(root),  add_generate(root),
                                   add_info(root),  add_voronoi(root), add_report(root)};
  for (const Command& command : commands) command.app->set_version_flag("--version", version());
  return commands;
}

}  // namespace thalweg::cli
