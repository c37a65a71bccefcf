/// Points from any file that holds some: rows of numbers, the cells of a grid, the vertices of a mesh.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/read_options.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

struct PointTable {
  /// In the order of the file; of a grid the centres of the cells that have data, row by row from the top
  /// left.
  std::vector<Point3> points;
  /// Rows or cells left out because their z is the no-data value.
  std::uint64_t skipped_nodata = 0;
  /// The coordinate reference system, when the file names one (PLY `comment crs: EPSG:28992`); else empty.
  std::string crs;
};

/// The points of the file at `path`; "-" is stdin. All of them are finite, and there is at least one.
/// Errors: unreadable (no such file, no permission, a directory, a format that is not ours), malformed,
/// cancelled, invalid_argument (options). The message reads "FILE:LINE: what, and what to do", without the
/// line where none is to blame. Complexity: O(size of the file), memory a small multiple of it whatever its
/// header promises.
Result<PointTable> read_points(const std::string& path, const ReadOptions& options = {});

}  // namespace thalweg::io
