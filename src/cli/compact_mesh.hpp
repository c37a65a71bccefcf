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

/// Where the rows went.
struct VertexMap {
  std::vector<std::uint32_t> vertex_of_row;  ///< meaningless for merged rows
  std::vector<Point3> points;                ///< of the vertices
};

/// The vertices of `result` over `rows`; elevations are the rows' own, but for the means of
/// DuplicatePolicy::mean.
VertexMap map_vertices(std::span<const Point3> rows, const Minimized& result);

/// What a mesh file holds beside the vertices.
struct CompactMesh {
  std::vector<io::IndexTriangle> triangles;
  std::vector<std::uint8_t> pit;  ///< one a vertex: 1 if it is on a pit
};

CompactMesh compact(std::span<const Point3> rows, const VertexMap& vertices, const Minimized& result);

/// The view of it that writers take. Requires: all outlive the view.
io::MeshView view_of(const VertexMap& vertices, const CompactMesh& mesh, const Minimized& result,
                     const std::string& crs);

}  // namespace thalweg::cli
