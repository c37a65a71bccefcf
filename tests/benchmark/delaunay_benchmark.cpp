/// From points in memory to a Triangulation with the caller's ids: order, triangulation and output included;
/// and the spatial order alone.
#include "thalweg/delaunay.hpp"

#include <cstdint>

#include "benchmark/cgal_benchmark.hpp"
#include "benchmark/run.hpp"
#include "kernel/spatial_order.hpp"

namespace {

using bench::SetOfSites;

void add_delaunay(const SetOfSites& set, unsigned threads) {
  bench::add(bench::name_of("delaunay", set, {.threads = threads}), [=](benchmark::State& state) {
    const auto points = bench::places(set);
    bench::repeat(state, [&] {
      auto triangulation = thalweg::delaunay(points, {.threads = threads});
      benchmark::DoNotOptimize(triangulation);
    });
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
  });
}

void add_spatial_sort(const SetOfSites& set, unsigned threads) {
  bench::add(bench::name_of("spatial_sort", set, {.threads = threads}), [=](benchmark::State& state) {
    const auto points = bench::places(set);
    for (auto _ : state) {
      auto order = thalweg::detail::spatial_order(points, threads);
      benchmark::DoNotOptimize(order);
    }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
  });
}

}  // namespace

int main(int argc, char** argv) {
  for (const SetOfSites& set : bench::all_sets(10'000'000)) {
    for (const unsigned threads : {1u, 2u}) {
      add_delaunay(set, threads);
      if (set.count <= 1'000'000) add_spatial_sort(set, threads);
    }
    bench::add_cgal(set);
  }
  return bench::run(argc, argv);
}
