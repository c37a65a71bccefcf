/// The mesh as it is written.
#include "cli/compact_mesh.hpp"

#include "thalweg/pits.hpp"

namespace thalweg::cli {
namespace {

// Elevation of every row, as the terrain has it.
std::vector<double> elevations(std::span<const Point3> rows, const Minimized& result) {
  std::vector<double> z(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) z[i] = rows[i].z;
  for (const auto& [row, mean] : result.mean_elevations) z[row] = mean;
  return z;
}

}  // namespace

CompactMesh compact(std::span<const Point3> rows, const Minimized& result) {
  const Triangulation& terrain = result.triangulation;
  const std::vector<double> z = elevations(rows, result);
  CompactMesh mesh;
  mesh.vertex_of_row.resize(rows.size(), VertexId::kInvalid);
  mesh.points.reserve(result.sites);
  for (std::uint32_t row = 0; row < terrain.vertex_count(); ++row) {
    if (terrain.isolated(VertexId(row))) continue;
    mesh.vertex_of_row[row] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back({rows[row].x, rows[row].y, z[row]});
  }
  mesh.triangles.reserve(terrain.face_count());
  for (std::uint32_t f = 0; f < terrain.face_count(); ++f) {
    const Triangle corners = terrain.corners(FaceId(f));
    mesh.triangles.push_back({mesh.vertex_of_row[corners[0].index()], mesh.vertex_of_row[corners[1].index()],
                              mesh.vertex_of_row[corners[2].index()]});
  }
  mesh.pit.resize(mesh.points.size(), 0);
  const Pits pits = find_pits(terrain, z);
  for (std::uint32_t i = 0; i < pits.size(); ++i) {
    for (const VertexId v : pits[i]) mesh.pit[mesh.vertex_of_row[v.index()]] = 1;
  }
  return mesh;
}

io::MeshView view_of(const CompactMesh& mesh, const Minimized& result, const std::string& crs) {
  return {.points = mesh.points,
          .triangles = mesh.triangles,
          .pit = mesh.pit,
          .order = result.face_orders,
          .crs = crs};
}

}  // namespace thalweg::cli
