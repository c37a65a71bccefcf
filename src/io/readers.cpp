/// The public readers: each opens the file, finds its format and hands it to the reader of that format.
#include <algorithm>
#include <cmath>
#include <utility>

#include "io/grid.hpp"
#include "io/input_file.hpp"
#include "io/mesh_file.hpp"
#include "io/npy.hpp"
#include "io/point_table.hpp"
#include "io/readers.hpp"
#include "io/tlw.hpp"

namespace thalweg::io {
namespace {

struct Opened {
  InputFile input;
  Format format;
};

/// Of these the whole text is wanted at once; all else is read in blocks.
bool is_wanted_whole(Format format) {
  return format == Format::asc || format == Format::obj || format == Format::two_dm;
}

Result<Opened> open_input(const std::string& path, const ReadOptions& options) {
  Result<InputFile> input = InputFile::open(path, options);
  if (!input) return std::move(input).error();
  const Result<Format> format = format_of_input(*input, path, options);
  if (!format) return format.error();
  if (is_wanted_whole(*format)) {
    if (auto error = input->load_all()) return std::move(*error);
  }
  return Opened{std::move(*input), *format};
}

bool is_mesh(Format format) {
  return format == Format::obj || format == Format::ply || format == Format::ply_ascii ||
         format == Format::two_dm || format == Format::tlw;
}

Result<MeshFile> parse_mesh(Opened& opened, Faces faces) {
  if (opened.format == Format::obj) return parse_obj(opened.input, faces);
  if (opened.format == Format::two_dm) return parse_2dm(opened.input, faces);
  if (opened.format == Format::tlw) return parse_tlw(opened.input, faces);
  return parse_ply(opened.input, faces);
}

Result<PointTable> cells_of(const InputFile& input, const Grid& grid) {
  PointTable table;
  const auto count = static_cast<std::size_t>(
      std::count_if(grid.values.begin(), grid.values.end(), [&](double z) { return !grid.is_nodata(z); }));
  if (auto excess = find_excess(input, count)) return std::move(*excess);
  reserve_large(table.points, count);
  for (std::uint32_t row = 0; row < grid.rows; ++row) {
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const double z = grid.value(row, column);
      if (grid.is_nodata(z)) {
        ++table.skipped_nodata;
      } else {
        table.points.push_back({grid.x[column], grid.y[row], z});
      }
    }
  }
  return table;
}

void skip_nodata(PointTable& table, const ReadOptions& options) {
  if (!options.nodata) return;
  const double nodata = *options.nodata;
  table.skipped_nodata = std::erase_if(table.points, [=](const Point3& p) {
    return p.z == nodata || (std::isnan(p.z) && std::isnan(nodata));
  });
}

Result<PointTable> parse_points(Opened& opened, const ReadOptions& options) {
  if (is_mesh(opened.format)) {
    Result<MeshFile> mesh = parse_mesh(opened, Faces::ignore);
    if (!mesh) return std::move(mesh).error();
    PointTable table;
    table.crs = std::move(mesh->crs);
    table.points = std::move(mesh->points);
    skip_nodata(table, options);
    return table;
  }
  if (opened.format == Format::npy) {
    Result<PointTable> table = parse_npy(opened.input, options);
    if (table) skip_nodata(*table, options);
    return table;
  }
  if (opened.format == Format::asc) {
    Result<Grid> grid = parse_grid(opened.input, options);
    if (!grid) return std::move(grid).error();
    return cells_of(opened.input, *grid);
  }
  return parse_table(opened.input, options);
}

}  // namespace

std::optional<Error> find_excess(const InputFile& input, std::uint64_t count) {
  if (count <= kMostPoints) return std::nullopt;
  return input.error(ErrorCode::too_many_points, std::to_string(count) +
                                                     " points or more, and 32-bit ids allow " +
                                                     std::to_string(kMostPoints) + ": cut them into tiles");
}

Result<PointTable> read_points(const std::string& path, const ReadOptions& options) {
  Result<Opened> opened = open_input(path, options);
  if (!opened) return std::move(opened).error();
  Result<PointTable> table = parse_points(*opened, options);
  if (!table) return table;
  if (table->points.empty()) {
    return opened->input.error(ErrorCode::malformed, table->skipped_nodata == 0
                                                         ? "has no points"
                                                         : "has no points: every z is the no-data value");
  }
  if (auto excess = find_excess(opened->input, table->points.size())) return std::move(*excess);
  return table;
}

Result<Grid> read_grid(const std::string& path, const ReadOptions& options) {
  Result<Opened> opened = open_input(path, options);
  if (!opened) return std::move(opened).error();
  if (opened->format != Format::asc) {
    return opened->input.error(ErrorCode::malformed,
                               "is no grid: give an ESRI ASCII grid (.asc), or say --from asc");
  }
  return parse_grid(opened->input, options);
}

Result<MeshFile> read_mesh(const std::string& path, const ReadOptions& options) {
  Result<Opened> opened = open_input(path, options);
  if (!opened) return std::move(opened).error();
  if (!is_mesh(opened->format)) {
    return opened->input.error(ErrorCode::malformed,
                               "has points but no triangles: give a mesh (obj, ply, 2dm, tlw)");
  }
  Result<MeshFile> mesh = parse_mesh(*opened, Faces::keep);
  if (!mesh) return mesh;
  if (auto excess = find_excess(opened->input, mesh->points.size())) return std::move(*excess);
  if (mesh->points.empty())
    return opened->input.error(ErrorCode::malformed, "has no vertices: it is no mesh");
  if (mesh->triangles.empty())
    return opened->input.error(ErrorCode::malformed, "has no faces: points alone are no mesh");
  return mesh;
}

}  // namespace thalweg::io
