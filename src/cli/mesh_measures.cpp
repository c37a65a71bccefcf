#include "cli/mesh_measures.hpp"

#include "thalweg/predicates.hpp"

namespace thalweg::cli {

std::uint64_t count_non_delaunay(const Triangulation& mesh, std::span<const Point2> sites) {
  std::uint64_t count = 0;
  const auto at = [&](VertexId v) { return sites[v.index()]; };
  for (std::uint32_t i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const HalfedgeId twin = mesh.twin(h);
    if (!twin.valid() || twin < h) continue;
    const int side = incircle(at(mesh.origin(h)), at(mesh.dest(h)), at(mesh.apex(h)), at(mesh.apex(twin)));
    if (side > 0) ++count;
  }
  return count;
}

std::vector<Point2> places_of(std::span<const Point3> points) {
  std::vector<Point2> places;
  places.reserve(points.size());
  for (const Point3& p : points) places.push_back({p.x, p.y});
  return places;
}

}  // namespace thalweg::cli
