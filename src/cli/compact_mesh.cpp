/// The mesh as it is written.
#include "cli/compact_mesh.hpp"

#include "thalweg/pits.hpp"

namespace thalweg::cli {

VertexMap map_vertices(std::span<const Point3> rows, const Minimized& result) {
  VertexMap map;
  map.vertex_of_row.resize(rows.size(), VertexId::kInvalid);
  map.points.reserve(result.sites);
  for (std::uint32_t row = 0; row < rows.size(); ++row) {
    if (result.triangulation.isolated(VertexId(row))) continue;
    map.vertex_of_row[row] = static_cast<std::uint32_t>(map.points.size());
    map.points.push_back(rows[row]);
  }
  for (const auto& [row, mean] : result.mean_elevations) map.points[map.vertex_of_row[row]].z = mean;
  return map;
}

CompactMesh compact(std::span<const Point3> rows, const VertexMap& vertices, const Minimized& result) {
  const Triangulation& terrain = result.triangulation;
  CompactMesh mesh;
  mesh.triangles.reserve(terrain.face_count());
  const auto vertex = [&](VertexId row) { return vertices.vertex_of_row[row.index()]; };
  for (std::uint32_t f = 0; f < terrain.face_count(); ++f) {
    const Triangle corners = terrain.corners(FaceId(f));
    mesh.triangles.push_back({vertex(corners[0]), vertex(corners[1]), vertex(corners[2])});
  }
  std::vector<double> z(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) z[row] = rows[row].z;
  for (const auto& [row, mean] : result.mean_elevations) z[row] = mean;
  mesh.pit.resize(vertices.points.size(), 0);
  const Pits pits = find_pits(terrain, z);
  for (std::uint32_t i = 0; i < pits.size(); ++i) {
    for (const VertexId v : pits[i]) mesh.pit[vertex(v)] = 1;
  }
  return mesh;
}

io::MeshView view_of(const VertexMap& vertices, const CompactMesh& mesh, const Minimized& result,
                     const std::string& crs) {
  return {.points = vertices.points,
          .triangles = mesh.triangles,
          .pit = mesh.pit,
          .order = result.face_orders,
          .crs = crs};
}

}  // namespace thalweg::cli
