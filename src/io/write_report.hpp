/// Writer of the report: one HTML file that holds everything it needs.
#pragma once

#include <optional>

#include "io/output_file.hpp"
#include "io/report.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// Writes the page; the caller commits. It loads nothing from anywhere: its styles, programs and data are
/// inside, and a content security policy forbids the rest. Text of the report is never markup. The same
/// report gives the same bytes. Errors: those of the output. Requires: indices below points.size(); names and
/// downstream one a point; after_order one a triangle of `after`.
[[nodiscard]] std::optional<Error> write_report(OutputFile& output, const Report& report);

}  // namespace thalweg::io
