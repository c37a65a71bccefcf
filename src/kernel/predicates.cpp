/// The public predicates, and what their inline forms call when the filter cannot tell.
#include "thalweg/predicates.hpp"

#include "kernel/predicates_inline.hpp"

namespace thalweg {

int orient2d(Point2 a, Point2 b, Point2 c) noexcept {
  return detail::orient2d_sign(a, b, c);
}

int incircle(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  return detail::incircle_sign(a, b, c, d);
}

int compare_distance(Point2 a, Point2 b, Point2 c) noexcept {
  const detail::MaybeSign sign = detail::compare_distance_filter(a, b, c);
  return sign ? *sign : detail::compare_distance_exact(a, b, c);
}

namespace detail {

namespace {

bool less(Point2 a, Point2 b) noexcept {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace

// With squared lengths lifted by e_a, e_b, e_c, e_d the determinant of rows (p.x - d.x, p.y - d.y, |p|^2 -
// |d|^2 + e_p - e_d), p = a, b, c, is linear in each e. Expanding along the last column, its change is
//
//   e_a orient2d(d,b,c) + e_b orient2d(a,d,c) + e_c orient2d(a,b,d) - e_d orient2d(a,b,c):
//
// the coefficient of a corner is the triangle with d in its place, and that of d is minus the triangle. The e
// are positive and the one of the lexicographically largest point outweighs all others, so its coefficient
// decides: d lifted is outside, a corner lifted leaves d inside iff d is on the corner's side of the opposite
// edge. Four distinct points on a circle have no three collinear, so the coefficient is not 0.
int incircle_tie(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const Point2 ab = less(a, b) ? b : a;
  const Point2 cd = less(c, d) ? d : c;
  const Point2 lifted = less(ab, cd) ? cd : ab;
  if (lifted == d) return -orient2d_sign(a, b, c);
  if (lifted == a) return orient2d_sign(d, b, c);
  if (lifted == b) return orient2d_sign(a, d, c);
  return orient2d_sign(a, b, d);
}

}  // namespace detail

}  // namespace thalweg
