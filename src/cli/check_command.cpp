/// `thalweg check`: is this mesh, of whatever tool, a triangulation, of what order, with what pits?
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common_options.hpp"
#include "cli/compare_points.hpp"
#include "cli/interrupt.hpp"
#include "cli/mesh_measures.hpp"
#include "cli/outputs.hpp"
#include "cli/points_input.hpp"
#include "cli/resources.hpp"
#include "cli/summary.hpp"
#include "io/mesh_file.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/pits.hpp"
#include "thalweg/validate.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kCheckFooter =
    "Sound means: the triangles are counter-clockwise, do not overlap, use every vertex and cover the convex "
    "hull.\n"
    "The order of a triangle is the number of vertices strictly inside its circumcircle; a Delaunay mesh has "
    "order 0.\n"
    "With --points every distinct (x, y) of the file must be one vertex, with the elevation of a row there, "
    "bit for\n"
    "bit. Exit code 4 if the mesh is not sound, has a higher order than -k, or other points.\n"
    "\n"
    "Examples:\n"
    "  thalweg check terrain.ply\n"
    "  thalweg check terrain.obj -k 8 --points points.xyz --json -";

struct CheckOptions {
  std::string mesh;
  std::optional<unsigned> order;
  std::string points;
  InputOptions input;
  bool fail_on_pits = false;
  RunOptions run;
};

/// What is known of a sound mesh.
struct Soundness {
  std::vector<std::uint64_t> histogram;
  std::uint64_t non_delaunay_edges = 0;
  PitCount pits;

  std::uint64_t max_order() const noexcept { return histogram.empty() ? 0 : histogram.size() - 1; }
};

struct Findings {
  std::vector<Fault> faults;
  std::optional<Soundness> sound;
  std::optional<PointDifferences> differences;
  std::vector<std::string> failures;  ///< why the exit code is 4, if it is
};

/// Requires: no faults; `sites` are the places of the file's points.
Result<Soundness> measure(const io::MeshFile& file, std::span<const Point2> sites, unsigned threads) {
  std::vector<double> z;
  z.reserve(file.points.size());
  for (const Point3& p : file.points) z.push_back(p.z);
  std::vector<Triangle> triangles;
  for (const io::IndexTriangle& t : file.triangles) {
    triangles.push_back({VertexId(t[0]), VertexId(t[1]), VertexId(t[2])});
  }
  const auto count = static_cast<std::uint32_t>(sites.size());
  const std::optional<Triangulation> mesh = Triangulation::from_triangles(triangles, count);
  if (!mesh) return Error{ErrorCode::invalid_mesh, "the triangles do not form a triangulation"};
  const Result<Triangulation> delaunay = thalweg::delaunay(sites, {.threads = threads});
  if (!delaunay) return delaunay.error();
  const DelaunayGraph graph(sites, *delaunay);
  Soundness sound;
  sound.histogram = order_histogram(face_orders(graph, *mesh, count, threads));
  sound.non_delaunay_edges = count_non_delaunay(*mesh, sites);
  sound.pits = find_pits(*mesh, z).count();
  return sound;
}

std::string places(const std::vector<std::string>& examples) {
  std::string text;
  for (const std::string& example : examples) text += (text.empty() ? "" : "; ") + example;
  return text;
}

std::vector<std::string> failures_of(const CheckOptions& options, const Findings& findings) {
  std::vector<std::string> failures;
  for (const Fault& fault : findings.faults) {
    failures.push_back(std::string(fault_name(fault.kind)) + ": " + std::to_string(fault.count) + " (" +
                       places(fault.examples) + ")");
  }
  if (findings.sound && options.order && findings.sound->max_order() > *options.order) {
    failures.push_back("a triangle of order " + std::to_string(findings.sound->max_order()) +
                       ", more than -k allows (" + std::to_string(*options.order) + ")");
  }
  if (findings.differences && !findings.differences->none()) {
    const PointDifferences& d = *findings.differences;
    failures.push_back("the vertices are not the points of " + options.points + ": " +
                       std::to_string(d.missing) + " missing, " + std::to_string(d.foreign) + " foreign, " +
                       std::to_string(d.changed) + " changed (" + places(d.examples) + ")");
  }
  if (findings.sound && options.fail_on_pits && findings.sound->pits.interior > 0) {
    failures.push_back(
        counted(findings.sound->pits.interior, "interior pit is left", "interior pits are left") +
        " (--fail-on-pits)");
  }
  return failures;
}

Json summarize(const CheckOptions& options, const io::MeshFile& file, const Findings& findings) {
  Json summary = new_summary();
  summary["input"] = {
      {"file", options.mesh}, {"vertices", file.points.size()}, {"triangles", file.triangles.size()}};
  summary["parameters"] = {
      {"order", nullptr}, {"points", nullptr}, {"threads", thread_count(options.run.threads)}};
  if (options.order) summary["parameters"]["order"] = *options.order;
  if (!options.points.empty()) summary["parameters"]["points"] = options.points;
  summary["passed"] = findings.failures.empty();
  summary["sound"] = findings.faults.empty();
  summary["faults"] = Json::array();
  for (const Fault& fault : findings.faults) {
    summary["faults"].push_back(
        {{"kind", fault_name(fault.kind)}, {"count", fault.count}, {"examples", fault.examples}});
  }
  summary["pits"] = nullptr;
  summary["mesh"] = nullptr;
  if (findings.sound) {
    summary["pits"] = to_json(findings.sound->pits);
    summary["mesh"] = {{"triangles", file.triangles.size()},
                       {"max_order", findings.sound->max_order()},
                       {"order_histogram", findings.sound->histogram},
                       {"non_delaunay_edges", findings.sound->non_delaunay_edges}};
  }
  summary["points"] = nullptr;
  if (findings.differences) {
    const PointDifferences& d = *findings.differences;
    summary["points"] = {{"sites", d.sites},
                         {"missing", d.missing},
                         {"foreign", d.foreign},
                         {"changed", d.changed},
                         {"examples", d.examples}};
  }
  return summary;
}

