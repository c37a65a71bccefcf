/// From points in memory to a Triangulation with the caller's ids: order, triangulation and output included.
///
/// With -DTHALWEG_BENCH_PEERS=ON the same sets go through CGAL, without any output. Run
///   --benchmark_repetitions=5 --benchmark_enable_random_interleaving=true
///   --benchmark_report_aggregates_only=true
/// so that both meet the same weather, and compare medians of the CPU time (one thread) or real time (more).
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#ifdef THALWEG_BENCH_PEERS
#include "benchmark/cgal_delaunay.hpp"
#endif
#include "kernel/spatial_order.hpp"
#include "support/point_sets.hpp"
#include "thalweg/delaunay.hpp"

namespace {

using support::Random;
using thalweg::Point2;

enum class Set { uniform, lidar, grid, shuffled_grid, clusters, circle, parabola, strip };

constexpr double kTurn = 6.283185307179586;

double gaussian(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.unit())) * std::cos(kTurn * random.unit());
}

std::vector<Point2> grid_of(std::size_t width, double jitter, double unit, Point2 corner, Random& random) {
  std::vector<Point2> points;
  for (std::size_t i = 0; i < width; ++i) {
    for (std::size_t j = 0; j < width; ++j) {
      const double x = static_cast<double>(j) + jitter * random.unit(),
                   y = static_cast<double>(i) + jitter * random.unit();
      points.push_back({corner.x + std::round(x / unit) * unit, corner.y + std::round(y / unit) * unit});
    }
  }
  return points;
}

/// A hundred gaussian clusters of sigma 1e-6 to 1e-1.
std::vector<Point2> clusters_of(std::size_t count, Random& random) {
  std::vector<Point2> centres(100), points;
  for (Point2& c : centres) c = {random.unit(), random.unit()};
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t k = random.below(100);
    const double sigma = std::pow(10, -6 + k / 20.0);
    points.push_back({centres[k].x + sigma * gaussian(random), centres[k].y + sigma * gaussian(random)});
  }
  return points;
}

std::vector<Point2> make_set(Set set, std::size_t count) {
  Random random(7);
  const auto width = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  if (set == Set::lidar) return grid_of(width, 0.8, 0.01, {500000, 5400000}, random);
  if (set == Set::clusters) return clusters_of(count, random);
  if (set == Set::grid || set == Set::shuffled_grid) {
    std::vector<Point2> points = grid_of(width, 0, 1, {0, 0}, random);
    if (set == Set::grid) return points;
    for (std::size_t i = points.size(); i > 1; --i) {
      std::swap(points[i - 1], points[random.below(static_cast<std::uint32_t>(i))]);
    }
    return points;
  }
  std::vector<Point2> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double u = random.unit(), v = random.unit(), x = 2 * u - 1;
    if (set == Set::uniform) points.push_back({u, v});
    if (set == Set::circle) points.push_back({std::cos(kTurn * u), std::sin(kTurn * u)});
    if (set == Set::parabola) points.push_back({x, x * x});
    if (set == Set::strip) points.push_back({1e6 * u, v});
  }
  return points;
}

void thalweg_delaunay(benchmark::State& state, Set set, std::size_t count, unsigned threads) {
  const std::vector<Point2> points = make_set(set, count);
  for (auto _ : state) {
    auto t = thalweg::delaunay(points, {.threads = threads});
    benchmark::DoNotOptimize(t);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

void order_alone(benchmark::State& state, Set set, std::size_t count, unsigned threads) {
  const std::vector<Point2> points = make_set(set, count);
  for (auto _ : state) {
    auto order = thalweg::detail::spatial_order(points, threads);
    benchmark::DoNotOptimize(order);
  }
}

#ifdef THALWEG_BENCH_PEERS
void cgal_delaunay(benchmark::State& state, Set set, std::size_t count) {
  const std::vector<Point2> points = make_set(set, count);
  for (auto _ : state) benchmark::DoNotOptimize(peers::cgal_face_count(points));
}
#endif

void add_set(const std::string& name, Set set, std::size_t count) {
  const auto add = [&](const std::string& who, auto function, auto... arguments) {
    benchmark::RegisterBenchmark((who + "/" + name).c_str(), function, arguments...)
        ->Unit(benchmark::kMillisecond);
  };
  add("thalweg", thalweg_delaunay, set, count, 1u);
  add("thalweg_2_threads", thalweg_delaunay, set, count, 2u);
  add("order", order_alone, set, count, 1u);
#ifdef THALWEG_BENCH_PEERS
  add("cgal", cgal_delaunay, set, count);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::size_t kMillion = 1000000;
  add_set("uniform_1e5", Set::uniform, kMillion / 10);
  add_set("uniform_1e6", Set::uniform, kMillion);
  add_set("lidar_1e6", Set::lidar, kMillion);
  add_set("grid_1e6", Set::grid, kMillion);
  add_set("shuffled_grid_1e6", Set::shuffled_grid, kMillion);
  add_set("clusters_1e6", Set::clusters, kMillion);
  add_set("strip_1e6", Set::strip, kMillion);
  add_set("circle_1e5", Set::circle, kMillion / 10);
  add_set("parabola_1e5", Set::parabola, kMillion / 10);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
