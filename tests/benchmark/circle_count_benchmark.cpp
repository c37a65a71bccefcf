/// Counting sites in circles by search of the Delaunay graph (circle_count) and by point location in the
/// order-(k+1) Voronoi diagram (voronoi_count).
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "benchmark/circle_count_benchmark.hpp"
#include "benchmark/run.hpp"
#include "support/random.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/predicates.hpp"
#include "thalweg/voronoi_counter.hpp"

namespace bench {
namespace {

using thalweg::Point2;
using thalweg::Triangle;
using thalweg::VertexId;

constexpr std::size_t kCircles = std::size_t{1} << 16;

/// The circles that the flip heuristic asks for: those of two neighbours in the Delaunay triangulation and a
/// third site near them, in random order. Fewer where hardly any edge can be flipped.
std::vector<Triangle> circles(std::span<const Point2> points, const thalweg::Triangulation& mesh) {
  std::vector<Triangle> result;
  support::Random random(3);
  for (std::size_t draws = 0; draws < 16 * kCircles && result.size() < kCircles; ++draws) {
    const thalweg::HalfedgeId h(random.below(mesh.halfedge_count()));
    if (mesh.on_hull(h)) continue;
    const VertexId a = mesh.apex(h), b = mesh.origin(h), c = mesh.apex(mesh.twin(h));
    if (thalweg::orient2d(points[a.index()], points[b.index()], points[c.index()]) > 0) {
      result.push_back({a, b, c});
    }
  }
  return result;
}

template <class Counter>
void count(benchmark::State& state, Counter& counter, std::span<const Triangle> queries, unsigned order) {
  if (queries.empty()) return state.SkipWithError("no circles");
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [u, v, w] = queries[i++ % queries.size()];
    benchmark::DoNotOptimize(counter.count_in_circle(u, v, w, order));
  }
  state.SetItemsProcessed(state.iterations());
}

}  // namespace

void add_circle_count(const SetOfSites& set, unsigned order) {
  add(name_of("circle_count", set, {order}), [=](benchmark::State& state) {
    const auto points = places(set);
    const auto mesh = thalweg::delaunay(points);
    if (!mesh) return state.SkipWithError(mesh.error().message.c_str());
    const thalweg::DelaunayGraph graph(points, *mesh);
    thalweg::CircleCounter counter(graph);
    count(state, counter, circles(points, *mesh), order);
  })->Unit(benchmark::kNanosecond);
}

void add_voronoi_count(const SetOfSites& set, unsigned order) {
  add(name_of("voronoi_count", set, {order}), [=](benchmark::State& state) {
    const auto points = places(set);
    const auto mesh = thalweg::delaunay(points);
    if (!mesh) return state.SkipWithError(mesh.error().message.c_str());
    const auto diagram = thalweg::order_k_voronoi(points, order + 1);
    if (!diagram) return state.SkipWithError(diagram.error().message.c_str());
    thalweg::VoronoiCounter counter(*diagram);
    count(state, counter, circles(points, *mesh), order);
  })->Unit(benchmark::kNanosecond);
}

}  // namespace bench
