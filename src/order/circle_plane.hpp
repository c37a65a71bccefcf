/// One circle, prepared for many tests of "is this site strictly inside?".
#pragma once

#include <cmath>
#include <limits>

#include "kernel/predicates_inline.hpp"
#include "thalweg/point.hpp"

namespace thalweg::detail {

/// The circle through u, v, w as a plane: lifted to the paraboloid and moved so that u is the origin, a site
/// d lies below it iff it is inside. A test costs 5 multiplications and 1 for its error bound; what that
/// leaves open, the exact predicate decides.
class CirclePlane {
 public:
  /// Requires: u, v, w counter-clockwise.
  CirclePlane(Point2 u, Point2 v, Point2 w) noexcept : u_(u), v_(v), w_(w) {
    const double vx = v.x - u.x, vy = v.y - u.y, wx = w.x - u.x, wy = w.y - u.y;
    const double v2 = vx * vx + vy * vy, w2 = wx * wx + wy * wy;
    a_ = vy * w2 - wy * v2;
    b_ = vx * w2 - wx * v2;
    c_ = vx * wy - wx * vy;
    const double reach = (std::fabs(vx) + std::fabs(vy)) + (std::fabs(wx) + std::fabs(wy));
    const double ab_size = (std::fabs(vx) + std::fabs(vy)) * w2 + (std::fabs(wx) + std::fabs(wy)) * v2;
    const double c_size = std::fabs(vx * wy) + std::fabs(wx * vy);
    const bool in_range = v2 < kRange && w2 < kRange;
    error_by_square_ = kBound * (c_size + ab_size / reach / 2);
    error_ = in_range ? kBound * (ab_size * reach / 2) + kUnderflow : std::numeric_limits<double>::infinity();
  }

  /// Whether d is strictly inside. Exact.
  bool holds(const Point2& d) const noexcept {
    const double x = d.x - u_.x, y = d.y - u_.y;
    const double d2 = x * x + y * y;
    const double det = (y * b_ - x * a_) - d2 * c_;
    if (std::fabs(det) > d2 * error_by_square_ + error_ && d2 < kRange) [[likely]]
      return det > 0;
    return incircle_sign(u_, v_, w_, d) > 0;
  }

 private:
  // incircle(u, v, w, d) expanded along the row of u is  y (vx w2 - wx v2) - x (vy w2 - wy v2) - d2 (vx wy -
  // wx vy). Error, r = 2^-53, to first order: a difference of coordinates carries r; a squared length 4 r
  // (two differences, one product, one sum). So a product in a_ or b_ carries 1 + 4 + 1 = 6 r, their
  // difference one more: 7 r; times x or y (1) and the product (1): 9 r; the two last sums: 11 r. d2 c_: 4 +
  // (2 + 1 + 1) + 1 = 9 r, the last sum: 10 r. Each relative to the size of its terms: |y| b + |x| a + d2 c,
  // with a, b, c for a_, b_, c_ with all signs positive. The first two are at most (a + b) |d|, and |d| is at
  // most (d2 / s + s) / 2 for any s > 0: least where s = |d|, so s is taken to be about the size of the
  // circle. This bound of the sizes, as computed, is low by less than 20 r. 16 r covers that and the terms of
  // higher order with room to spare.
  static constexpr double kBound = 16 * kUnitRoundoff;
  static_assert(kBound >= 11 * kUnitRoundoff * (1 + 64 * kUnitRoundoff) + 64 * kUnitRoundoff * kUnitRoundoff);
  // An operation that underflows is wrong by at most 2^-1075, and is multiplied afterwards by two lengths or
  // squared lengths, each below 2^200 where the filter may answer: in all, far less than 2^-600. Above the
  // range nothing overflows unnoticed either: the products stay below 2^603.
  static constexpr double kRange = 0x1p200;
  static constexpr double kUnderflow = 0x1p-600;

  Point2 u_, v_, w_;
  double a_, b_, c_;
  double error_by_square_, error_;
};

}  // namespace thalweg::detail
