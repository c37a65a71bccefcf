/// The order-k Voronoi diagram: time to build, per query, and memory, over the order k and the set; and
/// counting sites in circles with it against the search of the Delaunay graph.
#include <cstdint>
#include <vector>

#include "benchmark/circle_count_benchmark.hpp"
#include "benchmark/run.hpp"
#include "support/random.hpp"
#include "thalweg/order_k_voronoi.hpp"

namespace {

using bench::SetOfSites;
using thalweg::Point2;

/// All orders up to k are built on the way. Counter: bytes_per_site.
void add_build(const SetOfSites& set, unsigned order) {
  bench::add(bench::name_of("voronoi_build", set, {order}), [=](benchmark::State& state) {
    const auto points = bench::places(set);
    std::size_t bytes = 0;
    for (auto _ : state) {
      const auto diagram = thalweg::order_k_voronoi(points, order);
      if (!diagram) return state.SkipWithError(diagram.error().message.c_str());
      bytes = diagram->memory_bytes();
    }
    state.counters["bytes_per_site"] = static_cast<double>(bytes) / static_cast<double>(points.size());
  });
}

/// Places between two random sites each: within the hull, and few of them on a site.
std::vector<Point2> queries_among(std::span<const Point2> points) {
  support::Random random(2);
  std::vector<Point2> queries;
  for (std::size_t i = 0; i < std::size_t{1} << 16; ++i) {
    const Point2 a = points[random.below(static_cast<std::uint32_t>(points.size()))];
    const Point2 b = points[random.below(static_cast<std::uint32_t>(points.size()))];
    queries.push_back({a.x + random.unit() * (b.x - a.x), a.y + random.unit() * (b.y - a.y)});
  }
  return queries;
}

template <class Ask>
void add_query(const char* job, const SetOfSites& set, unsigned order, Ask ask) {
  bench::add(bench::name_of(job, set, {order}), [=](benchmark::State& state) {
    const auto points = bench::places(set);
    const auto diagram = thalweg::order_k_voronoi(points, order);
    if (!diagram) return state.SkipWithError(diagram.error().message.c_str());
    const std::vector<Point2> queries = queries_among(points);
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(ask(*diagram, queries[i++ % queries.size()]));
  })->Unit(benchmark::kNanosecond);
}

void add_all(const SetOfSites& set, unsigned order) {
  using Diagram = thalweg::OrderKVoronoi;
  bench::add_circle_count(set, order);
  if (set.count > 100'000) return;
  bench::add_voronoi_count(set, order);
  add_build(set, order);
  add_query("voronoi_locate", set, order, [](const Diagram& d, Point2 q) { return d.locate(q); });
  add_query("voronoi_nearest", set, order, [](const Diagram& d, Point2 q) { return d.nearest(q); });
}

}  // namespace

int main(int argc, char** argv) {
  for (const SetOfSites& set : bench::all_sets(1'000'000)) {
    if (set.name != "uniform") {
      add_all(set, 8);
      continue;
    }
    for (const unsigned order : {1u, 2u, 4u, 8u, 16u}) add_all(set, order);
  }
  return bench::run(argc, argv);
}
