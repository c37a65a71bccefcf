/// Method::exact over hostile terrains: it ends with a proof, no worse than best, and for few sites on the
/// grid with the minimum of all triangulations. The first byte is the order.
#include "terrain.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using thalweg::Method;
  fuzz::Input input(data, size);
  const fuzz::Terrain terrain(input, 13);
  const auto exact = fuzz::run_if_legal(terrain, Method::exact);
  if (!exact) return 0;
  fuzz::check(exact->certified, "exact ends with a proof", terrain);
  const thalweg::Minimized best = fuzz::run(terrain, Method::best, terrain.order);
  fuzz::check(best.lower_bound <= exact->pits.total && exact->pits.total <= best.pits.total,
              "the minimum is between bound and result of best", terrain);
  const auto fewest = fuzz::fewest_pits(terrain, 8);
  fuzz::check(!fewest || exact->pits.total == *fewest, "exact is the fewest of all triangulations", terrain);
  return 0;
}
