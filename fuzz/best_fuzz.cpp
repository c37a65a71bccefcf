/// Method::best over hostile terrains: no worse than the heuristics, nor at a larger order, and what it
/// proves is true. The first byte is the order.
#include "terrain.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using thalweg::Method;
  fuzz::Input input(data, size);
  const fuzz::Terrain terrain(input, 24);
  const auto best = fuzz::run_if_legal(terrain, Method::best);
  if (!best) return 0;
  for (const Method method : {Method::flip, Method::hull}) {
    const thalweg::Minimized other = fuzz::run(terrain, method, terrain.order);
    fuzz::check(best->pits.total <= other.pits.total, "best is best", terrain);
    fuzz::check(other.lower_bound <= best->pits.total, "no bound is above any result", terrain);
  }
  const thalweg::Minimized further = fuzz::run(terrain, Method::best, terrain.order + 1);
  fuzz::check(further.pits.total <= best->pits.total, "a larger order is no worse", terrain);
  fuzz::check_against_fewest(*best, terrain, 7);
  return 0;
}
