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

constexpr const char* kEdgesFooter =
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

/// How many pairs have each useful order, from 0 to the largest.
std::vector<std::uint64_t> order_histogram(std::span<const UsefulPair> pairs) {
  std::vector<std::uint32_t> orders;
  orders.reserve(pairs.size());
  for (const UsefulPair& pair : pairs) orders.push_back(pair.order);
  return cli::order_histogram(orders);
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

/// What there is to tell of a run.
struct EdgesReport {
  std::uint64_t points = 0;
  std::uint64_t sites = 0;
  std::uint64_t merged = 0;
  std::uint64_t pairs = 0;
  std::vector<std::uint64_t> histogram;
  double seconds_read = 0;
  double seconds_delaunay = 0;
  double seconds_edges = 0;
  double seconds_write = 0;
  double seconds_total = 0;
};

std::vector<UsefulPair> find_pairs(const EdgesOptions& options, std::span<const Point3> points,
                                   const Triangulation& delaunay) {
  std::vector<Point2> sites;
  sites.reserve(points.size());
  for (const Point3& p : points) sites.push_back({p.x, p.y});
  const DelaunayGraph graph(sites, delaunay);
  return useful_pairs(graph, options.order, options.run.threads);
}

Json summarize(const EdgesOptions& options, const EdgesReport& report) {
  Json summary = new_summary();
  summary["input"] = {{"file", options.points},
                      {"points", report.points},
                      {"vertices", report.sites},
                      {"duplicates", report.merged},
                      {"policy", name_of(options.duplicates)}};
  summary["parameters"] = {{"order", options.order}, {"threads", thread_count(options.run.threads)}};
  summary["edges"] = {{"total", report.pairs}, {"order_histogram", report.histogram}};
  summary["seconds"] = {{"read", report.seconds_read},
                        {"delaunay", report.seconds_delaunay},
                        {"edges", report.seconds_edges},
                        {"write", report.seconds_write},
                        {"total", report.seconds_total}};
  summary["peak_memory_bytes"] = peak_memory_bytes();
  return summary;
}

void describe(const EdgesOptions& options, const EdgesReport& report, Console& console) {
  std::string by_order;
  for (const std::uint64_t count : report.histogram) by_order.append(" ").append(std::to_string(count));
  console.note(options.points + ": " + counted(report.pairs, "pair", "pairs") + " of useful order at most " +
               std::to_string(options.order) + " over " + counted(report.sites, "site", "sites") +
               "; of order 0, 1, ...:" + by_order);
  console.detail("  time       " + format_fixed(report.seconds_total, 2) + " s, peak memory " +
                 format_bytes(peak_memory_bytes()));
}

std::optional<Error> write_outputs(const EdgesOptions& options, std::span<const FormattedPath> targets,
                                   std::span<const UsefulPair> pairs, EdgesReport& report, Stopwatch& watch) {
  const WritingOutputs guard;
  OutputBatch batch(options.run.output());
  for (const FormattedPath& target : targets) {
    const auto write = [&](io::OutputFile& file) { return write_pairs(file, pairs); };
    if (auto error = batch.add(target.path, write)) return error;
  }
  report.seconds_write = watch.lap();
  report.seconds_total = watch.total();
  if (!options.run.json.empty()) {
    if (auto error = batch.add(options.run.json, write_text(to_text(summarize(options, report)))))
      return error;
  }
  return batch.commit();
}

ExitCode run_edges(const EdgesOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  constexpr std::array kFormats = {io::Format::csv};
  const Result<std::vector<FormattedPath>> targets =
      choose_formats(options.outputs, kFormats, "a list of pairs");
  if (!targets) return console.fail(targets.error());
  const std::vector<NamedPath> named = named_outputs(options.outputs, options.run);
  if (auto error = check_outputs(named, std::span(&options.points, 1), options.run.overwrite)) {
    return console.fail(*error);
  }
  Stopwatch watch;
  EdgesReport report;
  const Result<io::PointTable> table = load_points(options.points, options.input, options.run, console);
  if (!table) return console.fail(table.error());
  report.points = table->points.size();
  report.seconds_read = watch.lap();

  const Result<Minimized> delaunay = triangulate(options, table->points, console);
  if (!delaunay) return console.fail(blame(options.points, delaunay.error()));
  warn_of_duplicates(console, options.points, delaunay->merged.size(), options.duplicates);
  report.sites = delaunay->sites;
  report.merged = delaunay->merged.size();
  report.seconds_delaunay = watch.lap();

  console.progress("searching pairs", 0);
  const std::vector<UsefulPair> pairs = find_pairs(options, table->points, delaunay->triangulation);
  if (interrupted()) return console.fail({ErrorCode::cancelled, "interrupted"});
  report.pairs = pairs.size();
  report.histogram = order_histogram(pairs);
  report.seconds_edges = watch.lap();
  if (auto error = write_outputs(options, *targets, pairs, report, watch)) return console.fail(*error);
  describe(options, report, console);
  return ExitCode::done;
}

}  // namespace

Command add_edges(CLI::App& thalweg) {
  const auto options = std::make_shared<EdgesOptions>();
  CLI::App* app = thalweg.add_subcommand("edges", "Every pair of points of useful order at most K");
  app->add_option("POINTS", options->points,
                  "File of points (xyz, csv, tsv, tlw, npy), grid (asc) or mesh; - is stdin")
      ->required();
  add_order(*app, "Largest useful order", [options](unsigned k) { options->order = k; })->required();
  add_output_options(*app, options->outputs, "File .csv to write; - is stdout");
  add_duplicates(*app, options->duplicates);
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kEdgesFooter);
  return {app, [options](Console& console) { return run_edges(*options, console); }};
}

}  // namespace thalweg::cli
