/// An embedder of the whole library, who also wants to know whether it is the version that was promised.
#include <cstring>
#include <thalweg/thalweg.hpp>

int main(int argc, char** argv) {
  const thalweg::Point3 points[] = {{0, 0, 9}, {10, 0, 8}, {10, 8, 7}, {0, 9, 3}, {4, 4, 5}, {7, 4, 1}};
  const auto terrain = thalweg::minimize_pits(points, {.order = 4});
  if (!terrain || terrain->pits.total != terrain->lower_bound || !terrain->certified) return 1;
  const thalweg::Point2 places[] = {{0, 0}, {4, 0}, {4, 3}};
  const auto diagram = thalweg::order_k_voronoi(places, 2);
  if (!diagram || diagram->nearest({3, 2}).front() != thalweg::VertexId(2)) return 1;
  return argc < 2 || std::strcmp(argv[1], thalweg::version()) == 0 ? 0 : 1;
}
