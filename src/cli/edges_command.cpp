/// `thalweg edges`: every pair of points that an order-k triangulation can join.
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/names.hpp"
#include "cli/outputs.hpp"
#include "cli/points_input.hpp"
#include "cli/resources.hpp"
#include "cli/summary.hpp"
#include "io/number.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/useful_order.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kFooter =
    "The useful order of a pair is the least k for which some triangulation of order k joins it. The output "
    "has the\n"
    "header u,v,order and one row a pair: u and v are rows of the input counted from 0 (rows without data "
    "not\n"
    "counted), u < v, sorted. Of rows at one place (x, y), the one that --duplicates keeps stands for all.\n"
    "\n"
    "Examples:\n"
    "  thalweg edges points.xyz -k 2 -o edges.csv\n"
    "  thalweg edges points.xyz -k 8                    only how many there are";

struct EdgesOptions {
  std::string points;
  unsigned order = 0;
  OutputPaths outputs;
  DuplicatePolicy duplicates = DuplicatePolicy::lowest;
  InputOptions input;
  RunOptions run;
};

std::optional<Error> write_pairs(io::OutputFile& file, std::span<const UsefulPair> pairs) {
  file.write("u,v,order\n");
  std::array<char, 3 * io::kNumberSize> line{};
  for (const UsefulPair& pair : pairs) {
    char* end = io::put_number(line.data(), std::uint64_t{pair.u.index()});
    *end++ = ',';
    end = io::put_number(end, std::uint64_t{pair.v.index()});
    *end++ = ',';
    end = io::put_number(end, std::uint64_t{pair.order});
    *end++ = '\n';
    file.write({line.data(), static_cast<std::size_t>(end - line.data())});
    if (file.error()) break;
  }
  return file.error();
}

std::vector<std::uint64_t> count_by_order(std::span<const UsefulPair> pairs, unsigned most) {
  std::vector<std::uint64_t> counts;
  for (const UsefulPair& pair : pairs) {
    if (pair.order >= counts.size()) counts.resize(std::size_t{pair.order} + 1, 0);
    if (pair.order <= most) ++counts[pair.order];
  }
  return counts;
}

/// Merged rows are isolated in it, and every other vertex is the row that the policy keeps.
Result<Minimized> triangulate(const EdgesOptions& options, std::span<const Point3> points, Console& console) {
  MinimizeOptions minimize;
  minimize.order = 0;
  minimize.method = Method::delaunay;
  minimize.duplicates = options.duplicates;
  minimize.threads = options.run.threads;
  minimize.cancel = &interrupted();
  minimize.progress = [&console](const char* stage, double fraction) { console.progress(stage, fraction); };
  return minimize_pits(points, minimize);
}

ExitCode run_edges(const EdgesOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  constexpr std::array kFormats = {io::Format::csv};
  const Result<std::vector<FormattedPath>> targets =
      choose_formats(options.outputs, kFormats, "a list of pairs");
  if (!targets) return console.fail(targets.error());
  std::vector<NamedPath> named;
  for (const FormattedPath& target : *targets) named.push_back({"-o", target.path});
  if (!options.run.json.empty()) named.push_back({"--json", options.run.json});
  if (auto error = check_outputs(named, std::span(&options.points, 1), options.run.overwrite)) {
    return console.fail(*error);
  }
  Stopwatch watch;
  const Result<io::PointTable> table = load_points(options.points, options.input, options.run, console);
  if (!table) return console.fail(table.error());
  const double seconds_read = watch.lap();
  const Result<Minimized> delaunay = triangulate(options, table->points, console);
  if (!delaunay) return console.fail(blame(options.points, delaunay.error()));
  warn_of_duplicates(console, options.points, delaunay->merged.size(), options.duplicates);
  const double seconds_delaunay = watch.lap();

  console.progress("searching pairs", 0);
  std::vector<Point2> sites;
  sites.reserve(table->points.size());
  for (const Point3& p : table->points) sites.push_back({p.x, p.y});
  const DelaunayGraph graph(sites, delaunay->triangulation);
  const std::vector<UsefulPair> pairs = useful_pairs(graph, options.order, options.run.threads);
  const std::vector<std::uint64_t> counts = count_by_order(pairs, options.order);
  const double seconds_edges = watch.lap();
  if (interrupted()) return console.fail({ErrorCode::cancelled, ""});

  const WritingOutputs guard;
  OutputBatch batch(options.run.output());
  for (const FormattedPath& target : *targets) {
    auto error = batch.add(target.path, [&](io::OutputFile& file) { return write_pairs(file, pairs); });
    if (error) return console.fail(*error);
  }
  const double seconds_write = watch.lap();
  if (!options.run.json.empty()) {
    Json summary = new_summary();
    summary["input"] = {{"file", options.points},
                        {"points", table->points.size()},
                        {"vertices", delaunay->sites},
                        {"duplicates", delaunay->merged.size()},
                        {"policy", name_of(options.duplicates)}};
    summary["parameters"] = {{"order", options.order}, {"threads", thread_count(options.run.threads)}};
    summary["edges"] = {{"total", pairs.size()}, {"order_histogram", counts}};
    summary["seconds"] = {{"read", seconds_read},
                          {"delaunay", seconds_delaunay},
                          {"edges", seconds_edges},
                          {"write", seconds_write},
                          {"total", watch.total()}};
    summary["peak_memory_bytes"] = peak_memory_bytes();
    if (auto error = batch.add(options.run.json, write_text(to_text(summary)))) return console.fail(*error);
  }
  if (auto error = batch.commit()) return console.fail(*error);

  std::string by_order;
  for (const std::uint64_t count : counts) by_order += " " + std::to_string(count);
  console.note(options.points + ": " + counted(pairs.size(), "pair", "pairs") + " of useful order at most " +
               std::to_string(options.order) + " over " + counted(delaunay->sites, "site", "sites") +
               "; of order 0, 1, ...:" + by_order);
  console.detail("  time       " + format_fixed(watch.total(), 2) + " s, peak memory " +
                 format_bytes(peak_memory_bytes()));
  return ExitCode::done;
}

}  // namespace

Command add_edges(CLI::App& thalweg) {
  const auto options = std::make_shared<EdgesOptions>();
  CLI::App* app = thalweg.add_subcommand("edges", "Every pair of points of useful order at most K");
  app->add_option("POINTS", options->points, "File of points (xyz, csv, tsv), grid (asc) or mesh; - is stdin")
      ->required();
  add_order(*app, "Largest useful order", [options](unsigned k) { options->order = k; })->required();
  add_output_options(*app, options->outputs, "File .csv to write; - is stdout");
  add_duplicates(*app, options->duplicates);
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kFooter);
  return {app, [options](Console& console) { return run_edges(*options, console); }};
}

}  // namespace thalweg::cli
