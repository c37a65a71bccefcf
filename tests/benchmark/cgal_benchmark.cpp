#include "benchmark/cgal_benchmark.hpp"

#include "benchmark/run.hpp"

#ifdef THALWEG_BENCH_PEERS
#include "benchmark/cgal_delaunay.hpp"
#endif

namespace bench {

void add_cgal([[maybe_unused]] const SetOfSites& set) {
#ifdef THALWEG_BENCH_PEERS
  add(name_of("cgal", set), [set](benchmark::State& state) {
    const peers::CgalPoints points(places(set));
    repeat(state, [&] { benchmark::DoNotOptimize(points.face_count()); });
  });
#endif
}

}  // namespace bench
