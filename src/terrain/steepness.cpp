/// Which of two descents is the steeper one: a filter in doubles, then integers that hold every bit.
#include <algorithm>
#include <cmath>

#include "kernel/big_integer.hpp"
#include "kernel/numbers.hpp"
#include "thalweg/drainage.hpp"

namespace thalweg {
namespace {

using detail::kUnitRoundoff;
using detail::lowest_bit;
using detail::to_integer;

// The sides are fall(a)^2 dist(b)^2 and fall(b)^2 dist(a)^2. Relative errors to first order, r = 2^-53: a
// difference of coordinates r, its square 3 r, a sum of two squares 4 r, their product with a squared fall 3
// r + 4 r + r = 8 r. The difference of the two sides, each of them positive, is then wrong by at most 8 r
// times their sum, and r more for its own rounding; the sum as computed is low by at most 9 r of itself.
constexpr double kBound = 16 * kUnitRoundoff;
static_assert(kBound >= 9 * kUnitRoundoff * (1 + 64 * kUnitRoundoff));
// Where each factor is in this range no product leaves that of normal doubles, and a square that underflows
// beside it is nothing.
constexpr double kLeast = 0x1p-400, kMost = 0x1p400;

bool in_range(double square) noexcept {
  return square > kLeast && square < kMost;
}

/// fall^2 and dist^2 of one descent, in units whose ratio is the same for both.
auto exact_squares(Point3 from, Point3 to, int xy_unit, int z_unit) noexcept {
  const auto x = to_integer(to.x, xy_unit) - to_integer(from.x, xy_unit);
  const auto y = to_integer(to.y, xy_unit) - to_integer(from.y, xy_unit);
  const auto z = to_integer(from.z, z_unit) - to_integer(to.z, z_unit);
  struct Squares {
    decltype(z * z) fall;
    decltype(x * x + y * y) distance;
  };
  return Squares{z * z, x * x + y * y};
}

int compare_exact(Point3 from, Point3 a, Point3 b) noexcept {
  int xy_unit = 1024, z_unit = 1024;
  for (const Point3& p : {from, a, b}) {
    xy_unit = std::min({xy_unit, lowest_bit(p.x, xy_unit), lowest_bit(p.y, xy_unit)});
    z_unit = std::min(z_unit, lowest_bit(p.z, z_unit));
  }
  const auto to_a = exact_squares(from, a, xy_unit, z_unit), to_b = exact_squares(from, b, xy_unit, z_unit);
  return (to_a.fall * to_b.distance - to_b.fall * to_a.distance).sign();
}

}  // namespace

int compare_steepness(Point3 from, Point3 a, Point3 b) noexcept {
  const double ax = a.x - from.x, ay = a.y - from.y, az = from.z - a.z;
  const double bx = b.x - from.x, by = b.y - from.y, bz = from.z - b.z;
  const double fall_a = az * az, fall_b = bz * bz;
  const double distance_a = ax * ax + ay * ay, distance_b = bx * bx + by * by;
  const double left = fall_a * distance_b, right = fall_b * distance_a;
  const bool answers = in_range(fall_a) && in_range(fall_b) && in_range(distance_a) && in_range(distance_b) &&
                       std::fabs(left - right) > kBound * (left + right);
  return answers ? detail::sign_of(left - right) : compare_exact(from, a, b);
}

}  // namespace thalweg
