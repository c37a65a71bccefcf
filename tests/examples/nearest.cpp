/// The k nearest sites of any place, exactly, from the order-k Voronoi diagram.
#include <thalweg/order_k_voronoi.hpp>

#include <cstdio>
#include <vector>

int main() {
  std::vector<thalweg::Point2> wells;
  for (int i = 0; i < 100; ++i) wells.push_back({i % 10 * 10.0, i / 10 * 10.0});

  const auto diagram = thalweg::order_k_voronoi(wells, 3);
  if (!diagram) return 1;  // diagram.error().message says why

  // Nearest first; of equally distant sites the one smaller in (x, y) comes first.
  const auto nearest = diagram->nearest({42, 37});
  for (const thalweg::VertexId well : nearest) {
    const thalweg::Point2 at = diagram->point(well);
    std::printf("well %u at %g %g\n", well.index(), at.x, at.y);
  }
  // The same as a set: the cell that holds the place.
  const auto cell = diagram->sites(diagram->locate({42, 37}));
  return nearest.size() == 3 && nearest[0].index() == 44 && cell.size() == 3 ? 0 : 2;
}
