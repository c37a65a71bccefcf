#include "cli/report_outputs.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "cli/common_options.hpp"
#include "io/write_report.hpp"

namespace thalweg::cli {
namespace {

constexpr std::array<std::pair<std::string_view, bool io::MapLayers::*>, 6> kLayers = {
    {{"shading", &io::MapLayers::shading},
     {"cells", &io::MapLayers::cells},
     {"flow", &io::MapLayers::flow},
     {"edges", &io::MapLayers::edges},
     {"changes", &io::MapLayers::changes},
     {"pits", &io::MapLayers::pits}}};

/// The layers in a list such as "shading,pits", those alone.
std::optional<io::MapLayers> parse_layers(const std::string& text) {
  io::MapLayers layers;
  for (const auto& [name, member] : kLayers) layers.*member = false;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string_view word = std::string_view(text).substr(from, to - from);
    const auto found = std::ranges::find(kLayers, word, [](const auto& layer) { return layer.first; });
    if (found == kLayers.end()) return std::nullopt;
    layers.*(found->second) = true;
    from = to + 1;
  }
  return layers;
}

}  // namespace

void add_report_options(CLI::App& app, ReportOptions& options) {
  app.add_flag("--sweep", options.sweep,
               "Show in the report how many pits each method leaves at the orders 0 to 10 (takes longer)");
  add_parsed<io::MapLayers>(
      app, "--layers", "LIST",
      "What a map in SVG shows, some of shading, cells (Voronoi), flow, edges, changes, pits\n"
      "(default: edges,changes,pits)",
      "a list of layers, separated by commas: shading, cells, flow, edges, changes, pits", parse_layers,
      [&options](io::MapLayers layers) { options.layers = layers; });
}

Result<std::vector<SweepRow>> sweep_for_report(const ReportOptions& options, std::span<const Point3> points,
                                               const MinimizeOptions& minimize) {
  if (!options.sweep) return std::vector<SweepRow>();
  Result<Sweep> sweep = sweep_pits(points, 0, 10, minimize);
  if (!sweep) return sweep.error();
  return std::move(sweep->rows);
}

std::optional<Error> add_reports(OutputBatch& batch, std::span<const FormattedPath> targets,
                                 const io::Report& report, const ReportOptions& options) {
  for (const FormattedPath& target : targets) {
    const auto write = [&](io::OutputFile& file) {
      return target.format == io::Format::svg ? io::write_svg_map(file, report, options.layers)
                                              : io::write_report(file, report);
    };
    if (auto error = batch.add(target.path, write)) return error;
  }
  return std::nullopt;
}

}  // namespace thalweg::cli
