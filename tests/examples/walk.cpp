/// Walking a triangulation by its half-edges: once around every vertex, and once around the hull.
#include <thalweg/delaunay.hpp>

#include <cstdio>

int main() {
  const thalweg::Point2 sites[] = {{0, 0}, {6, 0}, {6, 4}, {0, 4}, {2, 1}, {4, 3}};
  const auto mesh = thalweg::delaunay(sites);
  if (!mesh) return 1;

  // Neighbours, counter-clockwise. Every edge is met from both its ends.
  std::uint32_t ends = 0, hull_edges = 0;
  thalweg::HalfedgeId border;
  for (std::uint32_t i = 0; i < mesh->vertex_count(); ++i) {
    const thalweg::VertexId v(i);
    mesh->for_each_neighbor(v, [&](thalweg::VertexId) { ++ends; });
    if (mesh->on_hull(v)) border = mesh->outgoing(v);
  }

  // The hull: the half-edge that leaves a hull vertex first is the one along the hull.
  const thalweg::HalfedgeId start = border;
  do {
    std::printf("%u -> %u\n", mesh->origin(border).index(), mesh->dest(border).index());
    border = mesh->outgoing(mesh->dest(border));
    ++hull_edges;
  } while (border != start);

  // Euler: inner edges have two half-edges, those of the hull one.
  return hull_edges == 4 && ends == mesh->halfedge_count() + hull_edges ? 0 : 2;
}
