/// CirclePlane agrees with the exact predicate, near the circle and far from it, at every exponent.
#include "order/circle_plane.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "oracle/exact_predicates.hpp"
#include "support/cloud.hpp"
#include "support/random_mesh.hpp"
#include "support/special_values.hpp"

namespace {

using support::kInfinity;
using thalweg::Point2;
using thalweg::detail::CirclePlane;

/// Whether d is inside the circle through u, v, w, which are turned counter-clockwise first, in all three
/// rotations; compared with the oracle.
void expect_agreement(Point2 u, Point2 v, Point2 w, Point2 d) {
  const int turn = oracle::orient2d(u, v, w);
  if (turn == 0) return;
  if (turn < 0) std::swap(v, w);
  const bool inside = oracle::incircle(u, v, w, d) > 0;
  EXPECT_EQ(CirclePlane(u, v, w).holds(d), inside);
  EXPECT_EQ(CirclePlane(v, w, u).holds(d), inside);
  EXPECT_EQ(CirclePlane(w, u, v).holds(d), inside);
  EXPECT_EQ(thalweg::detail::incircle_sign(u, v, w, d) > 0, inside);
}

TEST(CirclePlane, HoldsTheInsideOnly) {
  const CirclePlane circle({1, 0}, {0, 1}, {-1, 0});
  EXPECT_TRUE(circle.holds({0, 0}));
  EXPECT_TRUE(circle.holds({0.5, -0.5}));
  EXPECT_FALSE(circle.holds({0, -1}));
  EXPECT_FALSE(circle.holds({2, 0}));
  EXPECT_FALSE(circle.holds({1, 0}));
  EXPECT_FALSE(circle.holds({-1, 0}));
  EXPECT_TRUE(circle.holds({0, std::nextafter(-1.0, 0.0)}));
  EXPECT_FALSE(circle.holds({0, std::nextafter(-1.0, -2.0)}));
}

TEST(CirclePlane, SitesOnTheCircleAreNotInside) {
  const auto ring = support::integer_circle(32045);
  const auto n = ring.size();
  for (std::size_t i = 0; i < n; i += 5) {
    const CirclePlane circle(ring[i], ring[(i + 7) % n], ring[(i + n / 2) % n]);
    for (const Point2& p : ring) EXPECT_FALSE(circle.holds(p));
    for (std::size_t j = 0; j < n; j += 11) {
      const Point2 p = ring[j];
      if (p.x == 0 || j == i || j == (i + 7) % n || j == (i + n / 2) % n) continue;
      EXPECT_TRUE(circle.holds({std::nextafter(p.x, 0.0), p.y}));
      EXPECT_FALSE(circle.holds({std::nextafter(p.x, p.x * 2), p.y}));
    }
  }
}

/// Sites next to a corner of a circle whose products pass 53 bits: what the doubles give there is rounding
/// errors of the size of the circle, not of the distance.
TEST(CirclePlane, SitesNextToACorner) {
  std::vector<Point2> ring = support::integer_circle(32045);
  for (Point2& p : ring) p = {40001 * p.x - 217 * p.y, 40001 * p.y + 217 * p.x};
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (const std::size_t step : {n / 7, n / 3, n / 2}) {
      const CirclePlane circle(ring[i], ring[(i + step) % n], ring[(i + step + n / 3) % n]);
      for (const std::size_t j : {i + 1, i + 2, i + n - 1, i + n - 2}) {
        EXPECT_FALSE(circle.holds(ring[j % n])) << i << " " << step << " " << j;
      }
    }
  }
}

TEST(CirclePlane, CocircularFarFromTheOrigin) {
  const auto ring = support::integer_circle(65);
  for (const double shift : {1e6, 1e12, 0x1p46}) {
    for (std::size_t i = 0; i + 3 < ring.size(); ++i) {
      Point2 p[4];
      for (std::size_t j = 0; j < 4; ++j) p[j] = {ring[i + j].x + shift, ring[i + j].y - shift};
      expect_agreement(p[0], p[1], p[2], p[3]);
      p[3].x = std::nextafter(p[3].x, kInfinity);
      expect_agreement(p[0], p[1], p[2], p[3]);
    }
  }
}

