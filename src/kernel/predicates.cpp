/// The public predicates and the stages between the filter and the big integers.
#include "thalweg/predicates.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/assert.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/word_integer.hpp"

namespace thalweg {

int orient2d(Point2 a, Point2 b, Point2 c) noexcept {
  return detail::orient2d_sign(a, b, c);
}

int incircle(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  return detail::incircle_sign(a, b, c, d);
}

int compare_distance(Point2 a, Point2 b, Point2 c) noexcept {
  return detail::compare_distance_sign(a, b, c);
}

namespace detail {

namespace {

template <class... Points>
[[maybe_unused]] bool finite(Points... points) noexcept {
  return (... && (std::isfinite(points.x) && std::isfinite(points.y)));
}

bool less(Point2 a, Point2 b) noexcept {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

#if defined(THALWEG_HAS_INT128)

template <class... Doubles>
double largest_magnitude(double first, Doubles... others) noexcept {
  double largest = std::fabs(first);
  ((largest = std::max(largest, std::fabs(others))), ...);
  return largest;
}

// Coordinates below 2^61 differ by less than 2^62; squared lengths and cross products of differences are then
// below 2^125, and three products of one with the other below 2^252.
static_assert(2 * (WordScale::kBits + 1) + 1 <= 126 && 2 * (2 * (WordScale::kBits + 1) + 1) + 2 <= 254);

#endif

// The filter's bound of 11u P, with P itself in place of S^2 / 3, which is far more where d is close to a
// corner but not to all: long thin triangles on a curve. P as computed may be low by t(11), and the bound by
// two more: 11u (1 + 16u). Underflow moves the determinant by 12 S errors of 2^-1075 and 6 more (see
// kUnderflowMargin), and P by no more: with S < 2^70 both are lost in the margin.
MaybeSign beyond_products(const RoundedCircle& circle, Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  constexpr double kBound = 12 * kUnitRoundoff;
  static_assert(kBound >= 11 * kUnitRoundoff * (1 + 64 * kUnitRoundoff));
  if (!(circle.size < 0x1p70)) return std::nullopt;
  const double ax = std::fabs(a.x - d.x), ay = std::fabs(a.y - d.y);
  const double bx = std::fabs(b.x - d.x), by = std::fabs(b.y - d.y);
  const double cx = std::fabs(c.x - d.x), cy = std::fabs(c.y - d.y);
  const double products = (ax * ax + ay * ay) * (bx * cy + by * cx) +
                          (bx * bx + by * by) * (cx * ay + cy * ax) +
                          (cx * cx + cy * cy) * (ax * by + ay * bx);
  if (std::fabs(circle.det) > kBound * products + kUnderflowMargin) return sign_of(circle.det);
  return std::nullopt;
}

// If every coordinate is a multiple of g and S, the sum of squared distances from d, is at most 2^25.5 g^2,
// then nothing in rounded_circle is rounded: differences are multiples of g, squares and minors of g^2, terms
// of g^4, and no intermediate exceeds S^2 <= 2^51 g^4. A computed S below 2^(e+1) suffices if 2 (e + 1) <= 51
// + 4 log2 g: the two bits left under 2^53 cover what S itself may have been rounded by. Adding 2^52 g to a
// magnitude rounds it to a multiple of g, or of more: if it comes back unchanged, it is one. (With a sign, a
// sum below 2^52 g would be rounded to multiples of g / 2.) Range: exponents of S within +-400 keep every
// power used here normal.
MaybeSign on_grid(const RoundedCircle& circle, Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const int e = exponent_of(circle.size);
  if (e < -400 || e > 400) return std::nullopt;
  constexpr int kPositive = 1024;  // keeps the shift, which rounds down, off negative numbers
  const int grid = ((2 * e + 2 - 51 + 3 + 4 * kPositive) >> 2) - kPositive;
  const double magic = power_of_two(grid + 52);
  const auto multiple =
      [magic](double value) -> int {  // not bool: the tests below are joined without branches
    const double magnitude = std::fabs(value);
    return (magnitude + magic) - magic == magnitude;
  };
  const auto multiples = [multiple](Point2 p) { return multiple(p.x) & multiple(p.y); };
  if (multiples(a) & multiples(b) & multiples(c) & multiples(d)) return sign_of(circle.det);
  return std::nullopt;
}

}  // namespace

MaybeSign incircle_products(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  return beyond_products(rounded_circle(a, b, c, d), a, b, c, d);
}

MaybeSign incircle_grid(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  return on_grid(rounded_circle(a, b, c, d), a, b, c, d);
}

#if defined(THALWEG_HAS_INT128)

// The sign does not change if x and y are scaled by different factors.
MaybeSign orient2d_words(Point2 a, Point2 b, Point2 c) noexcept {
  WordScale x(largest_magnitude(a.x, b.x, c.x));
  WordScale y(largest_magnitude(a.y, b.y, c.y));
  if (!x.exact() || !y.exact()) return std::nullopt;
  const WordVector p{x(a.x), y(a.y)}, q{x(b.x), y(b.y)}, r{x(c.x), y(c.y)};
  if (!x.exact() || !y.exact()) return std::nullopt;
  const Int128 det = cross({p.x - r.x, p.y - r.y}, {q.x - r.x, q.y - r.y});
  return static_cast<int>(det > 0) - static_cast<int>(det < 0);
}

MaybeSign incircle_words(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  WordScale to_word(largest_magnitude(a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y));
  if (!to_word.exact()) return std::nullopt;
  const WordVector p{to_word(a.x), to_word(a.y)}, q{to_word(b.x), to_word(b.y)};
  const WordVector r{to_word(c.x), to_word(c.y)}, s{to_word(d.x), to_word(d.y)};
  if (!to_word.exact()) return std::nullopt;
  const WordVector u{p.x - s.x, p.y - s.y}, v{q.x - s.x, q.y - s.y}, w{r.x - s.x, r.y - s.y};
  WordSum det;
  det.add_product(squared_length(u), cross(v, w));
  det.add_product(squared_length(v), cross(w, u));
  det.add_product(squared_length(w), cross(u, v));
  return det.sign();
}

MaybeSign compare_distance_words(Point2 a, Point2 b, Point2 c) noexcept {
  WordScale to_word(largest_magnitude(a.x, a.y, b.x, b.y, c.x, c.y));
  if (!to_word.exact()) return std::nullopt;
  const WordVector p{to_word(a.x), to_word(a.y)}, q{to_word(b.x), to_word(b.y)},
      r{to_word(c.x), to_word(c.y)};
  if (!to_word.exact()) return std::nullopt;
  const Uint128 near = squared_length({q.x - p.x, q.y - p.y});
  const Uint128 far = squared_length({r.x - p.x, r.y - p.y});
  return static_cast<int>(near > far) - static_cast<int>(near < far);
}

#else

MaybeSign orient2d_words(Point2, Point2, Point2) noexcept {
  return std::nullopt;
}
MaybeSign incircle_words(Point2, Point2, Point2, Point2) noexcept {
  return std::nullopt;
}
MaybeSign compare_distance_words(Point2, Point2, Point2) noexcept {
  return std::nullopt;
}

#endif

int orient2d_unfiltered(Point2 a, Point2 b, Point2 c) noexcept {
  THALWEG_ASSERT(finite(a, b, c));
  const MaybeSign sign = orient2d_words(a, b, c);
  return sign ? *sign : orient2d_exact(a, b, c);
}

// Products say nothing about 0, which points of a lattice on one circle give.
int incircle_unfiltered(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  THALWEG_ASSERT(finite(a, b, c, d));
  const RoundedCircle circle = rounded_circle(a, b, c, d);
  if (circle.det != 0) {
    if (const MaybeSign sign = beyond_products(circle, a, b, c, d)) return *sign;
  }
  if (const MaybeSign sign = on_grid(circle, a, b, c, d)) return *sign;
  const MaybeSign sign = incircle_words(a, b, c, d);
  return sign ? *sign : incircle_exact(a, b, c, d);
}

int compare_distance_unfiltered(Point2 a, Point2 b, Point2 c) noexcept {
  THALWEG_ASSERT(finite(a, b, c));
  const MaybeSign sign = compare_distance_words(a, b, c);
  return sign ? *sign : compare_distance_exact(a, b, c);
}

// With squared lengths lifted by e_a, e_b, e_c, e_d the determinant of the rows (p.x - d.x, p.y - d.y,
// |p - d|^2 + e_p - e_d), p = a, b, c, is linear in each e. Expanding along the last column, it changes by
//
//   e_a orient2d(d,b,c) + e_b orient2d(a,d,c) + e_c orient2d(a,b,d) - e_d orient2d(a,b,c):
//
// the coefficient of a corner is the triangle with d in its place, that of d is minus the triangle. The e are
// positive and that of the lexicographically largest point outweighs the others, so its coefficient decides:
// a lifted d is outside; a lifted corner leaves d inside iff d is on the corner's side of the opposite edge.
// Four distinct points on a circle have no three collinear, so the coefficient is not 0. If two points
// coincide, so do their lifts, and the determinant has two equal rows.
int incircle_tie(Point2 a, Point2 b, Point2 c, Point2 d) noexcept {
  const Point2 ab = less(a, b) ? b : a;
  const Point2 cd = less(c, d) ? d : c;
  const Point2 lifted = less(ab, cd) ? cd : ab;
  if ((a == lifted) + (b == lifted) + (c == lifted) + (d == lifted) > 1) return 0;
  if (lifted == d) return -orient2d_sign(a, b, c);
  if (lifted == a) return orient2d_sign(d, b, c);
  if (lifted == b) return orient2d_sign(a, d, c);
  return orient2d_sign(a, b, d);
}

}  // namespace detail

}  // namespace thalweg
