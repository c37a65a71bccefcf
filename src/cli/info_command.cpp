/// `thalweg info`: what is in a file of points, a grid or a mesh.
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common_options.hpp"
#include "cli/interrupt.hpp"
#include "cli/outputs.hpp"
#include "cli/points_input.hpp"
#include "cli/resources.hpp"
#include "cli/summary.hpp"
#include "io/format.hpp"
#include "io/grid.hpp"
#include "io/mesh_file.hpp"
#include "io/number.hpp"
#include "thalweg/predicates.hpp"

namespace thalweg::cli {
namespace {

constexpr const char* kInfoFooter =
    "Duplicates: rows equal to another in x, y and z (exact), and further elevations at a place (x, y) "
    "(other z).\n"
    "\n"
    "Examples:\n"
    "  thalweg info points.xyz\n"
    "  thalweg info dem.asc --json -";

struct InfoOptions {
  std::string file;
  InputOptions input;
  RunOptions run;
};

/// Least and largest coordinate of one axis.
struct Range {
  double least = 0;
  double largest = 0;
};

/// What is to be said of points, wherever they come from.
struct PointFacts {
  std::uint64_t points = 0;
  std::uint64_t sites = 0;
  std::uint64_t exact_duplicates = 0;
  std::uint64_t other_z = 0;
  bool collinear = true;
  std::array<Range, 3> extent{};
};

struct FileFacts {
  std::string kind;  ///< points, grid, mesh
  std::string crs;
  PointFacts points;
  std::uint64_t skipped_nodata = 0;
  std::optional<io::Grid> grid;  ///< without its values
  std::optional<std::uint64_t> triangles;
};

std::array<Range, 3> extent_of(std::span<const Point3> points) {
  std::array<Range, 3> extent{};
  if (points.empty()) return extent;
  const auto widen = [](Range& range, double value) {
    range.least = std::min(range.least, value);
    range.largest = std::max(range.largest, value);
  };
  const Point3& first = points.front();
  extent = {Range{first.x, first.x}, Range{first.y, first.y}, Range{first.z, first.z}};
  for (const Point3& p : points) {
    widen(extent[0], p.x);
    widen(extent[1], p.y);
    widen(extent[2], p.z);
  }
  return extent;
}

/// Requires: `points` sorted by place.
bool all_collinear(std::span<const Point3> points) {
  if (points.empty()) return true;
  const Point2 first{points.front().x, points.front().y};
  const Point2 last{points.back().x, points.back().y};
  return std::ranges::all_of(points, [&](const Point3& p) { return orient2d(first, last, {p.x, p.y}) == 0; });
}

PointFacts facts_of(std::vector<Point3> points) {
  PointFacts facts;
  facts.points = points.size();
  facts.extent = extent_of(points);
  std::ranges::sort(points, [](const Point3& a, const Point3& b) {
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
  });
  std::uint64_t distinct = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool new_place = i == 0 || points[i].x != points[i - 1].x || points[i].y != points[i - 1].y;
    facts.sites += new_place ? 1 : 0;
    distinct += new_place || points[i].z != points[i - 1].z ? 1 : 0;
  }
  facts.exact_duplicates = facts.points - distinct;
  facts.other_z = distinct - facts.sites;
  facts.collinear = all_collinear(points);
  return facts;
}

Result<FileFacts> read_as_grid(const InfoOptions& options) {
  Result<io::Grid> grid = io::read_grid(options.file, options.input.reader(options.run));
  if (!grid) return grid.error();
  std::vector<Point3> points;
  for (std::uint32_t row = 0; row < grid->rows; ++row) {
    for (std::uint32_t column = 0; column < grid->columns; ++column) {
      const double z = grid->value(row, column);
      if (!grid->is_nodata(z)) points.push_back({grid->x[column], grid->y[row], z});
    }
  }
  FileFacts facts;
  facts.kind = "grid";
  facts.skipped_nodata = grid->values.size() - points.size();
  facts.points = facts_of(std::move(points));
  grid->values.clear();
  facts.grid = std::move(*grid);
  return facts;
}

Result<FileFacts> read_as_points(const InfoOptions& options) {
  Result<io::PointTable> table = io::read_points(options.file, options.input.reader(options.run));
  if (!table) return table.error();
  FileFacts facts;
  facts.kind = "points";
  facts.crs = table->crs;
  facts.skipped_nodata = table->skipped_nodata;
  facts.points = facts_of(std::move(table->points));
  return facts;
}

/// A mesh without faces is points; stdin can be read only once.
Result<FileFacts> read_as_mesh(const InfoOptions& options) {
  Result<io::MeshFile> mesh = io::read_mesh(options.file, options.input.reader(options.run));
  if (!mesh) {
    if (options.file == "-" || mesh.error().code != ErrorCode::malformed) return mesh.error();
    Result<FileFacts> points = read_as_points(options);
    if (!points) return mesh.error();
    return points;
  }
  FileFacts facts;
  facts.kind = "mesh";
  facts.crs = mesh->crs;
  facts.triangles = mesh->triangles.size();
  facts.points = facts_of(std::move(mesh->points));
  return facts;
}

Result<FileFacts> read_facts(const InfoOptions& options) {
  if (options.file == "-" && options.input.from.empty()) return read_as_points(options);
  const Result<io::Format> format = io::format_of(options.file, options.input.from, io::Direction::read);
  if (!format) return read_as_points(options);  // which words the error as for any other command
  switch (*format) {
    case io::Format::asc:
      return read_as_grid(options);
    case io::Format::obj:
    case io::Format::ply:
    case io::Format::ply_ascii:
    case io::Format::two_dm:
    case io::Format::tlw:
      return read_as_mesh(options);
    default:
      return read_as_points(options);
  }
}

Json range_to_json(const Range& range) {
  return Json::array({range.least, range.largest});
}

Json summarize(const InfoOptions& options, const FileFacts& facts) {
  const PointFacts& points = facts.points;
  Json summary = new_summary();
  summary["input"] = {{"file", options.file}, {"kind", facts.kind}, {"crs", facts.crs}};
  summary["points"] = points.points;
  summary["vertices"] = points.sites;
  summary["duplicates"] = {{"exact", points.exact_duplicates}, {"other_z", points.other_z}};
  summary["skipped_nodata"] = facts.skipped_nodata;
  summary["collinear"] = points.collinear;
  summary["extent"] = {{"x", range_to_json(points.extent[0])},
                       {"y", range_to_json(points.extent[1])},
                       {"z", range_to_json(points.extent[2])}};
  if (facts.grid) {
    summary["grid"] = {{"columns", facts.grid->columns},
                       {"rows", facts.grid->rows},
                       {"cell", {facts.grid->dx, facts.grid->dy}}};
  }
  if (facts.triangles) summary["triangles"] = *facts.triangles;
  summary["build_memory_bytes"] = estimate_build_memory(points.points, Method::best, false);
  return summary;
}

std::string to_text(double value) {
  std::array<char, io::kNumberSize> buffer{};
  return std::string(buffer.data(), io::put_number(buffer.data(), value));
}

void describe(const InfoOptions& options, const FileFacts& facts, Console& console) {
  const PointFacts& points = facts.points;
  console.note(options.file + ": " + facts.kind);
  if (facts.grid) {
    console.note("  grid        " + std::to_string(facts.grid->columns) + " columns, " +
                 std::to_string(facts.grid->rows) + " rows, cells of " + to_text(facts.grid->dx) + " by " +
                 to_text(facts.grid->dy));
  }
  const std::string skipped =
      facts.skipped_nodata == 0 ? "" : "; without data: " + std::to_string(facts.skipped_nodata);
  console.note("  points      " + std::to_string(points.points) + skipped);
  console.note("  sites       " + std::to_string(points.sites) +
               "; duplicates: " + std::to_string(points.exact_duplicates) + " exact, " +
               std::to_string(points.other_z) + " with another elevation");
  constexpr std::array kAxes = {"  x           ", "  y           ", "  z           "};
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const Range& range = points.extent[axis];
    console.note(kAxes[axis] + to_text(range.least) + " to " + to_text(range.largest));
  }
  if (!facts.crs.empty()) console.note("  crs         " + facts.crs);
  if (facts.triangles) console.note("  triangles   " + std::to_string(*facts.triangles));
  const auto memory = [&](Method method, bool report) {
    return format_bytes(estimate_build_memory(points.points, method, report));
  };
  console.note("  build needs about " + memory(Method::best, false) + " of memory, with -m flip " +
               memory(Method::flip, false) + ", with --report " + memory(Method::best, true));
  if (points.sites < 3) {
    console.warn(options.file + ": fewer than three sites: there is nothing to triangulate");
  } else if (points.collinear) {
    console.warn(options.file + ": all points lie on one line: there is nothing to triangulate");
  }
}

