/// The predicates straight from their determinants, in GMP's integers: no filter, nothing shared with src/.
///
/// Every finite double is a mantissa of 53 bits times 2^e; in the unit of the smallest such 2^e all
/// coordinates are integers, and no sign depends on the unit.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "thalweg/point.hpp"

namespace oracle {

/// The e of value = mantissa * 2^e; large for zero, which is a multiple of everything.
inline int unit_exponent(double value) {
  if (value == 0) return 2000;
  int exponent = 0;
  std::frexp(value, &exponent);
  return exponent - 53;
}

inline int common_exponent(std::initializer_list<thalweg::Point2> points) {
  int unit = 2000;
  for (const thalweg::Point2& p : points) unit = std::min({unit, unit_exponent(p.x), unit_exponent(p.y)});
  return unit;
}

inline mpz_class in_units(double value, int unit) {
  if (value == 0) return 0;
  int exponent = 0;
  const double mantissa = std::ldexp(std::frexp(value, &exponent), 53);
  return mpz_class(mpz_class(mantissa) << static_cast<mp_bitcnt_t>(exponent - 53 - unit));
}

struct ExactVector {
  mpz_class x, y;
};

/// from -> to, exactly, in units of 2^unit.
inline ExactVector exact_vector(thalweg::Point2 from, thalweg::Point2 to, int unit) {
  return {in_units(to.x, unit) - in_units(from.x, unit), in_units(to.y, unit) - in_units(from.y, unit)};
}

inline mpz_class squared(const ExactVector& v) {
  return v.x * v.x + v.y * v.y;
}

inline int orient2d(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c) {
  const int unit = common_exponent({a, b, c});
  const ExactVector u = exact_vector(a, b, unit);
  const ExactVector v = exact_vector(a, c, unit);
  return sgn(mpz_class(u.x * v.y - u.y * v.x));
}

/// The 3 x 3 determinant expanded along its first row.
inline int incircle(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c, thalweg::Point2 d) {
  const int unit = common_exponent({a, b, c, d});
  const ExactVector u = exact_vector(d, a, unit);
  const ExactVector v = exact_vector(d, b, unit);
  const ExactVector w = exact_vector(d, c, unit);
  const mpz_class v2 = squared(v);
  const mpz_class w2 = squared(w);
  return sgn(mpz_class(u.x * (v.y * w2 - v2 * w.y) - u.y * (v.x * w2 - v2 * w.x) +
                       squared(u) * (v.x * w.y - v.y * w.x)));
}

inline int compare_distance(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c) {
  const int unit = common_exponent({a, b, c});
  return sgn(mpz_class(squared(exact_vector(a, b, unit)) - squared(exact_vector(a, c, unit))));
}

/// incircle with the points really lifted: coordinates stretched by 2^60, the largest point in (x, y) lifted
/// by 2^60, the next by 2^40, then 2^20, 1. Requires integer coordinates in [0, 32]: the smallest determinant
/// that is not 0 is then far above any lift, and twice an area, below 2^11, cannot make up for the 2^20
/// between two lifts.
inline int incircle_lifted(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c, thalweg::Point2 d) {
  constexpr int kUnit = -60;
  const thalweg::Point2 points[4] = {a, b, c, d};
  mpz_class lift[4];
  for (int i = 0; i < 4; ++i) {
    mp_bitcnt_t larger = 0;
    for (const thalweg::Point2& p : points) {
      if (p.x > points[i].x || (p.x == points[i].x && p.y > points[i].y)) ++larger;
    }
    lift[i] = mpz_class(1) << (60 - 20 * larger);
  }
  mpz_class row[3][3];
  for (int i = 0; i < 3; ++i) {
    const ExactVector u = exact_vector(d, points[i], kUnit);
    row[i][0] = u.x;
    row[i][1] = u.y;
    row[i][2] = squared(u) + lift[i] - lift[3];
  }
  return sgn(mpz_class(row[0][0] * (row[1][1] * row[2][2] - row[1][2] * row[2][1]) -
                       row[0][1] * (row[1][0] * row[2][2] - row[1][2] * row[2][0]) +
                       row[0][2] * (row[1][0] * row[2][1] - row[1][1] * row[2][0])));
}

}  // namespace oracle
