/// Orient2d, Incircle, CompareDistance: contract, degenerate cases, the whole range of doubles; and which
/// stage decides.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "kernel/big_integer.hpp"
#include "kernel/predicates_inline.hpp"
#include "kernel/wide_multiply.hpp"
#include "oracle/exact_predicates.hpp"
#include "support/cloud.hpp"
#include "support/special_values.hpp"
#include "thalweg/predicates.hpp"

namespace {

using support::kInfinity;
using thalweg::compare_distance;
using thalweg::incircle;
using thalweg::orient2d;
using thalweg::Point2;
using thalweg::detail::incircle_canonical;
using thalweg::detail::MaybeSign;

constexpr double kMin = std::numeric_limits<double>::denorm_min();
constexpr double kMax = std::numeric_limits<double>::max();

double up(double value) {
  return std::nextafter(value, kInfinity);
}
double down(double value) {
  return std::nextafter(value, -kInfinity);
}

void expect_orient2d(int sign, Point2 a, Point2 b, Point2 c) {
  EXPECT_EQ(orient2d(a, b, c), sign);
  EXPECT_EQ(orient2d(b, c, a), sign);
  EXPECT_EQ(orient2d(c, a, b), sign);
  EXPECT_EQ(orient2d(b, a, c), -sign);
  EXPECT_EQ(orient2d(a, c, b), -sign);
  EXPECT_EQ(orient2d(c, b, a), -sign);
  EXPECT_EQ(oracle::orient2d(a, b, c), sign);
}

/// All 24 orders of the arguments.
void expect_incircle(int sign, Point2 a, Point2 b, Point2 c, Point2 d) {
  const std::array<Point2, 4> p = {a, b, c, d};
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  do {
    int inversions = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) inversions += order[i] > order[j];
    }
    const int expected = inversions % 2 == 0 ? sign : -sign;
    EXPECT_EQ(incircle(p[order[0]], p[order[1]], p[order[2]], p[order[3]]), expected);
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(oracle::incircle(a, b, c, d), sign);
}

void expect_distance(int sign, Point2 a, Point2 b, Point2 c) {
  EXPECT_EQ(compare_distance(a, b, c), sign);
  EXPECT_EQ(compare_distance(a, c, b), -sign);
  EXPECT_EQ(oracle::compare_distance(a, b, c), sign);
}

TEST(Orient2d, PositiveForLeftTurn) {
  expect_orient2d(1, {0, 0}, {1, 0}, {0, 1});
}

TEST(Orient2d, ZeroWhenCollinear) {
  expect_orient2d(0, {0, 0}, {1, 1}, {3, 3});
  expect_orient2d(0, {-7, 2}, {-4, 4}, {2, 8});
  expect_orient2d(0, {0.5, 0.5}, {12, 12}, {24, 24});
}

TEST(Orient2d, ZeroWhenPointsCoincide) {
  expect_orient2d(0, {0.1, 0.2}, {0.1, 0.2}, {3, 4});
  expect_orient2d(0, {0.1, 0.2}, {0.1, 0.2}, {0.1, 0.2});
  expect_orient2d(0, {0, 0}, {0, 0}, {0, 0});
}

TEST(Orient2d, SeesOneUlpOffTheLine) {
  expect_orient2d(1, {12, 12}, {24, 24}, {0.5, up(0.5)});
  expect_orient2d(-1, {12, 12}, {24, 24}, {0.5, down(0.5)});
  expect_orient2d(1, {0, 0}, {1e8, 1e8}, {0.5, up(0.5)});
}

TEST(Orient2d, DecimalFractionsAreTheDoublesTheyReadAs) {
  // 0.1, 0.2, 0.3 with 0.1, 0.2, 0.3 is the diagonal; 0.3 with 0.1 + 0.2 is not.
  expect_orient2d(0, {0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3});
  expect_orient2d(1, {0.1, 0.1}, {0.2, 0.2}, {0.3, 0.1 + 0.2});
}

