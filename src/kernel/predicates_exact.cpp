/// The last stage of the predicates: integers of a few thousand bits, exact for every finite double.
#include <algorithm>
#include <array>

#include "kernel/big_integer.hpp"
#include "kernel/predicate_stages.hpp"

namespace thalweg::detail {

namespace {

/// The largest power of two of which all coordinates are multiples. Signs do not depend on the unit.
template <class... Points>
int common_unit(Points... points) noexcept {
  constexpr int kAboveAll = 1024;
  const int unit = std::min({lowest_bit(points.x, kAboveAll)..., lowest_bit(points.y, kAboveAll)...});
  return unit;
}

struct BigVector {
  BigInteger<kCoordinateLimbs + 1> x, y;
};

/// from -> to in the given unit.
BigVector big_vector(Point2 from, Point2 to, int unit) noexcept {
  return {to_integer(to.x, unit) - to_integer(from.x, unit),
          to_integer(to.y, unit) - to_integer(from.y, unit)};
}

auto cross(const BigVector& u, const BigVector& v) noexcept {
  return u.x * v.y - u.y * v.x;
}

auto squared_length(const BigVector& v) noexcept {
  return v.x * v.x + v.y * v.y;
}

}  // namespace

int orient2d_exact(Point2 a, Point2 b, Point2 c) noexcept {
  const int unit = common_unit(a, b, c);
  return cross(big_vector(c, a, unit), big_vector(c, b, unit)).sign();
}

int incircle_exact(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const int unit = common_unit(a, b, c, d);
  const BigVector u = big_vector(d, a, unit);
  const BigVector v = big_vector(d, b, unit);
  const BigVector w = big_vector(d, c, unit);
  return (squared_length(u) * cross(v, w) + squared_length(v) * cross(w, u) + squared_length(w) * cross(u, v))
      .sign();
}

int compare_distance_exact(Point2 a, Point2 b, Point2 c) noexcept {
  const int unit = common_unit(a, b, c);
  return (squared_length(big_vector(a, b, unit)) - squared_length(big_vector(a, c, unit))).sign();
}

}  // namespace thalweg::detail