TEST(CirclePlane, AtEveryExponent) {
  const auto ring = support::integer_circle(25);
  for (int exponent = -1074; exponent <= 1018; exponent += 9) {
    const auto at = [&](double x, double y) {
      return Point2{std::ldexp(x, exponent), std::ldexp(y, exponent)};
    };
    const CirclePlane circle(at(ring[0].x, ring[0].y), at(ring[5].x, ring[5].y), at(ring[9].x, ring[9].y));
    for (const Point2& p : ring) {
      EXPECT_FALSE(circle.holds(at(p.x, p.y))) << exponent;
      EXPECT_TRUE(circle.holds(at(p.x - (p.x > 0 ? 1 : -1), p.y - (p.y > 0 ? 1 : -1)))) << exponent;
      EXPECT_FALSE(circle.holds(at(p.x + (p.x > 0 ? 1 : -1), p.y + (p.y > 0 ? 1 : -1)))) << exponent;
    }
  }
}

/// Where the filter stops to answer: squared lengths about 2^200, and results about 2^-600.
TEST(CirclePlane, AcrossTheLimitsOfItsFilter) {
  for (int exponent = 90; exponent <= 105; ++exponent) {
    for (const int sign : {-1, 1}) {
      const double r = std::ldexp(1.0, sign * exponent * (sign < 0 ? 2 : 1));
      for (const double off : {0.0, 0x1p-52, -0x1p-52, 0x1p-20, -0x1p-20}) {
        expect_agreement({r, 0}, {0, r}, {-r, 0}, {0, -r * (1 + off)});
        expect_agreement({r, 0}, {0, r}, {-r, 0}, {r * 0.6, -0.8 * r * (1 + off)});
      }
    }
  }
}

TEST(CirclePlane, FlatTriangles) {
  // The circle of a nearly flat triangle is nearly a half-plane, and as large as its area is small.
  for (const double height : {1e-300, 1e-30, 1e-9, 0x1p-52}) {
    for (const double y : {-1.0, -1e-9, 0.0, 1e-30, 1e-9, 1.0}) {
      for (const double x : {-5.0, -1.0, 0.25, 1.0, 1e9})
        expect_agreement({-1, 0}, {1, 0}, {0, height}, {x, y});
    }
  }
}

TEST(CirclePlane, LargestDoubles) {
  constexpr double kMax = std::numeric_limits<double>::max();
  expect_agreement({kMax, 0}, {0, kMax}, {-kMax, 0}, {0, -kMax});
  expect_agreement({kMax, kMax}, {-kMax, kMax}, {-kMax, -kMax}, {kMax, -kMax});
  expect_agreement({kMax, kMax}, {-kMax, kMax}, {-kMax, -kMax}, {0, 0});
  expect_agreement({1, 0}, {0, 1}, {-1, 0}, {kMax, -kMax});
  expect_agreement({1, 0}, {0, 1}, {-1, 0}, {std::numeric_limits<double>::denorm_min(), 0});
}

rc::Gen<double> any_finite() {
  return rc::gen::map(
      rc::gen::pair(rc::gen::resize(rc::kNominalSize, rc::gen::inRange<int>(-64, 65)),
                    rc::gen::resize(rc::kNominalSize, rc::gen::inRange<int>(-1074, 1018))),
      [](const std::pair<int, int>& p) { return std::ldexp(static_cast<double>(p.first), p.second); });
}

RC_GTEST_PROP(CirclePlaneLaws, AgreesAtMixedExponents, ()) {
  const auto point = [] { return Point2{*any_finite(), *any_finite()}; };
  expect_agreement(point(), point(), point(), point());
}

RC_GTEST_PROP(CirclePlaneLaws, AgreesNearTheCircle, ()) {
  const auto ring = support::integer_circle(1105);
  const int exponent = *rc::gen::elementOf(std::vector<int>{-1070, -320, -300, -100, 0, 80, 95, 500, 1000});
  const auto pick = [&] {
    const Point2 p = ring[support::random_index(static_cast<std::uint32_t>(ring.size()))];
    return Point2{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  };
  Point2 d = pick();
  for (std::uint32_t i = support::random_index(4); i > 0; --i) d.x = std::nextafter(d.x, kInfinity);
  for (std::uint32_t i = support::random_index(4); i > 0; --i) d.y = std::nextafter(d.y, -kInfinity);
  expect_agreement(pick(), pick(), pick(), d);
}

}  // namespace
