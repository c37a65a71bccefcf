/// Points in, a terrain without false pits out: the whole job in ten lines.
#include <thalweg/thalweg.hpp>

#include <cstdio>

int main() {
  const thalweg::Point3 points[] = {{0, 0, 9}, {10, 0, 8}, {10, 8, 7}, {0, 9, 3}, {4, 4, 5}, {7, 4, 1}};
  const auto terrain = thalweg::minimize_pits(points, {.order = 4});
  if (!terrain) return 1;  // terrain.error().message says why
  const thalweg::Triangulation& mesh = terrain->triangulation;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto [a, b, c] = mesh.corners(thalweg::FaceId(f));  // rows of `points`
    std::printf("%u %u %u\n", a.index(), b.index(), c.index());
  }
  return terrain->certified ? 0 : 2;
}
