/// The predicates for our own inner loops: the cheap filter inline, everything else an out-of-line call.
/// Internal: a consumer's flags must never compile this file, so no public header includes it.
///
/// In the bounds below u = 2^-53 is the largest relative error of one operation, and an operation whose
/// result underflows has an absolute error of at most 2^-1075 instead (sums and differences never: they are
/// exact there). Fused multiply-add, should a compiler insist on it, leaves out roundings and so cannot break
/// a bound.
#pragma once

#include <cfloat>
#include <cmath>

#include "kernel/predicate_stages.hpp"
#include "thalweg/point.hpp"

#if defined(__FAST_MATH__)
#error "thalweg needs IEEE 754 arithmetic: compile without -ffast-math"
#endif
#if FLT_EVAL_METHOD != 0
#error "thalweg needs double arithmetic without excess precision: on x86-32 compile with -msse2 -mfpmath=sse"
#endif

namespace thalweg::detail {

inline constexpr double kUnitRoundoff = 0x1p-53;

/// What underflow can add to a determinant, with room to spare: see each filter.
inline constexpr double kUnderflowMargin = 0x1p-1000;

inline constexpr double kOrient2dBound = (3 + 32 * kUnitRoundoff) * kUnitRoundoff;
inline constexpr double kIncircleBound = 4 * kUnitRoundoff;
inline constexpr double kDistanceBound = 6 * kUnitRoundoff;

inline int sign_of(double value) noexcept {
  return static_cast<int>(value > 0) - static_cast<int>(value < 0);
}

inline MaybeSign orient2d_filter(Point2 a, Point2 b, Point2 c) noexcept {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = kOrient2dBound * (std::fabs(left) + std::fabs(right)) + kUnderflowMargin;
  if (std::fabs(det) > bound) return sign_of(det);
  return std::nullopt;
}

inline MaybeSign incircle_filter(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const double ax = a.x - d.x, ay = a.y - d.y;
  const double bx = b.x - d.x, by = b.y - d.y;
  const double cx = c.x - d.x, cy = c.y - d.y;
  const double a2 = ax * ax + ay * ay;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double det = a2 * (bx * cy - by * cx) + b2 * (cx * ay - cy * ax) + c2 * (ax * by - ay * bx);
  const double size = a2 + b2 + c2;
  if (std::fabs(det) > kIncircleBound * (size * size) + kUnderflowMargin) return sign_of(det);
  return std::nullopt;
}

inline MaybeSign compare_distance_filter(Point2 a, Point2 b, Point2 c) noexcept {
  const double bx = b.x - a.x, by = b.y - a.y;
  const double cx = c.x - a.x, cy = c.y - a.y;
  const double b2 = bx * bx + by * by;
  const double c2 = cx * cx + cy * cy;
  const double det = b2 - c2;
  if (std::fabs(det) > kDistanceBound * (b2 + c2) + kUnderflowMargin) return sign_of(det);
  return std::nullopt;
}

inline int orient2d_sign(Point2 a, Point2 b, Point2 c) noexcept {
  const MaybeSign sign = orient2d_filter(a, b, c);
  return sign ? *sign : orient2d_exact(a, b, c);
}

inline int incircle_sign(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const MaybeSign sign = incircle_filter(a, b, c, d);
  return sign ? *sign : incircle_exact(a, b, c, d);
}

/// The sign of the perturbed determinant of four points whose incircle is 0.
int incircle_tie(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;

/// incircle after the symbolic perturbation that makes the Delaunay triangulation unique: the larger a site
/// in (x, y), lexicographically, the higher it is lifted above the paraboloid, beyond all comparison. Returns
/// as incircle, but 0 only if two of the points coincide or three or more of them are collinear. Laws: as
/// incircle; depends on coordinates alone; -0.0 and 0.0 are equal.
inline int incircle_canonical(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const int sign = incircle_sign(a, b, c, d);
  return sign != 0 ? sign : incircle_tie(a, b, c, d);
}

}  // namespace thalweg::detail