ExitCode run_info(const InfoOptions& options, Console& console) {
  console.configure(options.run.bar, options.run.quiet, options.run.verbose);
  const std::vector<NamedPath> outputs = named_outputs({}, options.run);
  if (auto error = check_outputs(outputs, std::span(&options.file, 1), options.run.overwrite)) {
    return console.fail(*error);
  }
  console.progress("reading", 0);
  const Result<FileFacts> facts = read_facts(options);
  if (!facts) return console.fail(facts.error());
  if (interrupted()) return console.fail({ErrorCode::cancelled, "interrupted"});
  if (!options.run.json.empty()) {
    const WritingOutputs guard;
    OutputBatch batch(options.run.output());
    const std::string text = cli::to_text(summarize(options, *facts));
    if (auto error = batch.add(options.run.json, write_text(text))) return console.fail(*error);
    if (auto error = batch.commit()) return console.fail(*error);
  }
  describe(options, *facts, console);
  return ExitCode::done;
}

}  // namespace

Command add_info(CLI::App& thalweg) {
  const auto options = std::make_shared<InfoOptions>();
  CLI::App* app =
      thalweg.add_subcommand("info", "Counts, extent, duplicates, and the memory that build needs");
  app->add_option("FILE", options->file,
                  "Points (xyz, csv, tsv, npy), grid (asc) or mesh (ply, obj, 2dm, tlw); - is stdin")
      ->required();
  add_input_options(*app, options->input);
  add_run_options(*app, options->run);
  app->footer(kInfoFooter);
  return {app, [options](Console& console) { return run_info(*options, console); }};
}

}  // namespace thalweg::cli