TEST(Orient2d, NegativeZeroIsZero) {
  expect_orient2d(0, {0.0, 0.0}, {-0.0, -0.0}, {1, 2});
  expect_orient2d(0, {-0.0, 0.0}, {0.0, 1}, {-0.0, 7});
  expect_orient2d(1, {-0.0, -0.0}, {kMin, 0.0}, {0.0, kMin});
}

TEST(Orient2d, ExactAmongDenormals) {
  expect_orient2d(1, {0, 0}, {kMin, 0}, {0, kMin});
  expect_orient2d(0, {0, 0}, {kMin, kMin}, {2 * kMin, 2 * kMin});
  expect_orient2d(-1, {0, 0}, {3 * kMin, 5 * kMin}, {2 * kMin, 3 * kMin});
}

TEST(Orient2d, ExactAtTheLargestDoubles) {
  expect_orient2d(1, {-kMax, -kMax}, {kMax, -kMax}, {kMax, kMax});
  expect_orient2d(0, {-kMax, -kMax}, {0, 0}, {kMax, kMax});
  expect_orient2d(1, {-kMax, -kMax}, {0, 0}, {down(kMax), kMax});
  expect_orient2d(1, {-kMax, -kMax}, {kMax, kMax}, {0, kMin});
}

TEST(Orient2d, ExactAcrossTheWholeRangeInOneCall) {
  expect_orient2d(1, {0, 0}, {1e308, 1e-320}, {1e-320, 1e308});
  expect_orient2d(1, {1e-320, 0}, {0, 1e-320}, {-1e308, -1e308});
  expect_orient2d(1, {1e308, 1e308}, {1e308, kMin}, {up(1e308), 1});
  expect_orient2d(-1, {0, 0}, {1e300, 1e-300}, {1e290, 0});
}

TEST(Incircle, PositiveInsideTheCounterclockwiseCircle) {
  expect_incircle(1, {0, 0}, {1, 0}, {0, 1}, {0.5, 0.5});
  expect_incircle(-1, {0, 0}, {1, 0}, {0, 1}, {2, 2});
}

TEST(Incircle, ZeroWhenCocircular) {
  expect_incircle(0, {0, 0}, {1, 0}, {1, 1}, {0, 1});
  expect_incircle(0, {25, 0}, {7, 24}, {-20, 15}, {15, -20});
  expect_incircle(0, {500000.01, 4400000.02}, {500003.07, 4400000.02}, {500003.07, 4400003.05},
                  {500000.01, 4400003.05});
}

TEST(Incircle, ZeroWhenTwoOfTheFourCoincide) {
  expect_incircle(0, {0.1, 0.7}, {0.1, 0.7}, {3, 4}, {5, 0.6});
  expect_incircle(0, {0.1, 0.7}, {3, 4}, {5, 0.6}, {5, 0.6});
  expect_incircle(0, {1, 1}, {1, 1}, {1, 1}, {1, 1});
}

TEST(Incircle, SignOfTheDeterminantWhenThreeAreCollinear) {
  expect_incircle(0, {0, 0}, {1, 1}, {2, 2}, {5, 5});
  expect_incircle(1, {0, 0}, {1, 0}, {2, 0}, {1, 1});
  expect_incircle(-1, {0, 0}, {1, 0}, {2, 0}, {1, -1});
}

TEST(Incircle, SeesOneUlpOffTheCircle) {
  expect_incircle(1, {0, 0}, {1, 0}, {1, 1}, {0, down(1)});
  expect_incircle(-1, {0, 0}, {1, 0}, {1, 1}, {0, up(1)});
  expect_incircle(-1, {0, 0}, {1, 0}, {1, 1}, {-kMin, 1});
  expect_incircle(1, {0, 0}, {1, 0}, {1, 1}, {kMin, 1});
}

TEST(Incircle, NegativeZeroIsZero) {
  expect_incircle(0, {-0.0, 0.0}, {1, -0.0}, {1, 1}, {0.0, 1});
  expect_incircle(0, {0.0, -0.0}, {-0.0, 0.0}, {1, 2}, {3, 1});
}

