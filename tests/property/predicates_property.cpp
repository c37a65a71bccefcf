/// A million predicates against GMP, degenerate on purpose, and the laws of their contracts.
/// THALWEG_PREDICATE_CASES sets the number of cases, THALWEG_PREDICATE_SEED where they start.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "kernel/predicates_inline.hpp"
#include "kernel/wide_multiply.hpp"
#include "oracle/exact_predicates.hpp"
#include "support/random.hpp"
#include "support/special_values.hpp"
#include "thalweg/predicates.hpp"

namespace {

using support::kInfinity;
using support::Random;
using thalweg::Point2;
using thalweg::detail::MaybeSign;
using Tuple = std::array<Point2, 4>;

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// 0 to 4 doubles up or down.
double nudged(Random& random, double value) {
  const int steps = random.between(-4, 4);
  for (int i = 0; i < std::abs(steps); ++i) value = std::nextafter(value, steps < 0 ? -kInfinity : kInfinity);
  return value;
}

Point2 nudged(Random& random, Point2 p) {
  return {nudged(random, p.x), nudged(random, p.y)};
}

template <class Make>
Tuple tuple_of(Make make) {
  Tuple tuple;
  for (Point2& p : tuple) p = make();
  return tuple;
}

Tuple uniform(Random& random) {
  return tuple_of([&] { return Point2{random.unit(), random.unit()}; });
}

Tuple near_collinear(Random& random) {
  const double offset = random.between(0, 1) * std::ldexp(1.0, random.between(-10, 30));
  const Point2 a{offset + random.unit(), random.unit()};
  const Point2 b{offset + random.unit(), random.unit()};
  return tuple_of([&] {
    const double t = 4 * random.unit() - 2;
    return nudged(random, Point2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
  });
}

Tuple near_cocircular(Random& random) {
  const double offset = random.between(0, 1) * std::ldexp(1.0, random.between(-10, 30));
  const double radius = std::ldexp(1.0, random.between(-10, 10));
  return tuple_of([&] {
    const double angle = 6.283185307179586 * random.unit();
    return nudged(random, Point2{offset + radius * std::cos(angle), radius * std::sin(angle)});
  });
}

Tuple scaled(Tuple tuple, int exponent) {
  for (Point2& p : tuple) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
  return tuple;
}

/// On a line of the integer lattice.
Tuple lattice_line(Random& random) {
  const double x = random.whole(-1000, 1000), y = random.whole(-1000, 1000);
  const double dx = random.whole(-50, 50), dy = random.whole(-50, 50);
  return tuple_of([&] {
    const double t = random.whole(-20, 20);
    return Point2{x + t * dx, y + t * dy};
  });
}

/// The same at any scale at which it still fits into doubles.
Tuple exactly_collinear(Random& random) {
  const Tuple tuple = lattice_line(random);
  return scaled(tuple, random.between(-1074, 1000));
}

/// On a circle of the integer lattice turned and stretched by a Gaussian integer, so that the products reach
/// and pass 53 bits; one point perhaps one lattice step off. Far from the origin or not, on either side.
Tuple lattice_circle(Random& random) {
  constexpr std::array<std::array<int, 2>, 5> kEighth = {{{65, 0}, {63, 16}, {60, 25}, {56, 33}, {52, 39}}};
  const int most = 1 << random.between(0, 12);
  const double re = random.whole(-most, most), im = random.whole(-most, most);
  const double x = std::ldexp(random.whole(-3, 3), random.between(0, 50)), y = random.whole(-1000, 1000);
  Tuple tuple = tuple_of([&] {
    const auto& p = kEighth[static_cast<std::size_t>(random.between(0, 4))];
    const double u = p[0] * (2 * random.between(0, 1) - 1), v = p[1] * (2 * random.between(0, 1) - 1);
    return random.between(0, 1) == 0 ? Point2{x + re * u - im * v, y + re * v + im * u}
                                     : Point2{x + re * v - im * u, y + re * u + im * v};
  });
  if (random.between(0, 3) == 0) tuple[0].x += 1;
  return tuple;
}

Tuple exactly_cocircular(Random& random) {
  const Tuple tuple = lattice_circle(random);
  return scaled(tuple, random.between(-1074, 900));
}

double any_double(Random& random) {
  for (;;) {
    const auto value = std::bit_cast<double>(random.next());
    if (std::isfinite(value)) return value;
  }
}

Tuple any_exponents(Random& random) {
  return tuple_of([&] { return Point2{any_double(random), any_double(random)}; });
}

/// Integers of two bits times powers of two of the whole range: cancellation between extremes.
Tuple sparse_exponents(Random& random) {
  const int low = random.between(-1074, 900), high = random.between(low, 1021);
  const auto value = [&] { return std::ldexp(random.whole(-3, 3), random.between(0, 1) == 0 ? low : high); };
  return tuple_of([&] { return Point2{value(), value()}; });
}

Tuple special_values(Random& random) {
  constexpr std::array<double, 12> kValues = {0.0,
                                              -0.0,
                                              5e-324,
                                              -5e-324,
                                              2.2250738585072014e-308,
                                              1.7976931348623157e308,
                                              -1.7976931348623157e308,
                                              1e308,
                                              1e-320,
                                              1.0,
                                              -1.0,
                                              0x1.0000000000001p0};
  const auto value = [&] { return kValues[static_cast<std::size_t>(random.between(0, 11))]; };
  return tuple_of([&] { return Point2{value(), value()}; });
}

Tuple equal_points(Random& random) {
  Tuple tuple = random.between(0, 1) == 0 ? uniform(random) : any_exponents(random);
  const auto index = [&] { return static_cast<std::size_t>(random.between(0, 3)); };
  tuple[index()] = tuple[index()];
  tuple[index()] = tuple[index()];
  return tuple;
}

/// Rectangles of decimal coordinates far from the origin on either side, sometimes a few ulp or half a step
/// off.
Tuple decimal_rectangle(Random& random) {
  const double step = random.between(0, 1) == 0 ? 0.01 : std::ldexp(1.0, random.between(-30, 30));
  const double far_x = std::ldexp(random.whole(-1, 1), random.between(0, 52));
  const double far_y = std::ldexp(random.whole(-1, 1), random.between(0, 52));
  const auto place = [&](double far) { return (far + random.whole(-200, 200)) * step; };
  const double x0 = place(far_x), x1 = place(far_x), y0 = place(far_y), y1 = place(far_y);
  Tuple tuple = {Point2{x0, y0}, Point2{x1, y0}, Point2{x1, y1}, Point2{x0, y1}};
  if (random.between(0, 2) == 0) tuple[3].x = nudged(random, x0);
  if (random.between(0, 2) == 0) tuple[1].x += step / 2;
  return tuple;
}

constexpr std::array kKinds = {
    uniform,       near_collinear,   near_cocircular, exactly_collinear, exactly_cocircular,
    any_exponents, sparse_exponents, special_values,  equal_points,      decimal_rectangle};

std::string printed(const Tuple& tuple) {
  std::string text;
  for (const Point2& p : tuple) {
    std::array<char, 80> buffer;
    std::snprintf(buffer.data(), buffer.size(), "{%a, %a}, ", p.x, p.y);
    text += buffer.data();
  }
  return text;
}

enum Stage { kFilter, kProducts, kGrid, kWords, kExact, kStages };

/// Without wide integers the stage of words never answers; the others must still be right.
#if defined(THALWEG_HAS_INT128)
constexpr std::uint64_t kFewestByWords = 1000;
#else
constexpr std::uint64_t kFewestByWords = 0;
#endif
constexpr std::uint64_t kFewest = 1000;

/// Runs the same number of cases of every kind. check(tuple) answers the stage that decided.
template <class Check>
std::array<std::uint64_t, kStages> run_cases(Check check) {
  const std::uint64_t cases = from_environment("THALWEG_PREDICATE_CASES", 1000000) / 3;
  Random random(from_environment("THALWEG_PREDICATE_SEED", 1997));
  std::array<std::uint64_t, kStages> decided = {};
  for (std::uint64_t i = 0; i < cases; ++i) {
    const Tuple tuple = kKinds[i % kKinds.size()](random);
    ++decided[check(tuple)];
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "case " << i << ": " << printed(tuple);
      break;
    }
  }
  std::printf(
      "decided by filter %llu, products %llu, grid %llu, words %llu, exact %llu\n",
      static_cast<unsigned long long>(decided[kFilter]), static_cast<unsigned long long>(decided[kProducts]),
      static_cast<unsigned long long>(decided[kGrid]), static_cast<unsigned long long>(decided[kWords]),
      static_cast<unsigned long long>(decided[kExact]));
  return decided;
}

/// Every stage that answers must answer the truth.
Stage expect_stages(int truth, MaybeSign filter, MaybeSign products, MaybeSign grid, MaybeSign words,
                    int exact) {
  EXPECT_EQ(filter.value_or(truth), truth) << "filter";
  EXPECT_EQ(products.value_or(truth), truth) << "products";
  EXPECT_EQ(grid.value_or(truth), truth) << "grid";
  EXPECT_EQ(words.value_or(truth), truth) << "words";
  EXPECT_EQ(exact, truth) << "exact";
  return filter ? kFilter : products ? kProducts : grid ? kGrid : words ? kWords : kExact;
}

TEST(PredicatesAgainstOracle, Orient2d) {
  const auto decided = run_cases([](const Tuple& t) {
    const auto [a, b, c, d] = t;
    const int truth = oracle::orient2d(a, b, c);
    EXPECT_EQ(thalweg::orient2d(a, b, c), truth);
    return expect_stages(truth, thalweg::detail::orient2d_filter(a, b, c), std::nullopt, std::nullopt,
                         thalweg::detail::orient2d_words(a, b, c), thalweg::detail::orient2d_exact(a, b, c));
  });
  for (const Stage stage : {kFilter, kExact}) EXPECT_GT(decided[stage], kFewest) << stage;
  EXPECT_GE(decided[kWords], kFewestByWords);
}

TEST(PredicatesAgainstOracle, Incircle) {
  const auto decided = run_cases([](const Tuple& t) {
    const auto [a, b, c, d] = t;
    const int truth = oracle::incircle(a, b, c, d);
    EXPECT_EQ(thalweg::incircle(a, b, c, d), truth);
    return expect_stages(
        truth, thalweg::detail::incircle_filter(a, b, c, d), thalweg::detail::incircle_products(a, b, c, d),
        thalweg::detail::incircle_grid(a, b, c, d), thalweg::detail::incircle_words(a, b, c, d),
        thalweg::detail::incircle_exact(a, b, c, d));
  });
  for (const Stage stage : {kFilter, kProducts, kGrid, kExact}) EXPECT_GT(decided[stage], kFewest) << stage;
  EXPECT_GE(decided[kWords], kFewestByWords);
}

TEST(PredicatesAgainstOracle, CompareDistance) {
  const auto decided = run_cases([](const Tuple& t) {
    const auto [a, b, c, d] = t;
    const int truth = oracle::compare_distance(a, b, c);
    EXPECT_EQ(thalweg::compare_distance(a, b, c), truth);
    return expect_stages(truth, thalweg::detail::compare_distance_filter(a, b, c), std::nullopt, std::nullopt,
                         thalweg::detail::compare_distance_words(a, b, c),
                         thalweg::detail::compare_distance_exact(a, b, c));
  });
  for (const Stage stage : {kFilter, kExact}) EXPECT_GT(decided[stage], kFewest) << stage;
  EXPECT_GE(decided[kWords], kFewestByWords);
}

/// One tuple of any kind; rapidcheck finds the number, the tuple follows from it.
Tuple drawn() {
  const auto seed =
      *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
  Random random(seed);
  const Tuple tuple = kKinds[seed % kKinds.size()](random);
  RC_LOG() << printed(tuple);
  return tuple;
}

RC_GTEST_PROP(PredicateLaws, RotationKeepsAndSwapsNegate, ()) {
  const auto [a, b, c, d] = drawn();
  const int turn = thalweg::orient2d(a, b, c);
  RC_ASSERT(thalweg::orient2d(b, c, a) == turn);
  RC_ASSERT(thalweg::orient2d(b, a, c) == -turn);
  const int side = thalweg::incircle(a, b, c, d);
  RC_ASSERT(thalweg::incircle(b, c, a, d) == side);
  RC_ASSERT(thalweg::incircle(b, a, c, d) == -side);
  RC_ASSERT(thalweg::incircle(d, b, c, a) == -side);
  RC_ASSERT(thalweg::incircle(a, b, d, c) == -side);
  RC_ASSERT(thalweg::compare_distance(a, c, b) == -thalweg::compare_distance(a, b, c));
}

RC_GTEST_PROP(PredicateLaws, TurningByARightAngleKeepsSigns, ()) {
  const auto [a, b, c, d] = drawn();
  const auto turned = [](Point2 p) { return Point2{-p.y, p.x}; };
  RC_ASSERT(thalweg::orient2d(turned(a), turned(b), turned(c)) == thalweg::orient2d(a, b, c));
  RC_ASSERT(thalweg::incircle(turned(a), turned(b), turned(c), turned(d)) == thalweg::incircle(a, b, c, d));
}

RC_GTEST_PROP(PredicateLaws, MirroringNegatesSigns, ()) {
  const auto [a, b, c, d] = drawn();
  const auto mirrored = [](Point2 p) { return Point2{p.y, p.x}; };
  RC_ASSERT(thalweg::orient2d(mirrored(a), mirrored(b), mirrored(c)) == -thalweg::orient2d(a, b, c));
  RC_ASSERT(thalweg::incircle(mirrored(a), mirrored(b), mirrored(c), mirrored(d)) ==
            -thalweg::incircle(a, b, c, d));
}

/// All that the predicates say of a tuple.
std::array<int, 4> signs_of(const Tuple& t) {
  const auto& [a, b, c, d] = t;
  return {thalweg::orient2d(a, b, c), thalweg::incircle(a, b, c, d), thalweg::compare_distance(a, b, c),
          thalweg::detail::incircle_canonical(a, b, c, d)};
}

RC_GTEST_PROP(PredicateLaws, DistancesSurviveTurningAndMirroring, ()) {
  const auto [a, b, c, d] = drawn();
  const int sign = thalweg::compare_distance(a, b, c);
  const auto turned = [](Point2 p) { return Point2{-p.y, p.x}; };
  const auto mirrored = [](Point2 p) { return Point2{p.x, -p.y}; };
  RC_ASSERT(thalweg::compare_distance(turned(a), turned(b), turned(c)) == sign);
  RC_ASSERT(thalweg::compare_distance(mirrored(a), mirrored(b), mirrored(c)) == sign);
}

RC_GTEST_PROP(PredicateLaws, ExactTranslationKeepsSigns, (std::uint64_t seed)) {
  Random random(seed);
  const Tuple tuple = random.between(0, 1) == 0 ? lattice_line(random) : lattice_circle(random);
  const double x = std::ldexp(random.whole(-7, 7), random.between(0, 48)), y = random.whole(-99999, 99999);
  Tuple moved = tuple;
  for (Point2& p : moved) p = {p.x + x, p.y + y};  // all whole and below 2^53
  RC_LOG() << printed(tuple) << "moved by " << x << " " << y;
  RC_ASSERT(signs_of(moved) == signs_of(tuple));
}

/// The places of the highest and the lowest bit that is set in any coordinate.
std::array<int, 2> bits_of(const Tuple& tuple) {
  int high = -1074, low = 1023;
  for (const Point2& p : tuple) {
    for (const double value : {p.x, p.y}) {
      if (value == 0) continue;
      int exponent = 0;
      const auto mantissa =
          static_cast<std::uint64_t>(std::ldexp(std::fabs(std::frexp(value, &exponent)), 53));
      high = std::max(high, exponent - 1);
      low = std::min(low, exponent - 53 + std::countr_zero(mantissa));
    }
  }
  return {high, low};
}

RC_GTEST_PROP(PredicateLaws, PowersOfTwoKeepSigns, (std::uint64_t seed)) {
  const Tuple tuple = drawn();
  const auto [high, low] = bits_of(tuple);
  RC_PRE(low <= high);
  Random random(seed);
  for (const int exponent : {-1074 - low, 1023 - high, random.between(-1074 - low, 1023 - high)}) {
    const Tuple other = scaled(tuple, exponent);
    RC_ASSERT(scaled(other, -exponent) == tuple);
    RC_ASSERT(signs_of(other) == signs_of(tuple));
  }
}

RC_GTEST_PROP(PredicateLaws, CanonicalObeysTheLawsOfIncircle, ()) {
  using thalweg::detail::incircle_canonical;
  const auto [a, b, c, d] = drawn();
  const int side = incircle_canonical(a, b, c, d);
  RC_ASSERT(incircle_canonical(b, c, a, d) == side);
  RC_ASSERT(incircle_canonical(b, a, c, d) == -side);
  RC_ASSERT(incircle_canonical(d, b, c, a) == -side);
  const bool distinct = a != b && a != c && a != d && b != c && b != d && c != d;
  if (distinct && thalweg::orient2d(a, b, c) != 0) RC_ASSERT(side != 0);
}

}  // namespace
