/// Points for the commands that triangulate them, with what a person should know about them.
#pragma once

#include <span>
#include <string>

#include "cli/common_options.hpp"
#include "cli/console.hpp"
#include "io/point_table.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::cli {

/// The points of `path`; says how many rows had no data, and warns if the coordinates seem to be degrees.
Result<io::PointTable> load_points(const std::string& path, const InputOptions& input, const RunOptions& run,
                                   Console& console);

/// The same error with the file that it is about, and the rows to blame, as rows are counted: from 0.
Error blame(const std::string& path, const Error& error);

/// Whether x and y could be longitude and latitude: within 360 and 90, and not whole numbers throughout.
bool looks_like_degrees(std::span<const Point3> points) noexcept;

/// Warns of rows that were merged into others, and how.
void warn_of_duplicates(Console& console, const std::string& path, std::uint64_t merged,
                        DuplicatePolicy policy);

}  // namespace thalweg::cli
