/// `thalweg sweep`: pits for each order, by every method: the paper's Table 1 of anyone's data.
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/points_input.hpp"
#include "cli/resources.hpp"
#include "cli/summary.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kSweepFooter =
    "For each order: the pits (interior and boundary) that the methods flip, hull and best leave, and the "
    "lower bound\n"
    "that no triangulation of that order goes below. Certified: best is proved to be the minimum.\n"
    "The table goes to stderr; -o writes the rows file,order,flip,hull,best,lower_bound,certified.\n"
    "\n"
    "Examples:\n"
    "  thalweg sweep points.xyz\n"
    "  thalweg sweep north.xyz south.xyz -k 2..8 --json sweep.json -o sweep.csv";

struct SweepOptions {
  std::vector<std::string> points;
  OrderRange orders{0, 10};
  OutputPaths outputs;
  DuplicatePolicy duplicates = DuplicatePolicy::lowest;
  InputOptions input;
  RunOptions run;
};

/// One field of CSV: quoted where it has to be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + "\"";
}

std::string to_csv(const std::vector<std::string>& files, const std::vector<Sweep>& sweeps) {
  std::string text = "file,order,flip,hull,best,lower_bound,certified\n";
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    const std::string file = csv_field(files[i]);
    for (const SweepRow& row : sweeps[i].rows) {
      text += file;
      for (const unsigned value : {row.order, row.flip, row.hull, row.best, row.lower_bound}) {
        text.append(",").append(std::to_string(value));
      }
      text += row.certified ? ",true\n" : ",false\n";
    }
  }
  return text;
}

Json sweeps_to_json(const std::vector<std::string>& files, const std::vector<Sweep>& sweeps) {
  Json array = Json::array();
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    Json rows = Json::array();
    for (const SweepRow& row : sweeps[i].rows) {
      rows.push_back({{"order", row.order},
                      {"flip", row.flip},
                      {"hull", row.hull},
                      {"best", row.best},
                      {"lower_bound", row.lower_bound},
                      {"certified", row.certified}});
    }
    array.push_back({{"file", files[i]}, {"vertices", sweeps[i].sites}, {"rows", std::move(rows)}});
  }
  return array;
}

std::string padded(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

void describe(const std::string& file, const Sweep& sweep, Console& console) {
  console.note(file + ": " + counted(sweep.sites, "site", "sites"));
  console.note("  order    flip    hull    best   bound  certified");
  for (const SweepRow& row : sweep.rows) {
    std::string line = padded(std::to_string(row.order), 7);
    for (const unsigned value : {row.flip, row.hull, row.best, row.lower_bound}) {
      line += padded(std::to_string(value), 8);
    }
    console.note(line + (row.certified ? "        yes" : "         no"));
  }
}

Result<Sweep> sweep_file(const SweepOptions& options, const std::string& path, Console& console) {
  const Result<io::PointTable> table = load_points(path, options.input, options.run, console);
  if (!table) return table.error();
  MinimizeOptions minimize;
  minimize.duplicates = options.duplicates;
  minimize.threads = options.run.threads;
  minimize.cancel = &interrupted();
  minimize.progress = [&console](const char* stage, double fraction) { console.progress(stage, fraction); };
  Result<Sweep> sweep = sweep_pits(table->points, options.orders.first, options.orders.last, minimize);
  if (!sweep) return blame(path, sweep.error());
  warn_of_duplicates(console, path, table->points.size() - sweep->sites, options.duplicates);
  return sweep;
}

std::optional<Error> write_outputs(const SweepOptions& options, std::span<const FormattedPath> targets,
                                   const std::vector<Sweep>& sweeps) {
  const WritingOutputs guard;
  OutputBatch batch(options.run.output());
  for (const FormattedPath& target : targets) {
    if (auto error = batch.add(target.path, write_text(to_csv(options.points, sweeps)))) return error;
  }
  if (!options.run.json.empty()) {
    const std::string text = to_text(sweeps_to_json(options.points, sweeps));
    if (auto error = batch.add(options.run.json, write_text(text))) return error;
  }
  return batch.commit();
}

ExitCode run_sweep(const SweepOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  constexpr std::array kFormats = {io::Format::csv};
  const Result<std::vector<FormattedPath>> targets = choose_formats(options.outputs, kFormats, "a sweep");
  if (!targets) return console.fail(targets.error());
  const std::vector<NamedPath> named = named_outputs(options.outputs, options.run);
  if (auto error = check_outputs(named, options.points, options.run.overwrite)) return console.fail(*error);

  Stopwatch watch;
  std::vector<Sweep> sweeps;
  for (const std::string& path : options.points) {
    Result<Sweep> sweep = sweep_file(options, path, console);
    if (!sweep) return console.fail(sweep.error());
    describe(path, *sweep, console);
    sweeps.push_back(std::move(*sweep));
  }
  if (auto error = write_outputs(options, *targets, sweeps)) return console.fail(*error);
  console.detail("  time       " + format_fixed(watch.total(), 2) + " s, peak memory " +
                 format_bytes(peak_memory_bytes()));
  return ExitCode::done;
}

}  // namespace

Command add_sweep(CLI::App& thalweg) {
  const auto options = std::make_shared<SweepOptions>();
  CLI::App* app = thalweg.add_subcommand("sweep", "Pits left by each method for a range of orders");
  app->add_option("POINTS", options->points,
                  "Files of points (xyz, csv, tsv, tlw, npy), grids (asc) or meshes; - is stdin")
      ->required();
  add_parsed<OrderRange>(
      *app, "-k,--order", "A..B", "Orders to try: A..B, or one number (default: 0..10)",
      "a range of orders: give A..B with whole numbers 0 <= A <= B, or one number",
      [](const std::string& s) { return parse_range(s); }, [options](OrderRange r) { options->orders = r; });
  add_output_options(*app, options->outputs, "File .csv to write; - is stdout");
  add_duplicates(*app, options->duplicates);
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kSweepFooter);
  return {app, [options](Console& console) { return run_sweep(*options, console); }};
}

}  // namespace thalweg::cli
