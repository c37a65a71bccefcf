/// Distances to a circumcentre: the stages after the filter.
#include "kernel/centre_distance.hpp"

#include <algorithm>

#include "kernel/assert.hpp"
#include "kernel/big_integer.hpp"
#include "kernel/word_integer.hpp"

namespace thalweg::detail {

#if defined(THALWEG_HAS_INT128)

namespace {

// Coordinates below 2^61 differ by less than 2^62; squared lengths and cross products of differences are then
// below 2^125, and four products of one with the other below 2^252.
static_assert(2 * (WordScale::kBits + 1) + 1 <= 126 && 2 * (2 * (WordScale::kBits + 1) + 1) + 2 <= 254);

}  // namespace

MaybeSign compare_centre_distance_words(Point2 a, Point2 b, Point2 c, Point2 p, Point2 q) noexcept {
  const double largest =
      std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y), std::fabs(c.x),
                std::fabs(c.y), std::fabs(p.x), std::fabs(p.y), std::fabs(q.x), std::fabs(q.y)});
  WordScale to_word(largest);
  if (!to_word.exact()) return std::nullopt;
  const std::int64_t ax = to_word(a.x), ay = to_word(a.y);
  const WordVector ab{to_word(b.x) - ax, to_word(b.y) - ay}, ac{to_word(c.x) - ax, to_word(c.y) - ay};
  const WordVector ap{to_word(p.x) - ax, to_word(p.y) - ay}, aq{to_word(q.x) - ax, to_word(q.y) - ay};
  if (!to_word.exact()) return std::nullopt;
  const WordVector qp{ap.x - aq.x, ap.y - aq.y};
  const Int128 area = cross(ab, ac);
  WordSum det;
  det.add_product(squared_length(ap), area);
  det.add_product(squared_length(aq), -area);
  det.add_product(squared_length(ab), cross(ac, qp));
  det.add_product(squared_length(ac), cross(qp, ab));
  return det.sign();
}

#else

MaybeSign compare_centre_distance_words(Point2, Point2, Point2, Point2, Point2) noexcept {
  return std::nullopt;
}

#endif

int compare_centre_distance_exact(Point2 a, Point2 b, Point2 c, Point2 p, Point2 q) noexcept {
  int unit = 1024;
  for (const Point2 point : {a, b, c, p, q}) {
    unit = std::min({unit, lowest_bit(point.x, unit), lowest_bit(point.y, unit)});
  }
  struct Vector {
    BigInteger<kCoordinateLimbs + 1> x, y;
  };
  const auto vector = [unit](Point2 from, Point2 to) {
    return Vector{to_integer(to.x, unit) - to_integer(from.x, unit),
                  to_integer(to.y, unit) - to_integer(from.y, unit)};
  };
  const auto cross = [](const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; };
  const auto squared_length = [](const Vector& v) { return v.x * v.x + v.y * v.y; };
  const Vector ab = vector(a, b), ac = vector(a, c), ap = vector(a, p), aq = vector(a, q);
  const Vector qp = vector(q, p);
  return ((squared_length(ap) - squared_length(aq)) * cross(ab, ac) + squared_length(ab) * cross(ac, qp) +
          squared_length(ac) * cross(qp, ab))
      .sign();
}

int compare_centre_distance_unfiltered(Point2 a, Point2 b, Point2 c, Point2 p, Point2 q) noexcept {
  THALWEG_ASSERT(orient2d_sign(a, b, c) > 0);
  const MaybeSign sign = compare_centre_distance_words(a, b, c, p, q);
  return sign ? *sign : compare_centre_distance_exact(a, b, c, p, q);
}

}  // namespace thalweg::detail