TEST(Incircle, ExactAmongDenormals) {
  expect_incircle(0, {0, 0}, {kMin, 0}, {kMin, kMin}, {0, kMin});
  expect_incircle(1, {0, 0}, {4 * kMin, 0}, {4 * kMin, 4 * kMin}, {kMin, 3 * kMin});
  expect_incircle(-1, {0, 0}, {4 * kMin, 0}, {4 * kMin, 4 * kMin}, {0, 5 * kMin});
}

TEST(Incircle, ExactAtTheLargestDoubles) {
  expect_incircle(0, {-kMax, -kMax}, {kMax, -kMax}, {kMax, kMax}, {-kMax, kMax});
  expect_incircle(1, {-kMax, -kMax}, {kMax, -kMax}, {kMax, kMax}, {-kMax, down(kMax)});
  expect_incircle(-1, {-kMax, -kMax}, {kMax, -kMax}, {kMax, down(kMax)}, {-kMax, kMax});
}

TEST(Incircle, ExactAcrossTheWholeRangeInOneCall) {
  expect_incircle(1, {1e-320, 0}, {1e308, 1e-320}, {0, 1e308}, {1, 1});
  expect_incircle(-1, {1e308, 0}, {0, 1e308}, {-1e308, 0}, {1e-320, -up(1e308)});
  expect_incircle(1, {1e308, 0}, {0, 1e308}, {-1e308, 0}, {0, -down(1e308)});
  expect_incircle(-1, {1e308, 0}, {0, 1e308}, {-1e308, 0}, {kMin, -1e308});
}

// Where the lattice stage has to tell multiples of its step from multiples of half of it.
TEST(Incircle, SmallFiguresFarFromTheOriginOnBothSides) {
  for (int exponent = 0; exponent < 53; ++exponent) {
    const double far = std::ldexp(1.0, exponent);
    for (const double x : {-far, far}) {
      for (const double side : {3.0, 4096.0, 23169.5}) {
        const double s = x + side - x;
        const double half = x + 0.5;
        EXPECT_EQ(incircle({x, 0}, {x + s, 0}, {x + s, s}, {x, s}), 0);
        const std::array<Point2, 4> p = {Point2{half, x}, {x + s, x}, {x + s, x + s}, {x, x + s}};
        expect_incircle(oracle::incircle(p[0], p[1], p[2], p[3]), p[0], p[1], p[2], p[3]);
      }
    }
  }
}

TEST(CompareDistance, ComparesFromTheFirstPoint) {
  expect_distance(-1, {0, 0}, {1, 1}, {2, 0});
  expect_distance(0, {0, 0}, {3, 4}, {-5, 0});
  expect_distance(0, {2, 3}, {2, 3}, {2, 3});
}

TEST(CompareDistance, SeesOneUlp) {
  expect_distance(-1, {0, 0}, {3, 4}, {up(5), 0});
  expect_distance(1, {0, 0}, {3, 4}, {down(5), 0});
  expect_distance(-1, {0, 0}, {5, 0}, {5, kMin});
}

TEST(CompareDistance, ExactOverTheWholeRange) {
  expect_distance(-1, {0, 0}, {kMin, 0}, {kMin, kMin});
  expect_distance(0, {-0.0, 0}, {kMin, -0.0}, {0.0, kMin});
  expect_distance(0, {0, 0}, {kMax, kMax}, {-kMax, kMax});
  expect_distance(-1, {0, 0}, {kMax, 0}, {kMax, kMin});
  expect_distance(1, {-kMax, 0}, {kMax, kMin}, {kMax, 0});
}

// Every tuple of distinct points of a 5 x 5 grid, against real lifts in rational numbers.
TEST(IncircleCanonical, AgreesWithRealLiftsOnAGrid) {
  std::array<Point2, 25> grid;
  for (std::size_t i = 0; i < 25; ++i) grid[i] = {static_cast<double>(i / 5), static_cast<double>(i % 5)};
  int ties = 0;
  for (const Point2 a : grid) {
    for (const Point2 b : grid) {
      for (const Point2 c : grid) {
        if (orient2d(a, b, c) == 0) continue;
        for (const Point2 d : grid) {
          if (d == a || d == b || d == c || incircle(a, b, c, d) != 0) continue;
          ++ties;
          const int sign = incircle_canonical(a, b, c, d);
          ASSERT_NE(sign, 0);
          ASSERT_EQ(sign, oracle::incircle_lifted(a, b, c, d));
        }
      }
    }
  }
  EXPECT_GT(ties, 1000);
}

