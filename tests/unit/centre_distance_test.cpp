/// CircleCentre: which distances its filter decides, and the rounded centre.
#include "kernel/centre_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using thalweg::Point2;
using thalweg::detail::CircleCentre;
using thalweg::detail::MaybeSign;

void expect_nearer(const CircleCentre& centre, Point2 p, Point2 q, MaybeSign expected) {
  EXPECT_EQ(centre.filter(p, q), expected);
  EXPECT_EQ(centre.filter(q, p), expected ? MaybeSign(-*expected) : expected);
}

TEST(CircleCentre, FilterDecidesGeneralPosition) {
  const CircleCentre centre({0, 0}, {4, 0}, {0, 4});
  expect_nearer(centre, {2, 1}, {2, 4}, -1);
  expect_nearer(centre, {1, 2}, {5, 2}, -1);
  expect_nearer(centre, {-3, 2}, {2, 5}, 1);
}

TEST(CircleCentre, FilterAnswersNothingForEqualDistances) {
  const CircleCentre centre({0, 0}, {4, 0}, {0, 4});
  expect_nearer(centre, {1, 2}, {3, 2}, std::nullopt);
  expect_nearer(centre, {2, 5}, {2, 5}, std::nullopt);
}

/// It must not: where squared lengths are 2^200 or more, what products of small lengths lose by underflow may
/// weigh more than its bound has room for.
TEST(CircleCentre, FilterAnswersNothingBeyondItsRange) {
  for (const bool beyond : {false, true}) {
    const double far = beyond ? 0x1p100 : std::nextafter(0x1p100, 0);
    const auto decided = [&](int sign) { return beyond ? std::nullopt : MaybeSign(sign); };
    expect_nearer(CircleCentre({0, 0}, {far, 0}, {0, 1}), {far / 2, 0}, {0, -1}, decided(-1));
    expect_nearer(CircleCentre({0, 0}, {1, 0}, {0, far}), {0, far / 2}, {-1, 0}, decided(-1));
    expect_nearer(CircleCentre({0, 0}, {1, 0}, {0, 1}), {far, 0}, {0, 0}, decided(1));
    expect_nearer(CircleCentre({0, 0}, {1, 0}, {0, 1}), {0, -far}, {0, 0}, decided(1));
  }
}

/// Three sites nearly on a line, of which two are very near each other: the product that is the area rounds
/// to the least double, and the centre with it.
TEST(CircleCentre, FlatTriangleWhoseAreaUnderflows) {
  const CircleCentre centre({0, 0}, {0x1p-900, 0}, {0x1p99, 1.4 * 0x1p-174});
  const Point2 far{0, 0.85 * 0x1p372};
  EXPECT_EQ(centre.compare(far, {0, 0}), 1);
  EXPECT_EQ(centre.compare({0, 0}, far), -1);
}

TEST(CircleCentre, RoundsToTheCentre) {
  const Point2 centre = CircleCentre({10, 20}, {14, 20}, {10, 26}).rounded();
  EXPECT_DOUBLE_EQ(centre.x, 12);
  EXPECT_DOUBLE_EQ(centre.y, 23);
  const Point2 slanted = CircleCentre({5, 0}, {4, 3}, {-3, 4}).rounded();
  EXPECT_NEAR(slanted.x, 0, 1e-12);
  EXPECT_NEAR(slanted.y, 0, 1e-12);
}

}  // namespace
