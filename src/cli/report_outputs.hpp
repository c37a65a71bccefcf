/// Reports as outputs: their options, the sweep they may show, and how they are written.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/console.hpp"
#include "cli/outputs.hpp"
#include "io/report.hpp"
#include "io/write_svg_map.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::cli {

inline constexpr std::array kReportFormats = {io::Format::html, io::Format::svg};

/// What a report is to hold beside what every report holds.
struct ReportOptions {
  bool sweep = false;
  io::MapLayers layers = {};  ///< of SVG
};

/// --sweep and --layers.
void add_report_options(CLI::App& app, ReportOptions& options);

/// Pits for the orders 0 to 10, if asked for; else no rows. `minimize` says how duplicates are merged and how
/// many threads there are.
Result<std::vector<SweepRow>> sweep_for_report(const ReportOptions& options, std::span<const Point3> points,
                                               const MinimizeOptions& minimize);

/// Adds the report in each of its formats to the batch.
[[nodiscard]] std::optional<Error> add_reports(OutputBatch& batch, std::span<const FormattedPath> targets,
                                               const io::Report& report, const ReportOptions& options);

}  // namespace thalweg::cli