TEST(IncircleCanonical, IsIncircleWhereThatIsNotZero) {
  EXPECT_EQ(incircle_canonical({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), 1);
  EXPECT_EQ(incircle_canonical({0, 0}, {1, 0}, {0, 1}, {1, up(1)}), -1);
}

TEST(IncircleCanonical, IgnoresTheSignOfZero) {
  for (const double zero : {0.0, -0.0}) {
    EXPECT_EQ(incircle_canonical({zero, zero}, {1, zero}, {1, 1}, {0, 1}), 1);
    EXPECT_EQ(incircle_canonical({0, 1}, {zero, 0.0}, {1, -0.0}, {1, 1}), -1);
    EXPECT_EQ(incircle_canonical({-1, zero}, {0.0, -1}, {-zero, 1}, {zero - 1, 0.0}), 0)
        << "twice the same point";
  }
}

TEST(PredicateStages, FilterDecidesGeneralPosition) {
  EXPECT_EQ(thalweg::detail::orient2d_filter({0, 0}, {1, 0}, {0, 1}), MaybeSign(1));
  EXPECT_EQ(thalweg::detail::incircle_filter({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), MaybeSign(1));
  EXPECT_EQ(thalweg::detail::compare_distance_filter({0, 0}, {1, 0}, {0, 2}), MaybeSign(-1));
}

TEST(PredicateStages, FilterAnswersNothingWhereItUnderflowsOrOverflows) {
  for (const double size : {1e-170, 1e170, 1e308}) {
    EXPECT_EQ(thalweg::detail::orient2d_filter({0, 0}, {size, 0}, {0, size}), std::nullopt) << size;
    EXPECT_EQ(thalweg::detail::compare_distance_filter({0, 0}, {size, 0}, {0, size / 2}), std::nullopt)
        << size;
  }
  for (const double size : {1e-80, 1e80, 1e308}) {
    EXPECT_EQ(thalweg::detail::incircle_filter({0, 0}, {size, 0}, {0, size}, {size / 2, size / 2}),
              std::nullopt)
        << size;
  }
}

TEST(PredicateStages, FilterAnswersNothingForNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(thalweg::detail::orient2d_filter({nan, nan}, {1, 0}, {0, 1}), std::nullopt);
  EXPECT_EQ(thalweg::detail::incircle_filter({0, 0}, {1, 0}, {0, 1}, {nan, nan}), std::nullopt);
}

TEST(PredicateStages, GridDecidesSmallLattices) {
  EXPECT_EQ(thalweg::detail::incircle_filter({0, 0}, {1, 0}, {1, 1}, {0, 1}), std::nullopt);
  EXPECT_EQ(thalweg::detail::incircle_grid({0, 0}, {1, 0}, {1, 1}, {0, 1}), MaybeSign(0));
  EXPECT_EQ(
      thalweg::detail::incircle_grid({4e6, 5e5}, {4e6 + 30, 5e5}, {4e6 + 30, 5e5 + 30}, {4e6, 5e5 + 30}),
      MaybeSign(0));
  EXPECT_EQ(thalweg::detail::incircle_grid({0, 0}, {1, 0}, {1, 1}, {0, up(1)}), std::nullopt);
}

TEST(PredicateStages, GridAnswersWithinItsRange) {
  const auto rectangle = [](double height, int exponent) {
    const auto at = [&](double x, double y) {
      return Point2{std::ldexp(x, exponent), std::ldexp(y, exponent)};
    };
    return thalweg::detail::incircle_grid(at(0, 0), at(1, 0), at(1, height), at(0, height));
  };
  // The squared distances add up to 4 and to 10, times 4^exponent: exponents 2 and 3 of the sum.
  for (const int exponent : {-201, 0, 199}) EXPECT_EQ(rectangle(1, exponent), MaybeSign(0)) << exponent;
  for (const int exponent : {-202, 200}) EXPECT_EQ(rectangle(1, exponent), std::nullopt) << exponent;
  for (const int exponent : {-201, 0, 198}) EXPECT_EQ(rectangle(2, exponent), MaybeSign(0)) << exponent;
  for (const int exponent : {-202, 199}) EXPECT_EQ(rectangle(2, exponent), std::nullopt) << exponent;
}

// Three neighbours on a parabola and a site far away: the square of the longest distance says nothing about
// the rounding errors of the others.
TEST(PredicateStages, ProductsDecideLongTriangles) {
  const auto at = [](double x) { return Point2{x, x * x}; };
  const Point2 a = at(-0.75), b = at(0.25), c = at(0.25 + 0x1p-20), d = at(0.25 + 0x1p-19);
  EXPECT_EQ(thalweg::detail::incircle_filter(a, b, c, d), std::nullopt);
  EXPECT_EQ(thalweg::detail::incircle_grid(a, b, c, d), std::nullopt);
  EXPECT_EQ(thalweg::detail::incircle_products(a, b, c, d), MaybeSign(thalweg::incircle(a, b, c, d)));
}

/// Integer points of a circle, some near each other and some far: the determinant is nothing but rounding
/// errors.
class RoundedStages : public testing::TestWithParam<double> {};

TEST_P(RoundedStages, AnswerNothingOnACircle) {
  std::vector<Point2> circle;
  for (const Point2 p : support::integer_circle(32045))
    circle.push_back({GetParam() * p.x - 2 * p.y, GetParam() * p.y + 2 * p.x});
  const std::size_t n = circle.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (const auto& steps : {std::array<std::size_t, 3>{1, 2, n / 2},
                              {1, 2, n / 4},
                              {1, 3, n / 4},
                              {1, n / 2, n / 2 + 1},
                              {n / 5, n / 2, n / 2 + 20}}) {
      std::array<std::size_t, 4> order = {i, i + steps[0], i + steps[1], i + steps[2]};
      std::sort(order.begin(), order.end());
      do {
        const auto at = [&](std::size_t j) { return circle[order[j] % n]; };
        ASSERT_EQ(thalweg::detail::incircle_filter(at(0), at(1), at(2), at(3)), std::nullopt);
        ASSERT_EQ(thalweg::detail::incircle_products(at(0), at(1), at(2), at(3)), std::nullopt);
        ASSERT_EQ(thalweg::detail::compare_distance_filter({0, 0}, at(0), at(1)), std::nullopt);
      } while (std::next_permutation(order.begin(), order.end()));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, RoundedStages, testing::Values(39, 400001));

TEST(PredicateStages, ProductsAnswerNothingBeyondTheirRange) {
  for (const double size : {0x1p36, 1e100, 1e300}) {
    EXPECT_EQ(thalweg::detail::incircle_products({0, 0}, {size, 0}, {0, size}, {size / 2, size / 2}),
              std::nullopt)
        << size;
  }
}

// Four lattice points of a circle about the origin, stretched: where the products pass 53 bits, the doubles
// give a determinant that is not 0, and the lattice stage must have stopped answering.
TEST(PredicateStages, GridStopsBeforeTheFirstRounding) {
  const std::array<Point2, 4> circle = {Point2{63, 16}, {-33, 56}, {-60, -25}, {39, -52}};
  int rounded = 0, answered = 0;
  for (int re = 1; re < 4000; re += 7) {
    std::array<Point2, 4> p;
    const double im = re / 3;
    for (std::size_t i = 0; i < 4; ++i) {
      p[i] = {re * circle[i].x - im * circle[i].y, re * circle[i].y + im * circle[i].x};
    }
    const MaybeSign sign = thalweg::detail::incircle_grid(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(sign.value_or(0), 0) << re;
    answered += sign.has_value();
    rounded += thalweg::detail::rounded_circle(p[0], p[1], p[2], p[3]).det != 0;
  }
  EXPECT_GT(answered, 3);
  EXPECT_GT(rounded, 100);
}

#if defined(THALWEG_HAS_INT128)

TEST(PredicateStages, WordsDecideCoordinatesOfAtMostSixtyOneBits) {
  using thalweg::detail::incircle_words;
  using thalweg::detail::orient2d_words;
  const double fine = 0x1p-60;  // with 1 takes 61 bits
  EXPECT_EQ(incircle_words({0, 0}, {1, 0}, {1, 1}, {fine, 1}), MaybeSign(1));
  EXPECT_EQ(incircle_words({0, 0}, {1, 0}, {1, 1}, {fine / 2, 1}), std::nullopt);
  EXPECT_EQ(orient2d_words({0, 0}, {1, 1}, {fine, 0}), MaybeSign(-1));
  EXPECT_EQ(orient2d_words({0, 0}, {1, 1}, {fine / 2, 0}), std::nullopt);
  EXPECT_EQ(thalweg::detail::compare_distance_words({0, 0}, {1, 0}, {1, fine}), MaybeSign(-1));
  EXPECT_EQ(thalweg::detail::compare_distance_words({0, 0}, {1, 0}, {1, fine / 2}), std::nullopt);
}

TEST(PredicateStages, WordsHoldTheirLargestValues) {
  const double m = 0x1.fffffffffffffp60;  // the largest magnitude of 61 bits
  EXPECT_EQ(thalweg::detail::incircle_words({-m, -m}, {m, -m}, {m, m}, {-m, m}), MaybeSign(0));
  EXPECT_EQ(thalweg::detail::incircle_words({-m, -m}, {m, -m}, {m, m}, {-m, m - 256}), MaybeSign(1));
  EXPECT_EQ(thalweg::detail::incircle_words({-m, -m}, {m, m}, {m, -m}, {-m, m - 256}), MaybeSign(-1));
  EXPECT_EQ(thalweg::detail::orient2d_words({-m, -m}, {m, -m}, {m, m}), MaybeSign(1));
  EXPECT_EQ(thalweg::detail::orient2d_words({-2 * m, -m}, {m, -m}, {m, m}), std::nullopt) << "out of range";
}

#endif

TEST(PredicateStages, ExactStageAgreesOnOrdinaryInput) {
  EXPECT_EQ(thalweg::detail::orient2d_exact({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(thalweg::detail::incircle_exact({0, 0}, {1, 0}, {0, 1}, {1, 1}), 0);
  EXPECT_EQ(thalweg::detail::compare_distance_exact({0, 0}, {3, 4}, {5, 0}), 0);
}

TEST(WideMultiply, HalvesAgreeWithTheMachine) {
  constexpr std::uint64_t kAll = ~std::uint64_t{0};
  const std::array<std::uint64_t, 8> values = {0,         1,        0xffffffffu, 0x100000000u,
                                               kAll >> 1, kAll - 1, kAll,        0x123456789abcdef0u};
  for (const auto a : values) {
    for (const auto b : values) {
      for (const auto c : values) {
        for (const auto d : values) {
          std::uint64_t high = 1, halves_high = 2;
          const auto low = thalweg::detail::multiply_add(a, b, c, d, high);
          EXPECT_EQ(thalweg::detail::multiply_add_in_halves(a, b, c, d, halves_high), low);
          EXPECT_EQ(halves_high, high);
        }
      }
    }
  }
}

/// The lexicographically largest corner, which the tie would lift, included.
TEST(IncircleCanonical, ZeroOfACornerOfTheTriangle) {
  const Point2 a{0, 0}, b{4, 0}, c{0, 4};
  for (const Point2 d : {a, b, c}) {
    EXPECT_EQ(incircle_canonical(a, b, c, d), 0);
    EXPECT_EQ(incircle_canonical(b, c, a, d), 0);
    EXPECT_EQ(incircle_canonical(c, a, b, d), 0);
  }
}

}  // namespace
