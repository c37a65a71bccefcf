/// Throughput of the predicates through their public functions: 20 000 tuples, in cache, one thread.
///
/// The label of each row is the sum of the signs, which is the same on every machine.
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "benchmark/run.hpp"
#include "support/random.hpp"
#include "thalweg/predicates.hpp"

namespace {

using support::Random;
using thalweg::Point2;
using Triple = std::array<Point2, 3>;
using Quadruple = std::array<Point2, 4>;

constexpr int kTuples = 20000;

Point2 place(Random& random) {
  const double x = random.unit();
  return {x, random.unit()};
}

int below(Random& random, std::uint32_t n) {
  return static_cast<int>(random.below(n));
}

template <std::size_t N>
std::array<Point2, N> random_tuple(Random& random) {
  std::array<Point2, N> tuple;
  for (Point2& p : tuple) p = place(random);
  return tuple;
}

/// Points within a thousandth of a random place.
template <std::size_t N>
std::array<Point2, N> local_tuple(Random& random) {
  const Point2 center = place(random);
  std::array<Point2, N> tuple;
  for (Point2& p : tuple) {
    const Point2 offset = place(random);
    p = {center.x + offset.x * 1e-3, center.y + offset.y * 1e-3};
  }
  return tuple;
}

/// The third point on the line through the other two, up to rounding.
Triple near_collinear(Random& random) {
  const Point2 a = place(random);
  const Point2 b = place(random);
  const double t = random.unit();
  return {a, b, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}};
}

Triple integer_collinear(Random& random) {
  const int x = below(random, 1000), y = below(random, 1000), dx = below(random, 100),
            dy = below(random, 100);
  Triple tuple;
  for (Point2& p : tuple) {
    const int t = below(random, 10);
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
  const int x = below(random, 1000), y = below(random, 1000);
  Quadruple tuple;
  for (Point2& p : tuple) {
    const auto& offset = kCircle[static_cast<std::size_t>(below(random, 12))];
    p = {static_cast<double>(x + offset[0]), static_cast<double>(y + offset[1])};
  }
  return tuple;
}

/// Squares on a lattice of a hundredth, at the size of UTM coordinates.
Quadruple utm_square(Random& random) {
  const int x = below(random, 1000000), y = below(random, 1000000), side = 1 + below(random, 100);
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
void add(const char* name, Tuple (*make)(Random&)) {
  bench::add(name, [make](benchmark::State& state) {
    Random random(2024);
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
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace

int main(int argc, char** argv) {
  add("orient2d/random", random_tuple<3>);
  add("orient2d/local", local_tuple<3>);
  add("orient2d/near_collinear", near_collinear);
  add("orient2d/integer_collinear", integer_collinear);
  add("incircle/random", random_tuple<4>);
  add("incircle/local", local_tuple<4>);
  add("incircle/near_cocircular", near_cocircular);
  add("incircle/integer_cocircular", integer_cocircular);
  add("incircle/utm_squares", utm_square);
  return bench::run(argc, argv);
}
