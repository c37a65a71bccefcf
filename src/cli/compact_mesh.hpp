/// The mesh as it is written: vertices in the order of the input rows, rows that were merged into others left
/// out.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/mesh_file.hpp"
#include "io/write_mesh.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/point.hpp"

namespace thalweg::cli {

struct CompactMesh {
  std::vector<Point3> points;
  std::vector<io::IndexTriangle> triangles;
  std::vector<std::uint8_t> pit;             ///< one a vertex: 1 if it is on a pit
  std::vector<std::uint32_t> vertex_of_row;  ///< where a row went; meaningless for merged rows
};

/// The mesh of `result` over `rows`; elevations are the rows' own, but for the means of
/// DuplicatePolicy::mean.
CompactMesh compact(std::span<const Point3> rows, const Minimized& result);

/// The view of it that writers take. Requires: both outlive the view.
io::MeshView view_of(const CompactMesh& mesh, const Minimized& result, const std::string& crs);

}  // namespace thalweg::cli
