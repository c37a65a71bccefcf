/// `thalweg build`: points in, a terrain without false pits out.
#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common_options.hpp"
#include "cli/compact_mesh.hpp"
#include "cli/interrupt.hpp"
#include "cli/names.hpp"
#include "cli/outputs.hpp"
#include "cli/points_input.hpp"
#include "cli/report_model.hpp"
#include "cli/report_outputs.hpp"
#include "cli/resources.hpp"
#include "cli/summary.hpp"
#include "io/write_mesh.hpp"
#include "io/write_pits.hpp"

namespace thalweg::cli {
namespace {

constexpr std::array kMeshFormats = {io::Format::ply,    io::Format::ply_ascii, io::Format::obj,
                                     io::Format::two_dm, io::Format::tlw,       io::Format::npy,
                                     io::Format::csv,    io::Format::tsv,       io::Format::xyz,
                                     io::Format::svg,    io::Format::html};
constexpr std::array kPitFormats = {io::Format::geojson, io::Format::csv, io::Format::tsv};

constexpr const char* kBuildFooter =
    "x and y are metres or any other unit of length, the same on both axes (not degrees); elevations are "
    "only\n"
    "compared, so their unit is free. No coordinate is ever changed. Vertices of every output are in the "
    "order of\n"
    "the input rows, rows merged into others left out; `vertex` in --json and --pits counts them from 0.\n"
    "The suffix of an output chooses its format: .ply, .obj, .2dm, .tlw (meshes), .csv, .tsv, .xyz "
    "(vertices\n"
    "alone), .npy (triangles alone: an array (m, 3) of the numbers of their corners, from 0); .html and .svg "
    "as --report.\n"
    "\n"
    "Examples:\n"
    "  thalweg build points.xyz -o terrain.ply\n"
    "  thalweg build dem.asc -k 6 -o terrain.2dm -o terrain.obj --pits pits.geojson --json report.json\n"
    "  thalweg build points.xyz -o terrain.ply --report report.html --sweep\n"
    "  thalweg build points.csv --columns easting,northing,height -o - --to ply > terrain.ply\n"
    "  thalweg build points.xyz                         only the report, nothing written";

struct BuildOptions {
  std::string points;
  OutputPaths outputs;
  unsigned order = 8;
  Method method = Method::best;
  double time_limit = 60;
  Counter counter = Counter::crawl;
  DuplicatePolicy duplicates = DuplicatePolicy::lowest;
  std::string pits;
  bool fail_on_pits = false;
  std::string report;
  ReportOptions report_options;
  std::optional<std::uint64_t> max_memory;
  InputOptions input;
  RunOptions run;
};

/// Where everything goes, once it is known to make sense.
struct BuildTargets {
  std::vector<FormattedPath> meshes;
  std::vector<FormattedPath> pits;  // none or one
  std::vector<FormattedPath> reports;
};

/// What --report names, and what of -o is no mesh but a report or a map: taken out of `meshes`.
Result<std::vector<FormattedPath>> choose_reports(const BuildOptions& options,
                                                  std::vector<FormattedPath>& meshes) {
  OutputPaths named;
  if (!options.report.empty()) named.paths.push_back(options.report);
  Result<std::vector<FormattedPath>> reports = choose_formats(named, kReportFormats, "a report");
  if (!reports) return reports;
  const auto is_report = [](const FormattedPath& target) {
    return std::ranges::find(kReportFormats, target.format) != kReportFormats.end();
  };
  std::ranges::copy_if(meshes, std::back_inserter(*reports), is_report);
  std::erase_if(meshes, is_report);
  if (options.report_options.sweep && reports->empty()) {
    return Error{ErrorCode::invalid_argument, "--sweep is shown in a report: name one with --report"};
  }
  return reports;
}

Result<BuildTargets> check_targets(const BuildOptions& options) {
  Result<std::vector<FormattedPath>> meshes = choose_formats(options.outputs, kMeshFormats, "a mesh");
  if (!meshes) return meshes.error();
  OutputPaths pits;
  if (!options.pits.empty()) pits.paths.push_back(options.pits);
  Result<std::vector<FormattedPath>> pit_files = choose_formats(pits, kPitFormats, "pits");
  if (!pit_files) return pit_files.error();
  std::vector<NamedPath> named = named_outputs(options.outputs, options.run);
  if (!options.pits.empty()) named.push_back({"--pits", options.pits});
  Result<std::vector<FormattedPath>> reports = choose_reports(options, *meshes);
  if (!reports) return reports.error();
  if (!options.report.empty()) named.push_back({"--report", options.report});
  if (auto error = check_outputs(named, std::span(&options.points, 1), options.run.overwrite)) return *error;
  return BuildTargets{std::move(*meshes), std::move(*pit_files), std::move(*reports)};
}

/// Tells the memory that is needed, and refuses what --max-memory forbids.
std::optional<ExitCode> check_memory(const BuildOptions& options, bool report, std::uint64_t points,
                                     Console& console) {
  const std::uint64_t needed = estimate_build_memory(points, options.method, report);
  const std::uint64_t machine = machine_memory_bytes();
  console.detail(options.points + ": " + counted(points, "point", "points") + ", about " +
                 format_bytes(needed) + " of memory needed");
  if (machine != 0 && needed > machine) {
    console.warn("about " + format_bytes(needed) + " of memory is needed and this machine has " +
                 format_bytes(machine) + ": cut the points into tiles if it does not suffice");
  }
  const auto refusal = over_limit(points, options.method, report, options.max_memory);
  if (!refusal) return std::nullopt;
  return console.fail(ExitCode::resources, options.points + ": " + *refusal);
}

MinimizeOptions minimize_options(const BuildOptions& options, Console& console) {
  MinimizeOptions minimize;
  minimize.order = options.order;
  minimize.method = options.method;
  minimize.time_limit = options.time_limit;
  minimize.counter = options.counter;
  minimize.duplicates = options.duplicates;
  minimize.threads = options.run.threads;
  minimize.cancel = &interrupted();
  minimize.progress = [&console](const char* stage, double fraction) { console.progress(stage, fraction); };
  return minimize;
}

std::vector<io::PitFeature> pit_features(const VertexMap& vertices, const Minimized& result) {
  std::vector<io::PitFeature> features;
  const auto feature = [&vertices](VertexId row) {
    const std::uint32_t vertex = vertices.vertex_of_row[row.index()];
    const Point3& p = vertices.points[vertex];
    io::PitFeature made;
    made.x = p.x;
    made.y = p.y;
    made.z = p.z;
    made.vertex = vertex;
    return made;
  };
  for (const RemainingPit& pit : result.remaining) {
    io::PitFeature made = feature(pit.vertex);
    made.boundary = pit.boundary;
    made.reason = name_of(pit.reason);
    made.order_needed = pit.order_needed;
    made.vertices = pit.vertices;
    features.push_back(std::move(made));
  }
  for (const RemovedPit& pit : result.removed) {
    io::PitFeature made = feature(pit.vertex);
    made.boundary = pit.boundary;
    made.removed = true;
    made.vertices = pit.vertices;
    features.push_back(std::move(made));
  }
  return features;
}

/// Meshes and pits into the batch.
std::optional<Error> add_data(OutputBatch& batch, const BuildTargets& targets, const io::PointTable& table,
                              const VertexMap& vertices, const Minimized& result) {
  if (!targets.meshes.empty()) {
    const CompactMesh mesh = compact(table.points, vertices, result);
    const io::MeshView view = view_of(vertices, mesh, result, table.crs);
    for (const FormattedPath& target : targets.meshes) {
      const auto write = [&](io::OutputFile& file) { return io::write_mesh(file, view, target.format); };
      if (auto error = batch.add(target.path, write)) return error;
    }
  }
  for (const FormattedPath& target : targets.pits) {
    const std::vector<io::PitFeature> features = pit_features(vertices, result);
    const auto write = [&](io::OutputFile& file) { return io::write_pits(file, features, target.format); };
    if (auto error = batch.add(target.path, write)) return error;
  }
  return std::nullopt;
}

/// The report in all the formats it is wanted in.
std::optional<Error> add_report_data(OutputBatch& batch, const BuildOptions& options,
                                     const BuildTargets& targets, const io::PointTable& table,
                                     const BuildReport& build, std::vector<SweepRow> sweep) {
  if (targets.reports.empty()) return std::nullopt;
  const ReportSource source{options.points, table.crs, std::string(name_of(options.method)), options.order,
                            build.threads};
  io::Report report = report_of_build(source, table.points, *build.vertices, *build.result);
  report.sweep = std::move(sweep);
  return add_reports(batch, targets.reports, report, options.report_options);
}

/// All outputs, the summary last, because it tells how long the others took.
std::optional<Error> write_outputs(const BuildOptions& options, const BuildTargets& targets,
                                   const io::PointTable& table, std::vector<SweepRow> sweep,
                                   BuildReport& report, Stopwatch& watch) {
  const WritingOutputs guard;
  OutputBatch batch(options.run.output());
  if (auto error = add_data(batch, targets, table, *report.vertices, *report.result)) return error;
  if (auto error = add_report_data(batch, options, targets, table, report, std::move(sweep))) return error;
  report.seconds_write = watch.lap();
  report.seconds_total = watch.total();
  if (!options.run.json.empty()) {
    if (auto error = batch.add(options.run.json, write_text(to_text(summarize(report))))) return error;
  }
  return batch.commit();
}

ExitCode finish(const BuildOptions& options, const BuildReport& report, const BuildTargets& targets,
                Console& console) {
  describe(report, console);
  for (const FormattedPath& target : targets.meshes) console.detail("  wrote      " + target.path);
  for (const FormattedPath& target : targets.pits) console.detail("  wrote      " + target.path);
  for (const FormattedPath& target : targets.reports) console.detail("  wrote      " + target.path);
  if (!options.fail_on_pits || report.result->pits.interior == 0) return ExitCode::done;
  return console.fail(
      ExitCode::verification,
      options.points + ": " +
          counted(report.result->pits.interior, "interior pit is left", "interior pits are left") +
          " (--fail-on-pits): try a larger -k, or see --pits for where and why");
}

ExitCode run_build(const BuildOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  const Result<BuildTargets> targets = check_targets(options);
  if (!targets) return console.fail(targets.error());

  Stopwatch watch;
  BuildReport report{.file = options.points,
                     .order = options.order,
                     .method = options.method,
                     .policy = options.duplicates,
                     .threads = thread_count(options.run.threads)};
  const Result<io::PointTable> table = load_points(options.points, options.input, options.run, console);
  if (!table) return console.fail(table.error());
  report.points = table->points.size();
  report.seconds_read = watch.lap();
  if (const auto refused = check_memory(options, !targets->reports.empty(), report.points, console))
    return *refused;

  const Result<Minimized> result = minimize_pits(table->points, minimize_options(options, console));
  if (!result) return console.fail(blame(options.points, result.error()));
  warn_of_duplicates(console, options.points, result->merged.size(), options.duplicates);
  Result<std::vector<SweepRow>> sweep =
      sweep_for_report(options.report_options, table->points, minimize_options(options, console));
  if (!sweep) return console.fail(blame(options.points, sweep.error()));
  watch.lap();
  console.progress("writing", 0);
  const VertexMap vertices = map_vertices(table->points, *result);
  report.result = &*result;
  report.vertices = &vertices;
  if (auto error = write_outputs(options, *targets, *table, *std::move(sweep), report, watch))
    return console.fail(*error);
  return finish(options, report, *targets, console);
}

}  // namespace

Command add_build(CLI::App& thalweg) {
  const auto options = std::make_shared<BuildOptions>();
  CLI::App* app =
      thalweg.add_subcommand("build", "Points in, a terrain of order k with as few pits as possible out");
  app->add_option("POINTS", options->points,
                  "File of points (xyz, csv, tsv, tlw, npy), grid (asc) or mesh; - is stdin")
      ->required();
  add_output_options(*app, options->outputs, "Mesh to write; may be given several times; - is stdout");
  add_order(*app, "Most sites that any circumcircle may hold (default: 8)",
            [options](unsigned k) { options->order = k; });
  add_parsed<Method>(
      *app, "-m,--method", "METHOD",
      "delaunay (remove nothing), flip, hull, best, which is never worse than these and nearly always "
      "proved\n"
      "to be optimal, or exact, which goes on searching where it is not (default: best)",
      "a method: " + std::string(kMethodNames), [](const std::string& s) { return parse_method(s); },
      [options](Method m) { options->method = m; });
  add_parsed<Counter>(
      *app, "--counter", "COUNTER",
      "How sites in circles are counted, with the same result: crawl, or voronoi, which takes more time and\n"
      "memory (default: crawl)",
      "a counter: crawl, voronoi", [](const std::string& s) { return parse_counter(s); },
      [options](Counter c) { options->counter = c; });
  add_parsed<double>(
      *app, "--time-limit", "SECONDS",
      "How long -m exact may go on searching; then the best found and the bound are reported (default: 60;\n"
      "0: until the end)",
      "a number of seconds, 0 or more", [](const std::string& s) { return parse_seconds(s); },
      [options](double seconds) { options->time_limit = seconds; });
  add_pit_options(*app, options->pits, options->fail_on_pits);
  app->add_option("--report", options->report, "Write a page (.html) to look at, or a map (.svg)")
      ->option_text("FILE");
  add_report_options(*app, options->report_options);
  add_duplicates(*app, options->duplicates);
  add_parsed<std::uint64_t>(
      *app, "--max-memory", "SIZE", "Refuse, with exit code 5, points that need more memory than, say, 8G",
      "a size such as 800M or 8G", [](const std::string& s) { return parse_bytes(s); },
      [options](std::uint64_t bytes) { options->max_memory = bytes; });
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kBuildFooter);
  return {app, [options](Console& console) { return run_build(*options, console); }};
}

}  // namespace thalweg::cli
