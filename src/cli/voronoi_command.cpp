/// `thalweg voronoi`: the order-k Voronoi diagram, to look at and to ask for nearest points.
#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <optional>
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
#include "io/read_places.hpp"
#include "io/write_voronoi.hpp"
#include "thalweg/order_k_voronoi.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kVoronoiFooter =
    "A cell is where a certain K points are nearer than all others. Outputs .geojson and .svg are the "
    "diagram, "
    "clipped to\n"
    "the box of the points and a tenth more on each side; cells without area there are left out. With "
    "--query, an output\n"
    ".csv has the header query,site,... and one row a query: its number from 0, and the K nearest rows of "
    "the "
    "input counted\n"
    "from 0 (rows without data not counted), nearest first, equal distances by (x, y), decided exactly. Of "
    "rows at one\n"
    "place (x, y), the one that --duplicates keeps stands for all.\n"
    "\n"
    "Examples:\n"
    "  thalweg voronoi points.xyz -k 3 -o cells.svg\n"
    "  thalweg voronoi points.xyz -k 5 --query places.txt -o near.csv";

struct VoronoiOptions {
  std::string points;
  std::string query;
  unsigned order = 0;
  OutputPaths outputs;
  DuplicatePolicy duplicates = DuplicatePolicy::lowest;
  InputOptions input;
  RunOptions run;
};

/// What there is to tell of a run.
struct VoronoiReport {
  std::uint64_t points = 0;
  std::uint64_t sites = 0;
  std::uint64_t cells = 0;
  std::uint64_t vertices = 0;  ///< those at infinity not counted
  std::uint64_t queries = 0;
  std::uint64_t held_bytes = 0;
  double seconds_read = 0;
  double seconds_voronoi = 0;
  double seconds_write = 0;
  double seconds_total = 0;
};

bool same_place(const Point3& a, const Point3& b) {
  return a.x == b.x && a.y == b.y;
}

/// Whether row a, rather than row b at the same place, is to stand for all that are there.
bool stands_before(std::span<const Point3> points, std::uint32_t a, std::uint32_t b, DuplicatePolicy policy) {
  const double za = points[a].z, zb = points[b].z;
  if (policy == DuplicatePolicy::lowest && za != zb) return za < zb;
  if (policy == DuplicatePolicy::highest && za != zb) return za > zb;
  return policy == DuplicatePolicy::last ? a > b : a < b;
}

