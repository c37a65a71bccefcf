/// The order-k Voronoi diagram: time to build, per query, and memory, over the order k and the number of
/// uniform sites n; and counting sites in circles with it against the search of the Delaunay graph.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/predicates.hpp"
#include "thalweg/voronoi_counter.hpp"

namespace {

using thalweg::Point2;
using thalweg::VertexId;

std::vector<Point2> uniform(std::size_t count, std::uint64_t seed) {
  std::vector<Point2> points(count);
  const auto next = [&seed] {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(seed >> 11) * 0x1p-53;
  };
  for (Point2& p : points) {
    p.x = next();
    p.y = next();
  }
  return points;
}

thalweg::OrderKVoronoi diagram_of(const std::vector<Point2>& points, unsigned k) {
  return std::move(*thalweg::order_k_voronoi(points, k));
}

/// Arguments: n, k. All orders up to k are built on the way.
void Build(benchmark::State& state) {
  const auto points = uniform(static_cast<std::size_t>(state.range(0)), 1);
  const auto k = static_cast<unsigned>(state.range(1));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const auto diagram = thalweg::order_k_voronoi(points, k);
    bytes = diagram->memory_bytes();
  }
  state.counters["bytes_per_site"] = static_cast<double>(bytes) / static_cast<double>(points.size());
}

void Locate(benchmark::State& state) {
  const auto diagram =
      diagram_of(uniform(static_cast<std::size_t>(state.range(0)), 1), static_cast<unsigned>(state.range(1)));
  const auto queries = uniform(1 << 16, 2);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(diagram.locate(queries[i++ % queries.size()]));
}

void Nearest(benchmark::State& state) {
  const auto diagram =
      diagram_of(uniform(static_cast<std::size_t>(state.range(0)), 1), static_cast<unsigned>(state.range(1)));
  const auto queries = uniform(1 << 16, 2);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(diagram.nearest(queries[i++ % queries.size()]));
}

/// The circles that the flip heuristic asks for: those of two neighbours in the Delaunay triangulation and a
/// third site near them, in random order.
std::vector<thalweg::Triangle> circles(const std::vector<Point2>& points,
                                       const thalweg::Triangulation& mesh) {
  std::vector<thalweg::Triangle> result;
  std::uint64_t seed = 3;
  while (result.size() < 1 << 16) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    const thalweg::HalfedgeId h(static_cast<std::uint32_t>((seed >> 32) % mesh.halfedge_count()));
    if (mesh.on_hull(h)) continue;
    const VertexId a = mesh.apex(h), b = mesh.origin(h), c = mesh.apex(mesh.twin(h));
    if (thalweg::orient2d(points[a.index()], points[b.index()], points[c.index()]) > 0)
      result.push_back({a, b, c});
  }
  return result;
}

void CountByVoronoi(benchmark::State& state) {
  const auto points = uniform(static_cast<std::size_t>(state.range(0)), 1);
  const auto k = static_cast<unsigned>(state.range(1));
  const auto queries = circles(points, *thalweg::delaunay(points));
  const auto diagram = diagram_of(points, k + 1);
  thalweg::VoronoiCounter counter(diagram);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [u, v, w] = queries[i++ % queries.size()];
    benchmark::DoNotOptimize(counter.count_in_circle(u, v, w, k));
  }
}

void CountByCrawl(benchmark::State& state) {
  const auto points = uniform(static_cast<std::size_t>(state.range(0)), 1);
  const auto k = static_cast<unsigned>(state.range(1));
  const auto mesh = thalweg::delaunay(points);
  const auto queries = circles(points, *mesh);
  const thalweg::DelaunayGraph graph(points, *mesh);
  thalweg::CircleCounter counter(graph);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [u, v, w] = queries[i++ % queries.size()];
    benchmark::DoNotOptimize(counter.count_in_circle(u, v, w, k));
  }
}

void sizes(benchmark::internal::Benchmark* b) {
  for (const int n : {1000, 10000, 100000}) {
    for (const int k : {1, 2, 4, 8, 10, 16}) b->Args({n, k});
  }
}

BENCHMARK(Build)->Apply(sizes)->Unit(benchmark::kMillisecond);
BENCHMARK(Locate)->Apply(sizes);
BENCHMARK(Nearest)->Apply(sizes);
BENCHMARK(CountByVoronoi)->Apply(sizes);
BENCHMARK(CountByCrawl)->Apply(sizes);

}  // namespace
