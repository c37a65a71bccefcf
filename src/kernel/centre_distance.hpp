/// Which of two points is nearer to the centre of a circle through three: a predicate of degree 4, so that a
/// circumcentre can be located among others without ever being computed.
///
/// With a as the origin, G(p) = |p|^2 [b c] + |b|^2 [c p] + |c|^2 [p b], [u v] the cross product, is the
/// power of p with respect to the circle times twice the area of a, b, c. Powers with respect to one circle
/// differ as squared distances to its centre do, so the sign of G(p) - G(q) decides; it is linear in p - q
/// but for |p|^2 - |q|^2 = (p - q) (p + q).
#pragma once

#include <cmath>

#include "kernel/predicates_inline.hpp"
#include "thalweg/point.hpp"

namespace thalweg::detail {

/// The stages after the filter; for their meaning see predicate_stages.hpp.
MaybeSign compare_centre_distance_words(Point2 a, Point2 b, Point2 c, Point2 p, Point2 q) noexcept;
int compare_centre_distance_exact(Point2 a, Point2 b, Point2 c, Point2 p, Point2 q) noexcept;
[[gnu::noinline]] int compare_centre_distance_unfiltered(Point2 a, Point2 b, Point2 c, Point2 p,
                                                         Point2 q) noexcept;

/// The centre of one circle, prepared for many comparisons of distances to it.
class CircleCentre {
 public:
  /// Requires: a, b, c counter-clockwise.
  CircleCentre(Point2 a, Point2 b, Point2 c) noexcept : a_(a), b_(b), c_(c) {
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    x_ = c2 * by - b2 * cy;
    y_ = b2 * cx - c2 * bx;
    area_ = bx * cy - by * cx;
    x_size_ = c2 * std::fabs(by) + b2 * std::fabs(cy);
    y_size_ = b2 * std::fabs(cx) + c2 * std::fabs(bx);
    area_size_ = std::fabs(bx * cy) + std::fabs(by * cx);
    in_range_ = b2 < kRange && c2 < kRange;
  }

  /// Returns -1 if p is nearer to the centre than q, 0 if both are equally far, +1 if q is nearer.
  /// Laws: compare(q, p) == -compare(p, q). Exact.
  int compare(Point2 p, Point2 q) const noexcept {
    const MaybeSign sign = filter(p, q);
    return sign ? *sign : compare_centre_distance_unfiltered(a_, b_, c_, p, q);
  }

  /// The first stage of `compare`.
  MaybeSign filter(Point2 p, Point2 q) const noexcept {
    const double dx = p.x - q.x, dy = p.y - q.y;
    const double px = p.x - a_.x, py = p.y - a_.y, qx = q.x - a_.x, qy = q.y - a_.y;
    const double det = (dx * (px + qx) + dy * (py + qy)) * area_ + (dx * x_ + dy * y_);
    const double size =
        (std::fabs(dx) * (std::fabs(px) + std::fabs(qx)) + std::fabs(dy) * (std::fabs(py) + std::fabs(qy))) *
            area_size_ +
        (std::fabs(dx) * x_size_ + std::fabs(dy) * y_size_);
    const bool in_range = in_range_ && px * px + py * py < kRange && qx * qx + qy * qy < kRange;
    if (std::fabs(det) > kBound * size + kUnderflow && in_range) return sign_of(det);
    return std::nullopt;
  }

  /// The centre in doubles, for a first guess only: infinite or NaN where it overflows.
  Point2 rounded() const noexcept { return {a_.x - x_ / (2 * area_), a_.y - y_ / (2 * area_)}; }

 private:
  // Errors to first order, r = 2^-53, relative to the sum of the sizes of all terms. A difference of
  // coordinates carries r, a squared length 4 r, so x_ and y_ (4 + 1 + 1, difference) 7 r and dx x_ + dy y_
  // (7 + 1 + 1, sum) 10 r. The area carries 4 r, p + q 2 r, dx (p + q) 4 r, the sum of two 5 r, times the
  // area 10 r. The last sum: 11 r. `size` is itself low by at most 11 r, which the slack of 5 r covers with
  // the terms of higher order.
  static constexpr double kBound = 16 * kUnitRoundoff;
  static_assert(kBound >= 11 * kUnitRoundoff * (1 + 64 * kUnitRoundoff) + 64 * kUnitRoundoff * kUnitRoundoff);
  // As in order/circle_plane.hpp: an operation that underflows is wrong by at most 2^-1075 and is multiplied
  // by at most three lengths, each below 2^101 where the filter may answer: far less than 2^-600.
  static constexpr double kRange = 0x1p200;
  static constexpr double kUnderflow = 0x1p-600;

  Point2 a_, b_, c_;
  double x_, y_, area_;
  double x_size_, y_size_, area_size_;
  bool in_range_;
};

}  // namespace thalweg::detail
