/// An embedder of the two lower floors: how many sites lie in a circle.
#include <thalweg/circle_count.hpp>
#include <thalweg/delaunay.hpp>

int main() {
  const thalweg::Point2 sites[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {2, 1}};
  const auto triangulation = thalweg::delaunay(sites);
  if (!triangulation) return 1;
  const thalweg::DelaunayGraph graph(sites, *triangulation);
  thalweg::CircleCounter counter(graph);
  const thalweg::VertexId a(0), b(1), c(2);
  return counter.count_in_circle(a, b, c, 5) == 1 ? 0 : 1;
}
