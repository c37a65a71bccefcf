/// Throughput of the predicates through their public functions: 20 000 tuples, in cache, one thread.
///
/// Run with --benchmark_repetitions=5 --benchmark_report_aggregates_only=true and read the medians. The label
/// of each row is the sum of the signs, which is the same on every machine.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "thalweg/predicates.hpp"

namespace {

using thalweg::Point2;
using Triple = std::array<Point2, 3>;
using Quadruple = std::array<Point2, 4>;

constexpr int kTuples = 20000;

/// SplitMix64: the same numbers from every standard library.
class Random {
 public:
  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  Point2 point() {
    const double x = unit();
    return {x, unit()};
  }

 private:
  std::uint64_t state_ = 2024;
};

template <std::size_t N>
std::array<Point2, N> random_tuple(Random& random) {
  std::array<Point2, N> tuple;
  for (Point2& p : tuple) p = random.point();
  return tuple;
}

/// Points within a thousandth of a random place.
template <std::size_t N>
std::array<Point2, N> local_tuple(Random& random) {
  const Point2 center = random.point();
  std::array<Point2, N> tuple;
  for (Point2& p : tuple) {
    const Point2 offset = random.point();
    p = {center.x + offset.x * 1e-3, center.y + offset.y * 1e-3};
  }
  return tuple;
}

/// The third point on the line through the other two, up to rounding.
Triple near_collinear(Random& random) {
  const Point2 a = random.point();
  const Point2 b = random.point();
  const double t = random.unit();
  return {a, b, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}};
}

Triple integer_collinear(Random& random) {
  const int x = random.below(1000), y = random.below(1000), dx = random.below(100), dy = random.below(100);
  Triple tuple;
  for (Point2& p : tuple) {
    const int t = random.below(10);
    p = {static_cast<double>(x + t * dx), static_cast<double>(y + t * dy)};
  }
  return tuple;
}

/// Four points of the unit circle, up to rounding.
Quadruple near_cocircular(Random& random) {
  Quadruple tuple;
  for (Point2& p : tuple) {
    const double angle = 6.283185307179586 * random.unit();
    p = {std::cos(angle), std::sin(angle)};
  }
  return tuple;
}

/// Four of the twelve grid points at distance 25 from a grid point.
Quadruple integer_cocircular(Random& random) {
  constexpr std::array<std::array<int, 2>, 12> kCircle = {{{25, 0},
                                                           {24, 7},
                                                           {20, 15},
                                                           {15, 20},
                                                           {7, 24},
                                                           {0, 25},
                                                           {-7, 24},
                                                           {-15, 20},
                                                           {-25, 0},
                                                           {-24, -7},
                                                           {0, -25},
                                                           {7, -24}}};
  const int x = random.below(1000), y = random.below(1000);
  Quadruple tuple;
  for (Point2& p : tuple) {
    const auto& offset = kCircle[static_cast<std::size_t>(random.below(12))];
    p = {static_cast<double>(x + offset[0]), static_cast<double>(y + offset[1])};
  }
  return tuple;
}

/// Squares on a lattice of a hundredth, at the size of UTM coordinates.
Quadruple utm_square(Random& random) {
  const int x = random.below(1000000), y = random.below(1000000), side = 1 + random.below(100);
  const double x0 = (50000000 + x) / 100.0, x1 = (50000000 + x + side) / 100.0;
  const double y0 = (440000000 + y) / 100.0, y1 = (440000000 + y + side) / 100.0;
  return {Point2{x0, y0}, Point2{x1, y0}, Point2{x1, y1}, Point2{x0, y1}};
}

int sign(const Triple& t) {
  return thalweg::orient2d(t[0], t[1], t[2]);
}
int sign(const Quadruple& t) {
  return thalweg::incircle(t[0], t[1], t[2], t[3]);
}

template <class Tuple>
void run(benchmark::State& state, Tuple (*make)(Random&)) {
  Random random;
  std::vector<Tuple> tuples;
  for (int i = 0; i < kTuples; ++i) tuples.push_back(make(random));
  int sum = 0;
  for (auto _ : state) {
    sum = 0;
    for (const Tuple& tuple : tuples) sum += sign(tuple);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * kTuples);
  state.SetLabel("sum of signs " + std::to_string(sum));
}

BENCHMARK_CAPTURE(run, orient2d_random, random_tuple<3>);
BENCHMARK_CAPTURE(run, orient2d_local, local_tuple<3>);
BENCHMARK_CAPTURE(run, orient2d_near_collinear, near_collinear);
BENCHMARK_CAPTURE(run, orient2d_integer_collinear, integer_collinear);
BENCHMARK_CAPTURE(run, incircle_random, random_tuple<4>);
BENCHMARK_CAPTURE(run, incircle_local, local_tuple<4>);
BENCHMARK_CAPTURE(run, incircle_near_cocircular, near_cocircular);
BENCHMARK_CAPTURE(run, incircle_integer_cocircular, integer_cocircular);
BENCHMARK_CAPTURE(run, incircle_utm_squares, utm_square);

}  // namespace