/// One row for each place, ascending. Errors: duplicate_points if the policy forbids them.
Result<std::vector<std::uint32_t>> distinct_rows(std::span<const Point3> points, DuplicatePolicy policy) {
  std::vector<std::uint32_t> rows(points.size());
  std::iota(rows.begin(), rows.end(), 0u);
  std::sort(rows.begin(), rows.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (points[a].x != points[b].x) return points[a].x < points[b].x;
    if (points[a].y != points[b].y) return points[a].y < points[b].y;
    return stands_before(points, a, b, policy);
  });
  const auto same = [&](std::uint32_t a, std::uint32_t b) { return same_place(points[a], points[b]); };
  if (policy == DuplicatePolicy::error) {
    const auto twice = std::adjacent_find(rows.begin(), rows.end(), same);
    if (twice != rows.end()) {
      return Error{
          ErrorCode::duplicate_points,
          "rows " + std::to_string(twice[0]) + " and " + std::to_string(twice[1]) + " have the same x and y",
          {twice[0], twice[1]}};
    }
  }
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// The box of the sites and a tenth of its longer side more.
Box drawing_box(std::span<const Point2> sites) {
  Box box{sites[0], sites[0]};
  for (const Point2 p : sites) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  const double size = std::max(box.high.x - box.low.x, box.high.y - box.low.y);
  const double margin = size > 0 ? size / 10 : 1;
  return {{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}

std::uint64_t finite_vertices(const OrderKVoronoi& diagram) {
  std::uint64_t count = 0;
  for (std::uint32_t v = 0; v < diagram.vertex_count(); ++v) {
    count += diagram.at_infinity(VoronoiVertexId(v)) ? 0 : 1;
  }
  return count;
}

Json summarize(const VoronoiOptions& options, const VoronoiReport& report) {
  Json summary = new_summary();
  summary["input"] = {{"file", options.points},
                      {"points", report.points},
                      {"vertices", report.sites},
                      {"duplicates", report.points - report.sites},
                      {"policy", name_of(options.duplicates)}};
  summary["parameters"] = {{"order", options.order}, {"threads", thread_count(options.run.threads)}};
  summary["voronoi"] = {{"cells", report.cells},
                        {"vertices", report.vertices},
                        {"queries", report.queries},
                        {"memory_bytes", report.held_bytes}};
  summary["seconds"] = {{"read", report.seconds_read},
                        {"voronoi", report.seconds_voronoi},
                        {"write", report.seconds_write},
                        {"total", report.seconds_total}};
  summary["peak_memory_bytes"] = peak_memory_bytes();
  return summary;
}

void describe(const VoronoiOptions& options, const VoronoiReport& report, Console& console) {
  console.note(options.points + ": " + counted(report.cells, "cell", "cells") + " of order " +
               std::to_string(options.order) + " over " + counted(report.sites, "site", "sites") +
               (options.query.empty() ? "" : "; " + counted(report.queries, "query", "queries")));
  console.detail("  time       " + format_fixed(report.seconds_total, 2) + " s, peak memory " +
                 format_bytes(peak_memory_bytes()));
}

/// A run past its inputs.
struct VoronoiWork {
  std::vector<std::uint32_t> rows;  ///< of each site
  std::vector<Point2> sites;
  std::vector<Point2> queries;
};

std::optional<Error> write_outputs(const VoronoiOptions& options, std::span<const FormattedPath> targets,
                                   const VoronoiWork& work, const OrderKVoronoi& diagram,
                                   VoronoiReport& report, Stopwatch& watch) {
  const WritingOutputs guard;
  OutputBatch batch(options.run.output());
  for (const FormattedPath& target : targets) {
    const auto write = [&](io::OutputFile& file) -> std::optional<Error> {
      if (target.format == io::Format::csv) {
        return io::write_nearest(file, diagram, work.rows, work.queries);
      }
      const auto drawn =
          io::write_voronoi(file, {&diagram, work.rows, drawing_box(work.sites)}, target.format);
      return drawn ? std::nullopt : std::optional(drawn.error());
    };
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

/// Answers to queries are csv alone on stdout; csv without queries is refused.
Result<std::vector<FormattedPath>> choose_targets(const VoronoiOptions& options) {
  using io::Format;
  constexpr std::array kDrawings = {Format::geojson, Format::svg};
  constexpr std::array kAll = {Format::csv, Format::geojson, Format::svg};
  constexpr std::array kAnswers = {Format::csv};
  if (options.query.empty())
    return choose_formats(options.outputs, kDrawings, "a Voronoi diagram without --query");
  const bool answers_alone =
      options.outputs.paths.size() == 1 && options.outputs.formats.empty() && options.outputs.paths[0] == "-";
  return answers_alone ? choose_formats(options.outputs, kAnswers, "answers")
                       : choose_formats(options.outputs, kAll, "a Voronoi diagram");
}

Result<VoronoiWork> load(const VoronoiOptions& options, VoronoiReport& report, Console& console) {
  const Result<io::PointTable> table = load_points(options.points, options.input, options.run, console);
  if (!table) return table.error();
  report.points = table->points.size();
  Result<std::vector<std::uint32_t>> rows = distinct_rows(table->points, options.duplicates);
  if (!rows) return blame(options.points, rows.error());
  VoronoiWork work{std::move(*rows), {}, {}};
  for (const std::uint32_t row : work.rows)
    work.sites.push_back({table->points[row].x, table->points[row].y});
  report.sites = work.sites.size();
  warn_of_duplicates(console, options.points, report.points - report.sites, options.duplicates);
  if (!options.query.empty()) {
    io::ReadOptions reading;
    reading.cancel = &interrupted();
    Result<std::vector<Point2>> queries = io::read_places(options.query, reading);
    if (!queries) return queries.error();
    work.queries = std::move(*queries);
  }
  report.queries = work.queries.size();
  return work;
}

ExitCode run_voronoi(const VoronoiOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  const Result<std::vector<FormattedPath>> targets = choose_targets(options);
  if (!targets) return console.fail(targets.error());
  if (options.points == "-" && options.query == "-") {
    return console.fail(ExitCode::usage, "POINTS and --query cannot both be stdin");
  }
  const std::vector<std::string> inputs = {options.points, options.query};
  const std::vector<NamedPath> named = named_outputs(options.outputs, options.run);
  if (auto error = check_outputs(named, std::span(inputs).first(options.query.empty() ? 1 : 2),
                                 options.run.overwrite)) {
    return console.fail(*error);
  }
  Stopwatch watch;
  VoronoiReport report;
  const Result<VoronoiWork> work = load(options, report, console);
  if (!work) return console.fail(work.error());
  report.seconds_read = watch.lap();

  console.progress("building cells", 0);
  const Result<OrderKVoronoi> diagram =
      order_k_voronoi(work->sites, options.order, {.threads = options.run.threads});
  if (interrupted()) return console.fail({ErrorCode::cancelled, "interrupted"});
  if (!diagram) return console.fail(blame(options.points, diagram.error()));
  report.cells = diagram->cell_count();
  report.vertices = finite_vertices(*diagram);
  report.held_bytes = diagram->memory_bytes();
  report.seconds_voronoi = watch.lap();
  if (auto error = write_outputs(options, *targets, *work, *diagram, report, watch))
    return console.fail(*error);
  describe(options, report, console);
  return ExitCode::done;
}

}  // namespace

Command add_voronoi(CLI::App& thalweg) {
  const auto options = std::make_shared<VoronoiOptions>();
  CLI::App* app = thalweg.add_subcommand("voronoi", "Where which K points are the nearest; nearest points");
  app->add_option("POINTS", options->points,
                  "File of points (xyz, csv, tsv, tlw, npy), grid (asc) or mesh; - is stdin")
      ->required();
  add_order(*app, "Order of the diagram, from 1", [options](unsigned k) { options->order = k; })->required();
  app->add_option("--query", options->query, "Places `x y`, one a line, whose K nearest points are wanted")
      ->option_text("FILE");
  add_output_options(*app, options->outputs,
                     "File .geojson, .svg, or with --query .csv to write; - is stdout");
  add_duplicates(*app, options->duplicates);
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kVoronoiFooter);
  return {app, [options](Console& console) { return run_voronoi(*options, console); }};
}

}  // namespace thalweg::cli
