/// Points for the commands that triangulate them.
#include "cli/points_input.hpp"

#include <algorithm>
#include <cmath>

#include "cli/interrupt.hpp"
#include "cli/names.hpp"
#include "cli/text.hpp"

namespace thalweg::cli {
namespace {

const char* shown(const std::string& path) {
  return path == "-" ? "<stdin>" : path.c_str();
}

void warn_of_degrees(Console& console, const std::string& path, const io::PointTable& table) {
  const bool named = table.crs == "EPSG:4326" || table.crs == "EPSG:4979";
  if (!named && !looks_like_degrees(table.points)) return;
  console.warn(
      std::string(shown(path)) +
      ": the coordinates look like degrees; circles are no circles there, so triangles and orders will be "
      "distorted: project to metres first, unless these are local coordinates");
}

}  // namespace

Result<io::PointTable> load_points(const std::string& path, const InputOptions& input, const RunOptions& run,
                                   Console& console) {
  console.progress("reading", 0);
  Result<io::PointTable> table = io::read_points(path, input.reader(run));
  if (!table) return table;
  // The last chance of Ctrl-C before the first long stretch that cannot be cut short.
  if (interrupted()) return Error{ErrorCode::cancelled, "interrupted"};
  if (table->skipped_nodata > 0) {
    console.note(std::string(shown(path)) + ": " +
                 counted(table->skipped_nodata, "row without data skipped", "rows without data skipped"));
  }
  warn_of_degrees(console, path, *table);
  return table;
}

Error blame(const std::string& path, const Error& error) {
  Error blamed = error;
  blamed.message = std::string(shown(path)) + ": " + error.message;
  if (error.rows.empty() || error.code == ErrorCode::cancelled) return blamed;
  constexpr std::size_t kMost = 5;
  blamed.message += error.rows.size() == 1 ? " (data row " : " (data rows ";
  for (std::size_t i = 0; i < std::min(kMost, error.rows.size()); ++i) {
    if (i > 0) blamed.message += ", ";
    blamed.message += std::to_string(error.rows[i]);
  }
  blamed.message += error.rows.size() > kMost ? ", ..., counted from 0)" : ", counted from 0)";
  return blamed;
}

bool looks_like_degrees(std::span<const Point3> points) noexcept {
  bool whole = true;
  for (const Point3& p : points) {
    if (std::abs(p.x) > 360 || std::abs(p.y) > 90) return false;
    whole = whole && p.x == std::floor(p.x) && p.y == std::floor(p.y);
  }
  return !points.empty() && !whole;
}

void warn_of_duplicates(Console& console, const std::string& path, std::uint64_t merged,
                        DuplicatePolicy policy) {
  if (merged == 0) return;
  console.warn(std::string(shown(path)) + ": " +
               counted(merged, "row repeats the place (x, y) of another and was merged",
                       "rows repeat the place (x, y) of another and were merged") +
               "; the elevation kept is the " + std::string(name_of(policy)) + " (--duplicates)");
}

}  // namespace thalweg::cli
