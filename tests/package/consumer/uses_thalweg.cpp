/// An embedder of the whole library: the example of the README.
#include <thalweg/thalweg.hpp>

int main() {
  const thalweg::Point3 points[] = {{0, 0, 9}, {10, 0, 8}, {10, 8, 7}, {0, 9, 3}, {4, 4, 5}, {7, 4, 1}};
  const auto terrain = thalweg::minimize_pits(points, {.order = 4});
  if (!terrain) return 1;
  return terrain->pits.total <= terrain->delaunay_pits.total && terrain->lower_bound <= terrain->pits.total
             ? 0
             : 1;
}
