/// Exact geometric predicates: the only places where coordinates decide anything.
///
/// All are exact for every finite double, denormals and 1e308 included, on every IEEE 754 machine and under
/// any compiler flags of the caller; NaN and infinities are the caller's bug.
/// A filter in doubles decides nearly always; what it leaves open, integers decide, not expansions. Source of
/// the stages: J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates, Discrete & Computational Geometry 18, 1997; departures: src/kernel/predicate_stages.hpp.
#pragma once

#include "thalweg/export.hpp"
#include "thalweg/point.hpp"

namespace thalweg {

/// Side of the directed line a -> b on which c lies.
/// Returns +1 if a, b, c turn counter-clockwise, -1 if clockwise, 0 if collinear (coincident points
/// included). Laws: orient2d(b,c,a) == orient2d(a,b,c); orient2d(b,a,c) == -orient2d(a,b,c). Complexity:
/// O(1), no allocation.
THALWEG_EXPORT int orient2d(Point2 a, Point2 b, Point2 c) noexcept;

/// Position of d relative to the circle through a, b, c.
/// Returns, for a, b, c counter-clockwise, +1 if d is strictly inside, 0 if on the circle, -1 if outside; the
/// opposite sign for a, b, c clockwise. Degenerate: for a, b, c collinear the sign of the determinant, 0 if
/// two of the four coincide. Laws: invariant under rotation of (a,b,c); every swap of two of the four
/// arguments negates it. Complexity: O(1), no allocation.
THALWEG_EXPORT int incircle(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;

/// Which of b, c is nearer to a.
/// Returns -1 if |ab| < |ac|, 0 if equal, +1 if |ab| > |ac|.
/// Laws: compare_distance(a,c,b) == -compare_distance(a,b,c). Complexity: O(1), no allocation.
THALWEG_EXPORT int compare_distance(Point2 a, Point2 b, Point2 c) noexcept;

}  // namespace thalweg
