/// The predicates for our own inner loops: the cheap filter inline, everything else an out-of-line call.
/// Internal: a consumer's flags must never compile this file, so no public header includes it.
///
/// Notation of the bounds: u = 2^-53; t(n) is any product of n factors 1 + e or 1 / (1 + e) with |e| <= u,
/// minus 1, so that |t(n)| <= n u + n^2 u^2. Each operation adds one factor to n; sums and differences are
/// exact where they underflow, and a product that underflows has an absolute error of at most 2^-1075
/// instead. A fused multiply-add, should a compiler insist on it, leaves out a rounding and so cannot break a
/// bound. Overflow makes the bound infinite or NaN, and NaN coordinates make it NaN: the comparison is then
/// false and the filter answers nothing.
#pragma once

#include <cmath>

#include "kernel/numbers.hpp"
#include "kernel/predicate_stages.hpp"
#include "thalweg/point.hpp"

namespace thalweg::detail {

/// Added to every bound, so that the filters need no test of their range. Underflow moves orient2d by at most
/// 2 errors of 2^-1075 and a squared distance by 4; it moves incircle, with S the sum of the three squared
/// lengths, by at most 12 S errors (six sums of products, each times something <= S) and 6 more: 18 of them
/// if S < 1, and if S >= 1 less than 18 * 2^-1075 S^2, which is lost in the slack of kIncircleBound, u S^2
/// / 4.
inline constexpr double kUnderflowMargin = 0x1p-1000;
static_assert(kUnderflowMargin > 1024 * 18 * 0x1p-1074);

/// Each product: two differences and itself, t(3). The last difference has the sign of what it rounds, so it
/// suffices that |left - right| > 3u (|left| + |right|) before it is rounded. The rounding of that
/// difference, of the bound (a sum, a product, a sum) and of the products inside it (they appear as computed,
/// t(3) larger) makes 3u + 24u^2.
inline constexpr double kOrient2dBound = (3 + 32 * kUnitRoundoff) * kUnitRoundoff;
static_assert(kOrient2dBound >= 3 * kUnitRoundoff + 25 * kUnitRoundoff * kUnitRoundoff);

/// A squared length: difference twice, product, sum, t(4); as above 4u, and with its second-order terms 4u +
/// 38u^2.
inline constexpr double kDistanceBound = (4 + 64 * kUnitRoundoff) * kUnitRoundoff;
static_assert(kDistanceBound >= 4 * kUnitRoundoff + 40 * kUnitRoundoff * kUnitRoundoff);

/// A squared length has t(4), a minor t(4) against the sum of its products' magnitudes, their product one
/// more, the two sums of the terms two more: t(11) against P = sum over the corners of a2 (|bx cy| + |by
/// cx|). Now |bx cy| + |by cx| <= |b||c| <= (b2 + c2) / 2 and so P <= a2 b2 + b2 c2 + c2 a2 <= S^2 / 3, S =
/// a2 + b2 + c2: the error is at most 11/3 u S^2 to first order. The computed S^2 times the constant plus the
/// margin carries t(15): 11/3 u (1 + 20u).
inline constexpr double kIncircleBound = 4 * kUnitRoundoff;
static_assert(kIncircleBound - kUnitRoundoff / 4 >= 11.0 / 3 * (1 + 64 * kUnitRoundoff) * kUnitRoundoff);

inline MaybeSign orient2d_filter(Point2 a, Point2 b, Point2 c) noexcept {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = kOrient2dBound * (std::fabs(left) + std::fabs(right)) + kUnderflowMargin;
  if (std::fabs(det) > bound) return sign_of(det);
  return std::nullopt;
}

/// The determinant of incircle as doubles give it, and the sum of the squared distances from d.
struct RoundedCircle {
  double det;
  double size;
};

inline RoundedCircle rounded_circle(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double a2 = ax * ax + ay * ay;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double det = a2 * (bx * cy - by * cx) + b2 * (cx * ay - cy * ax) + c2 * (ax * by - ay * bx);
  return {det, a2 + b2 + c2};
}

inline MaybeSign incircle_filter(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const auto [det, size] = rounded_circle(a, b, c, d);
  if (std::fabs(det) > kIncircleBound * (size * size) + kUnderflowMargin) return sign_of(det);
  return std::nullopt;
}

inline MaybeSign compare_distance_filter(Point2 a, Point2 b, Point2 c) noexcept {
  const double bx = b.x - a.x, by = b.y - a.y;
  const double cx = c.x - a.x, cy = c.y - a.y;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double difference = b2 - c2;
  if (std::fabs(difference) > kDistanceBound * (b2 + c2) + kUnderflowMargin) return sign_of(difference);
  return std::nullopt;
}

/// The predicate by the stages after the filter. Never inlined, even next to their bodies: g++ would spill
/// the points to memory in halves on the way to the filter and read them back whole, a stall of some 15
/// cycles on the fast path.
[[gnu::noinline]] int orient2d_unfiltered(Point2 a, Point2 b, Point2 c) noexcept;
[[gnu::noinline]] int incircle_unfiltered(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;
[[gnu::noinline]] int compare_distance_unfiltered(Point2 a, Point2 b, Point2 c) noexcept;

inline int orient2d_sign(Point2 a, Point2 b, Point2 c) noexcept {
  const MaybeSign sign = orient2d_filter(a, b, c);
  return sign ? *sign : orient2d_unfiltered(a, b, c);
}

inline int incircle_sign(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const MaybeSign sign = incircle_filter(a, b, c, d);
  return sign ? *sign : incircle_unfiltered(a, b, c, d);
}

inline int compare_distance_sign(Point2 a, Point2 b, Point2 c) noexcept {
  const MaybeSign sign = compare_distance_filter(a, b, c);
  return sign ? *sign : compare_distance_unfiltered(a, b, c);
}

/// The sign of the perturbed determinant of four points whose incircle is 0; see `incircle_canonical`.
int incircle_tie(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;

/// incircle after the symbolic perturbation that makes the Delaunay triangulation unique: the larger a site
/// in (x, y), lexicographically, the higher it is lifted above the paraboloid, beyond all comparison. Returns
/// as incircle, but 0 only if two of the points coincide or all four are on one line. Laws: as incircle;
/// depends on coordinates alone; -0.0 and 0.0 are equal.
inline int incircle_canonical(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const int sign = incircle_sign(a, b, c, d);
  return sign != 0 ? sign : incircle_tie(a, b, c, d);
}

}  // namespace thalweg::detail
