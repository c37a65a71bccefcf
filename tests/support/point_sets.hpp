/// Sets of points of twenty kinds that are hard on a Delaunay triangulation, the same on every machine but
/// for libm.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "support/random.hpp"
#include "thalweg/point.hpp"

namespace support {

using thalweg::Point2;

inline bool lexicographic(Point2 a, Point2 b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Point sets of one kind each, many with duplicates, some collinear.
enum class Kind {
  uniform,
  small_grid,
  wide_grid,
  column,
  ring,
  integer_ring,
  parabola,
  collinear,
  near_collinear,
  clusters,
  far_clusters,
  one_cell,
  spiral,
  ulps,
  utm,
  flat_box,
  denormal,
  huge,
  any_exponent,
  signed_zeros,
  kinds
};

inline Point2 point_of(Kind kind, Random& random, std::uint32_t i) {
  const double u = random.unit(), v = random.unit();
  const double turn = 2 * 3.141592653589793 * u;
  switch (kind) {
    case Kind::uniform:
      return {u, v};
    case Kind::small_grid:
      return {random.whole(0, 3), random.whole(-2, 2)};
    case Kind::wide_grid:
      return {random.whole(0, 12), random.whole(0, 12)};
    case Kind::column:
      return {random.whole(0, 1), random.whole(0, 40)};
    case Kind::ring:
      return {std::cos(turn), std::sin(turn)};
    case Kind::integer_ring: {
      constexpr std::array<std::array<double, 2>, 5> kEighth = {
          {{65, 0}, {63, 16}, {60, 25}, {56, 33}, {52, 39}}};
      auto [x, y] = kEighth[random.below(5)];
      if (random.below(2) == 0) std::swap(x, y);
      return {random.below(2) == 0 ? x : -x, random.below(2) == 0 ? y : -y};
    }
    case Kind::parabola:
      return {2 * u - 1, (2 * u - 1) * (2 * u - 1)};
    case Kind::collinear:
      return i < 3 ? Point2{u, v} : Point2{random.whole(-9, 9) * 3, random.whole(-9, 9) * 0 + 7};
    case Kind::near_collinear:
      return {u, std::nextafter(u, random.whole(-1, 1) * 2)};
    case Kind::clusters:
      return {std::floor(4 * u) + 1e-6 * random.unit(), std::floor(4 * v) + 1e-6 * random.unit()};
    case Kind::far_clusters:
      return {(i % 2) * 1e15 + u, v};
    case Kind::one_cell:
      return i % 32 == 0 ? Point2{u, v} : Point2{0.3 + 1e-9 * u, 0.7 + 1e-9 * v};
    case Kind::spiral:
      return {std::exp(-60 * u) * std::cos(300 * u), std::exp(-60 * u) * std::sin(300 * u)};
    case Kind::ulps: {
      double x = 1, y = 3;
      for (std::uint32_t k = random.below(4); k > 0; --k) x = std::nextafter(x, 2);
      for (std::uint32_t k = random.below(4); k > 0; --k) y = std::nextafter(y, 4);
      return {x, y};
    }
    case Kind::utm:
      return {500000 + std::round(100 * u) / 100, 5400000 + std::round(100 * v) / 100};
    case Kind::flat_box:
      return {1e10 * u, v};
    case Kind::denormal:
      return {5e-324 * random.whole(0, 90), -5e-324 * random.whole(0, 90)};
    case Kind::huge:
      return {(2 * u - 1) * std::numeric_limits<double>::max(), (2 * v - 1) * 1e308};
    case Kind::any_exponent:
      return {std::ldexp(2 * u - 1, static_cast<int>(random.below(2090)) - 1073),
              std::ldexp(2 * v - 1, static_cast<int>(random.below(2090)) - 1073)};
    default:
      return {random.whole(-1, 1) * 0.0, random.whole(-1, 1) * (i % 3 == 0 ? 1.0 : 0.0)};
  }
}

inline std::vector<Point2> point_set(Kind kind, std::uint32_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Point2> points;
  for (std::uint32_t i = 0; i < count; ++i) points.push_back(point_of(kind, random, i));
  return points;
}

}  // namespace support