void describe(const CheckOptions& options, const io::MeshFile& file, const Findings& findings,
              Console& console) {
  console.note(options.mesh + ": " + counted(file.points.size(), "vertex", "vertices") + ", " +
               counted(file.triangles.size(), "triangle", "triangles"));
  if (findings.sound) {
    const Soundness& sound = *findings.sound;
    console.note("  sound      a triangulation of its vertices that covers their convex hull");
    std::string orders;
    for (std::size_t k = 0; k < sound.histogram.size() && k < 12; ++k) {
      orders += " " + std::to_string(sound.histogram[k]);
    }
    if (sound.histogram.size() > 12) orders += " ...";
    console.note("  order      " + std::to_string(sound.max_order()) +
                 "; triangles of order 0, 1, ...:" + orders);
    console.note("  edges      " + std::to_string(sound.non_delaunay_edges) + " not locally Delaunay");
    console.note("  pits       " + std::to_string(sound.pits.total) + " (interior " +
                 std::to_string(sound.pits.interior) + ", boundary " + std::to_string(sound.pits.boundary) +
                 ")");
  }
  if (findings.differences && findings.differences->none()) {
    console.note("  points     those of " + options.points + ", bit for bit");
  }
}

struct CheckInput {
  io::MeshFile mesh;
  std::optional<io::PointTable> points;
};

/// --from is about the mesh, --columns and --nodata are about --points.
Result<CheckInput> read_input(const CheckOptions& options) {
  InputOptions mesh_options;
  mesh_options.from = options.input.from;
  Result<io::MeshFile> mesh = io::read_mesh(options.mesh, mesh_options.reader(options.run));
  if (!mesh) return mesh.error();
  CheckInput input{std::move(*mesh), std::nullopt};
  if (options.points.empty()) return input;
  InputOptions point_options = options.input;
  point_options.from.clear();
  Result<io::PointTable> points = io::read_points(options.points, point_options.reader(options.run));
  if (!points) return points.error();
  input.points = std::move(*points);
  return input;
}

Result<Findings> examine(const CheckOptions& options, const CheckInput& input, Console& console) {
  const Error cancelled{ErrorCode::cancelled, "interrupted"};
  const std::vector<Point2> sites = places_of(input.mesh.points);
  Findings findings;
  console.progress("checking the triangles", 0);
  findings.faults = find_faults(sites, input.mesh.triangles);
  if (interrupted()) return cancelled;
  if (findings.faults.empty()) {
    console.progress("counting orders", 0.3);
    Result<Soundness> sound = measure(input.mesh, sites, options.run.threads);
    if (!sound) return blame(options.mesh, sound.error());
    findings.sound = std::move(*sound);
  }
  if (interrupted()) return cancelled;
  if (input.points) findings.differences = compare_points(input.mesh.points, input.points->points);
  findings.failures = failures_of(options, findings);
  return findings;
}

std::optional<Error> check_arguments(const CheckOptions& options) {
  if (options.mesh == "-" && options.points == "-") {
    return Error{ErrorCode::invalid_argument,
                 "MESH and --points cannot both be stdin: give one of them a file"};
  }
  const std::vector<std::string> inputs = {options.mesh, options.points};
  return check_outputs(named_outputs({}, options.run), inputs, options.run.overwrite);
}

std::optional<Error> write_summary(const CheckOptions& options, const Json& summary) {
  if (options.run.json.empty()) return std::nullopt;
  const WritingOutputs guard;
  OutputBatch batch(options.run.output());
  if (auto error = batch.add(options.run.json, write_text(to_text(summary)))) return error;
  return batch.commit();
}

ExitCode run_check(const CheckOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  if (auto error = check_arguments(options)) return console.fail(*error);
  Stopwatch watch;
  console.progress("reading", 0);
  const Result<CheckInput> input = read_input(options);
  if (!input) return console.fail(input.error());
  const double seconds_read = watch.lap();
  const Result<Findings> findings = examine(options, *input, console);
  if (!findings) return console.fail(findings.error());
  const double seconds_check = watch.lap();

  Json summary = summarize(options, input->mesh, *findings);
  summary["seconds"] = {{"read", seconds_read}, {"check", seconds_check}, {"total", watch.total()}};
  summary["peak_memory_bytes"] = peak_memory_bytes();
  if (auto error = write_summary(options, summary)) return console.fail(*error);
  describe(options, input->mesh, *findings, console);
  for (const std::string& failure : findings->failures) {
    console.fail(ExitCode::verification, options.mesh + ": " + failure);
  }
  return findings->failures.empty() ? ExitCode::done : ExitCode::verification;
}

}  // namespace

Command add_check(CLI::App& thalweg) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* app =
      thalweg.add_subcommand("check", "Is this mesh a triangulation, of what order, with what pits?");
  app->add_option("MESH", options->mesh, "Mesh to check (ply, obj, 2dm, tlw); - is stdin")->required();
  add_order(*app, "Fail if a triangle has a higher order than K (default: only tell the order)",
            [options](unsigned k) { options->order = k; });
  app->add_option("--points", options->points, "Fail unless the vertices are the points of FILE, bit for bit")
      ->option_text("FILE");
  app->add_flag("--fail-on-pits", options->fail_on_pits, "Fail if there is an interior pit");
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kCheckFooter);
  return {app, [options](Console& console) { return run_check(*options, console); }};
}

}  // namespace thalweg::cli
