/// An embedder of the floor thalweg: a Delaunay triangulation and nothing else.
#include <thalweg/thalweg.hpp>

int main() {
  const thalweg::Point2 sites[] = {{0, 0}, {4, 0}, {4, 3}, {0, 3}, {2, 1}};
  const auto triangulation = thalweg::delaunay(sites);
  return triangulation && triangulation->face_count() == 4 && !triangulation->find_fault() ? 0 : 1;
}
