/// From points in memory to a Triangulation with the caller's ids: order, triangulation and output included;
/// two of them at once; and the spatial order alone.
#include "thalweg/delaunay.hpp"

#include <cstdint>
#include <thread>

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

/// Two triangulations at the same time, each on one thread: what two cores have to give that share caches,
/// memory and a host, and about the most that one triangulation can gain by two threads.
void add_two_at_once(const SetOfSites& set) {
  bench::add(bench::name_of("two_at_once", set, {.threads = 2}), [=](benchmark::State& state) {
    const auto points = bench::places(set);
    const auto triangulate = [&points] {
      auto triangulation = thalweg::delaunay(points, {.threads = 1});
      benchmark::DoNotOptimize(triangulation);
    };
    bench::repeat(state, [&] {
      std::thread other(triangulate);
      triangulate();
      other.join();
    });
    state.SetItemsProcessed(2 * state.iterations() * static_cast<std::int64_t>(points.size()));
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
    add_two_at_once(set);
    bench::add_cgal(set);
  }
  return bench::run(argc, argv);
}
