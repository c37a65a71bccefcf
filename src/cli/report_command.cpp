/// `thalweg report`: a mesh, or the summary of a build, as a page or a map to look at.
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/names.hpp"
#include "cli/outputs.hpp"
#include "cli/points_input.hpp"
#include "cli/report_model.hpp"
#include "cli/report_outputs.hpp"
#include "cli/resources.hpp"
#include "cli/summary.hpp"
#include "io/input_file.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kReportFooter =
    "MESH is a triangulation of any tool; it is compared with the Delaunay triangulation of its vertices. "
    "SUMMARY "
    "is what\n"
    "thalweg build --json wrote: the points it names are triangulated again in the same way, and the report "
    "says "
    "more.\n"
    "Exit code 4 if the mesh is not sound, or if the points are no longer those of the summary.\n"
    "The page .html holds all it needs and works without a network; .svg is a map for papers.\n"
    "\n"
    "Examples:\n"
    "  thalweg report terrain.ply -o report.html\n"
    "  thalweg report terrain.ply -o map.svg --layers shading,flow,pits\n"
    "  thalweg build points.xyz --json run.json && thalweg report run.json -o report.html --sweep";

struct ReportCommandOptions {
  std::string file;
  std::string points;
  OutputPaths outputs;
  ReportOptions report;
  InputOptions input;
  RunOptions run;
};

/// What a summary says of a build that has to be known to repeat it.
struct PastBuild {
  std::string file;
  unsigned order = 0;
  Method method = Method::best;
  DuplicatePolicy policy = DuplicatePolicy::lowest;
  std::uint64_t vertices = 0, pits_before = 0, pits_after = 0;
};

bool is_summary(const std::string& path) {
  return path.ends_with(".json");
}

Error malformed(const std::string& path, const std::string& what) {
  return {ErrorCode::malformed, path + ": " + what + ": give what thalweg build --json wrote"};
}

/// Every access is checked: the file is anybody's.
std::optional<PastBuild> past_build(const Json& summary) {
  const auto at = [&](const char* pointer) -> const Json* {
    const Json::json_pointer where(pointer);
    return summary.contains(where) ? &summary.at(where) : nullptr;
  };
  const Json *file = at("/input/file"), *policy = at("/input/policy"), *vertices = at("/input/vertices");
  const Json *order = at("/parameters/order"), *method = at("/parameters/method");
  const Json *before = at("/pits/delaunay/total"), *after = at("/pits/result/total");
  for (const Json* text : {file, policy, method}) {
    if (text == nullptr || !text->is_string()) return std::nullopt;
  }
  for (const Json* number : {vertices, order, before, after}) {
    if (number == nullptr || !number->is_number_unsigned()) return std::nullopt;
  }
  const auto known_method = parse_method(method->get<std::string>());
  const auto known_policy = parse_policy(policy->get<std::string>());
  const auto k = order->get<std::uint64_t>();
  if (!known_method || !known_policy || k >= 0xffffffffu) return std::nullopt;
  return PastBuild{file->get<std::string>(),
                   static_cast<unsigned>(k),
                   *known_method,
                   *known_policy,
                   vertices->get<std::uint64_t>(),
                   before->get<std::uint64_t>(),
                   after->get<std::uint64_t>()};
}

Result<PastBuild> read_summary(const std::string& path, const RunOptions& run) {
  io::ReadOptions reading;
  reading.cancel = &interrupted();
  reading.threads = run.threads;
  const Result<io::InputFile> file = io::read_input(path, reading);
  if (!file) return file.error();
  const Json summary = Json::parse(file->text(), nullptr, false);
  if (summary.is_discarded()) return malformed(path, "this is no JSON");
  auto past = past_build(summary);
  if (!past) return malformed(path, "this is no summary of a build");
  return *std::move(past);
}

/// The points of a summary: as it names them, else beside it.
std::string find_points(const ReportCommandOptions& options, const PastBuild& past) {
  namespace fs = std::filesystem;
  if (!options.points.empty()) return options.points;
  std::error_code ignored;
  const fs::path beside = fs::path(options.file).parent_path() / past.file;
  return !fs::exists(past.file, ignored) && fs::exists(beside, ignored) ? beside.string() : past.file;
}

/// What the report shows, or the exit code of what went wrong, which has been told.
struct Gathered {
  std::optional<io::Report> report;
  ExitCode code = ExitCode::done;
};

Gathered told(ExitCode code) {
  return {std::nullopt, code};
}

Gathered repeat_build(const ReportCommandOptions& options, Console& console) {
  const Result<PastBuild> past = read_summary(options.file, options.run);
  if (!past) return told(console.fail(past.error()));
  const std::string path = find_points(options, *past);
  const Result<io::PointTable> table = load_points(path, options.input, options.run, console);
  if (!table) return told(console.fail(table.error()));
  MinimizeOptions minimize;
  minimize.order = past->order;
  minimize.method = past->method;
  minimize.duplicates = past->policy;
  minimize.threads = options.run.threads;
  minimize.cancel = &interrupted();
  minimize.progress = [&console](const char* stage, double part) { console.progress(stage, part); };
  const Result<Minimized> result = minimize_pits(table->points, minimize);
  if (!result) return told(console.fail(blame(path, result.error())));
  if (result->sites != past->vertices || result->delaunay_pits.total != past->pits_before ||
      result->pits.total != past->pits_after) {
    return told(console.fail(
        ExitCode::verification,
        path + ": these are not the points of " + options.file +
            ", or they are read differently: give --points, --columns or --nodata as the build had them"));
  }
  Result<std::vector<SweepRow>> sweep = sweep_for_report(options.report, table->points, minimize);
  if (!sweep) return told(console.fail(blame(path, sweep.error())));
  console.progress("drawing", 0);
  const VertexMap vertices = map_vertices(table->points, *result);
  const ReportSource source{past->file, table->crs, std::string(name_of(past->method)), past->order,
                            thread_count(options.run.threads)};
  io::Report report = report_of_build(source, table->points, vertices, *result);
  report.sweep = *std::move(sweep);
  return {std::move(report), ExitCode::done};
}

