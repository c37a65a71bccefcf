/// Triangle meshes as files hold them: OBJ, PLY, 2DM, TLW.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "io/read_options.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

using IndexTriangle = std::array<std::uint32_t, 3>;

struct MeshFile {
  std::vector<Point3> points;            ///< finite, in the order of the file
  std::vector<IndexTriangle> triangles;  ///< indices below points.size(); nothing else is checked
  std::string crs;                       ///< as in PointTable
};

/// The mesh at `path`; "-" is stdin. Errors: as read_points; malformed too for a face that is no triangle,
/// for an index out of range and for a mesh without faces; options.columns and options.nodata are not used.
Result<MeshFile> read_mesh(const std::string& path, const ReadOptions& options = {});

}  // namespace thalweg::io
