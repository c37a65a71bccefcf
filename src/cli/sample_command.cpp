/// `thalweg sample`: random cells of an elevation grid, without replacement.
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/random.hpp"
#include "cli/resources.hpp"
#include "cli/summary.hpp"
#include "io/grid.hpp"
#include "io/write_mesh.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kSampleFooter =
    "Every set of N cells that have data is equally likely. The points are the centres of the cells, in the "
    "order of\n"
    "the grid: row by row from the top left. The same grid, N and seed give the same bytes on every "
    "machine.\n"
    "\n"
    "Examples:\n"
    "  thalweg sample dem.asc -n 1800 --seed 1 -o points.xyz\n"
    "  thalweg sample dem.asc -n 1800 --seed 1 -o - --to xyz | thalweg build - -o terrain.ply";

struct SampleOptions {
  std::string grid;
  std::uint64_t count = 0;
  std::uint64_t seed = 0;
  OutputPaths outputs;
  InputOptions input;
  RunOptions run;
};

std::uint64_t count_data(const io::Grid& grid) {
  std::uint64_t count = 0;
  for (const double value : grid.values) count += grid.is_nodata(value) ? 0 : 1;
  return count;
}

/// Selection sampling: each cell is taken with the probability that makes all sets equally likely.
/// Requires: wanted <= cells, the number of cells with data. Source: Knuth, The Art of Computer Programming
/// 2, algorithm 3.4.2 S, with whole numbers in place of reals.
std::vector<Point3> draw(const io::Grid& grid, std::uint64_t cells, std::uint64_t wanted,
                         std::uint64_t seed) {
  Random random(seed);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(wanted));
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    for (std::uint32_t column = 0; column < grid.columns && points.size() < wanted; ++column) {
      const double z = grid.value(row, column);
      if (grid.is_nodata(z)) continue;
      if (random.below(cells--) < wanted - points.size()) points.push_back({grid.x[column], grid.y[row], z});
    }
  }
  return points;
}

std::optional<Error> write_outputs(const SampleOptions& options, std::span<const FormattedPath> targets,
                                   const io::Grid& grid, std::uint64_t cells,
                                   std::span<const Point3> points) {
  const WritingOutputs guard;
  OutputBatch batch(options.run.output());
  for (const FormattedPath& target : targets) {
    const auto write = [&](io::OutputFile& file) { return io::write_points(file, points, target.format); };
    if (auto error = batch.add(target.path, write)) return error;
  }
  if (!options.run.json.empty()) {
    Json summary = new_summary();
    summary["input"] = {
        {"file", options.grid}, {"columns", grid.columns}, {"rows", grid.rows}, {"cells_with_data", cells}};
    summary["parameters"] = {{"count", options.count}, {"seed", options.seed}};
    summary["peak_memory_bytes"] = peak_memory_bytes();
    if (auto error = batch.add(options.run.json, write_text(to_text(summary)))) return error;
  }
  return batch.commit();
}

ExitCode run_sample(const SampleOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  constexpr std::array kFormats = {io::Format::xyz, io::Format::csv, io::Format::tsv, io::Format::tlw,
                                   io::Format::npy};
  const Result<std::vector<FormattedPath>> targets = choose_formats(options.outputs, kFormats, "points");
  if (!targets) return console.fail(targets.error());
  const std::vector<NamedPath> named = named_outputs(options.outputs, options.run);
  if (auto error = check_outputs(named, std::span(&options.grid, 1), options.run.overwrite)) {
    return console.fail(*error);
  }
  console.progress("reading", 0);
  const Result<io::Grid> grid = io::read_grid(options.grid, options.input.reader(options.run));
  if (!grid) return console.fail(grid.error());
  if (interrupted()) return console.fail({ErrorCode::cancelled, "interrupted"});
  const std::uint64_t cells = count_data(*grid);
  if (options.count > cells) {
    return console.fail(ExitCode::usage, options.grid + ": -n " + std::to_string(options.count) +
                                             " is more than the " + counted(cells, "cell", "cells") +
                                             " with data: ask for fewer");
  }
  const std::vector<Point3> points = draw(*grid, cells, options.count, options.seed);

  if (auto error = write_outputs(options, *targets, *grid, cells, points)) return console.fail(*error);
  console.note(options.grid + ": " + counted(points.size(), "cell", "cells") + " of " +
               std::to_string(cells) + " with data, seed " + std::to_string(options.seed));
  return ExitCode::done;
}

}  // namespace

Command add_sample(CLI::App& thalweg) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
  const auto options = std::make_shared<SampleOptions>();
  CLI::App* app = thalweg.add_subcommand("sample", "Random cells of an elevation grid, without replacement");
  app->add_option("GRID", options->grid, "ESRI ASCII grid (asc); - is stdin")->required();
  add_parsed<std::uint64_t>(
      *app, "-n,--count", "N", "How many cells to draw", "a number of cells from 1",
      [](const std::string& s) -> std::optional<std::uint64_t> {
        const auto count = parse_whole(s, std::numeric_limits<std::uint32_t>::max() - 1);
        return count == std::uint64_t{0} ? std::nullopt : count;
      },
      [options](std::uint64_t n) { options->count = n; })
      ->required();
  add_parsed<std::uint64_t>(
      *app, "--seed", "S", "Which draw: any whole number from 0", "a seed: give a whole number from 0",
      [](const std::string& s) { return parse_whole(s, kMost); },
      [options](std::uint64_t s) { options->seed = s; })
      ->required();
  add_output_options(*app, options->outputs,
                     "File of points to write (xyz, csv, tsv, tlw, npy); - is stdout");
  app->get_option("--output")->required();
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kSampleFooter);
  return {app, [options](Console& console) { return run_sample(*options, console); }};
}

}  // namespace thalweg::cli