Gathered look_at_mesh(const ReportCommandOptions& options, Console& console) {
  console.progress("reading", 0);
  const Result<io::MeshFile> mesh = io::read_mesh(options.file, options.input.reader(options.run));
  if (!mesh) return told(console.fail(mesh.error()));
  console.progress("measuring", 0);
  const ReportSource source{options.file, mesh->crs, "", 0, thread_count(options.run.threads)};
  Result<io::Report> report = report_of_mesh(source, *mesh);
  if (!report) return told(console.fail(blame(options.file, report.error())));
  MinimizeOptions minimize;
  minimize.threads = options.run.threads;
  minimize.cancel = &interrupted();
  Result<std::vector<SweepRow>> sweep = sweep_for_report(options.report, mesh->points, minimize);
  if (!sweep) return told(console.fail(blame(options.file, sweep.error())));
  report->sweep = *std::move(sweep);
  return {*std::move(report), ExitCode::done};
}

Json summarize(const io::Report& report) {
  Json summary = new_summary();
  summary["input"] = {{"file", report.file}, {"vertices", report.vertices}, {"triangles", report.triangles}};
  summary["pits"] = {{"delaunay", to_json(report.pits[0])},
                     {"result", to_json(report.pits[1])},
                     {"lower_bound", report.lower_bound},
                     {"certified", report.certified}};
  const auto water = [](const io::ReportWater& w) {
    return Json{
        {"basins", w.basins}, {"longest_path", w.longest_length}, {"longest_path_edges", w.longest_edges}};
  };
  summary["water"] = {{"delaunay", water(report.water[0])}, {"result", water(report.water[1])}};
  summary["drawn"] = {{"vertices", report.points.size()},
                      {"triangles", report.common.size() + report.after.size()}};
  summary["hash"] = {{"sites_in", nullptr}, {"sites_out", report.hash_out}};
  if (!report.hash_in.empty()) summary["hash"]["sites_in"] = report.hash_in;
  summary["peak_memory_bytes"] = peak_memory_bytes();
  return summary;
}

void describe(const io::Report& report, Console& console) {
  console.note(report.file + ": " + counted(report.vertices, "vertex", "vertices") + ", " +
               counted(report.triangles, "triangle", "triangles") + "; pits " +
               std::to_string(report.pits[0].total) + " -> " + std::to_string(report.pits[1].total));
  const std::size_t drawn = report.common.size() + report.after.size();
  if (drawn < report.triangles) {
    console.note("  drawn      " + counted(drawn, "triangle", "triangles") +
                 ": thinned out away from pits and changes");
  }
}

ExitCode run_report(const ReportCommandOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  const Result<std::vector<FormattedPath>> targets =
      choose_formats(options.outputs, kReportFormats, "a report");
  if (!targets) return console.fail(targets.error());
  const std::vector<NamedPath> named = named_outputs(options.outputs, options.run);
  const std::vector<std::string> inputs = {options.file, options.points};
  if (auto error = check_outputs(named, std::span(inputs).first(options.points.empty() ? 1 : 2),
                                 options.run.overwrite)) {
    return console.fail(*error);
  }
  Gathered gathered =
      is_summary(options.file) ? repeat_build(options, console) : look_at_mesh(options, console);
  if (!gathered.report) return gathered.code;
  if (interrupted()) return console.fail(Error{ErrorCode::cancelled, "interrupted"});
  const io::Report& report = *gathered.report;
  {
    const WritingOutputs guard;
    OutputBatch batch(options.run.output());
    if (auto error = add_reports(batch, *targets, report, options.report)) return console.fail(*error);
    if (!options.run.json.empty()) {
      if (auto error = batch.add(options.run.json, write_text(to_text(summarize(report))))) {
        return console.fail(*error);
      }
    }
    if (auto error = batch.commit()) return console.fail(*error);
  }
  describe(report, console);
  return ExitCode::done;
}

}  // namespace

Command add_report(CLI::App& thalweg) {
  const auto options = std::make_shared<ReportCommandOptions>();
  CLI::App* app = thalweg.add_subcommand("report", "A page or a map of a mesh, to look at");
  app->add_option("MESH|SUMMARY", options->file,
                  "Mesh (ply, obj, 2dm), - is stdin; or a summary (json) of thalweg build")
      ->required();
  add_output_options(*app, options->outputs,
                     "Report (.html) or map (.svg) to write; may be given several times");
  app->add_option("--points", options->points, "Points of the SUMMARY, if they are not where it says")
      ->option_text("FILE");
  add_report_options(*app, options->report);
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kReportFooter);
  return {app, [options](Console& console) { return run_report(*options, console); }};
}

}  // namespace thalweg::cli
