/// Every reader on hostile bytes: an error that names the file, or content that keeps its
/// contract. The first byte chooses the format; text that begins with # is a table.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <string>

#include "fuzz_input.hpp"
#include "io/grid.hpp"
#include "io/mesh_file.hpp"
#include "io/point_table.hpp"
#include "io/read_places.hpp"
#include "io/read_segments.hpp"

namespace {

using thalweg::Error;
using thalweg::Point3;
namespace io = thalweg::io;

constexpr const char* kFormats[] = {"xyz", "csv", "tsv", "asc", "obj", "ply", "2dm", "tlw", "npy"};

void require(bool holds, const char* law) {
  fuzz::check(holds, law, {});
}

/// A file that has no place on any disk.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("fuzz", 0)) {
    require(descriptor_ >= 0, "no file in memory");
    path_ = "/proc/self/fd/" + std::to_string(descriptor_);
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  void fill(const std::uint8_t* data, std::size_t size) const {
    const auto length = static_cast<off_t>(size);
    const bool whole = ::ftruncate(descriptor_, length) == 0 &&
                       ::pwrite(descriptor_, data, size, 0) == static_cast<ssize_t>(size);
    require(whole, "the file in memory can be filled");
  }
  const std::string& path() const { return path_; }

 private:
  int descriptor_;
  std::string path_;
};

bool finite(const std::vector<Point3>& points) {
  return std::all_of(points.begin(), points.end(), [](const Point3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

void check_error(const Error& error, const std::string& path) {
  require(error.message.starts_with(path + ":") || error.code == thalweg::ErrorCode::invalid_argument,
          "a message begins with the name of the file");
  require(error.message.size() < path.size() + 1200, "a message is short");
  require(std::none_of(error.message.begin(), error.message.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 0x20; }),
          "a message is one line that can be printed");
}

void check_points(const std::string& path, const io::ReadOptions& options) {
  const auto table = io::read_points(path, options);
  if (!table) return check_error(table.error(), path);
  require(!table->points.empty() && finite(table->points), "points are finite, and there is one");
  io::ReadOptions parallel = options;
  parallel.threads = 3;
  const auto again = io::read_points(path, parallel);
  require(
      again && again->points.size() == table->points.size() &&
          std::memcmp(again->points.data(), table->points.data(), table->points.size() * sizeof(Point3)) == 0,
      "the points do not depend on the number of threads");
}

void check_mesh(const std::string& path, const io::ReadOptions& options) {
  const auto mesh = io::read_mesh(path, options);
  if (!mesh) return check_error(mesh.error(), path);
  require(finite(mesh->points), "vertices are finite");
  for (const io::IndexTriangle& triangle : mesh->triangles) {
    for (const std::uint32_t v : triangle) require(v < mesh->points.size(), "corners are vertices");
  }
}

void check_grid(const std::string& path, const io::ReadOptions& options) {
  const auto grid = io::read_grid(path, options);
  if (!grid) return check_error(grid.error(), path);
  require(grid->values.size() == std::size_t{grid->columns} * grid->rows, "a value a cell");
  require(grid->x.size() == grid->columns && grid->y.size() == grid->rows, "a place a row and column");
  for (const double value : grid->values) {
    require(std::isfinite(value) || grid->is_nodata(value), "values are finite or no data");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const MemoryFile file;
  if (size == 0) return 0;
  const bool text = data[0] == '#';
  const std::size_t kind = text ? 0 : data[0] % std::size(kFormats);
  file.fill(text ? data : data + 1, text ? size : size - 1);
  io::ReadOptions options;
  options.format = kFormats[kind];
  if (!text && data[0] >= 128) options.nodata = -9999;
  check_points(file.path(), options);
  if (options.format == "asc") check_grid(file.path(), options);
  if (kind >= 4) check_mesh(file.path(), options);
  if (kind > 0) return 0;
  if (const auto places = io::read_places(file.path())) {
    require(fuzz::all_finite(*places), "places are finite");
  } else {
    check_error(places.error(), file.path());
  }
  if (const auto segments = io::read_segments(file.path())) {
    require(segments->lines.size() == segments->segments.size(), "a line a segment");
  } else {
    check_error(segments.error(), file.path());
  }
  return 0;
}
