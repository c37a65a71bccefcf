/// The predicates on hostile points against their determinants in exact integers, with their laws; and every
/// stage that gives a sign gives the true one.
#include <cmath>

#include "fuzz_input.hpp"
#include "kernel/predicate_stages.hpp"
#include "oracle/exact_predicates.hpp"
#include "thalweg/predicates.hpp"

namespace {

using thalweg::Point2;
namespace detail = thalweg::detail;

/// A stage may not know, but it may not be wrong.
bool never_wrong(detail::MaybeSign stage, int sign) {
  return !stage || *stage == sign;
}

void check_orientation(const std::vector<Point2>& p) {
  const int sign = oracle::orient2d(p[0], p[1], p[2]);
  fuzz::check(thalweg::orient2d(p[0], p[1], p[2]) == sign, "orient2d is exact", p);
  fuzz::check(thalweg::orient2d(p[1], p[2], p[0]) == sign, "orient2d turns", p);
  fuzz::check(thalweg::orient2d(p[1], p[0], p[2]) == -sign, "orient2d changes its sign", p);
  fuzz::check(never_wrong(detail::orient2d_words(p[0], p[1], p[2]), sign), "orient2d in words", p);
  fuzz::check(detail::orient2d_exact(p[0], p[1], p[2]) == sign, "orient2d in long integers", p);
}

void check_distance(const std::vector<Point2>& p) {
  const int sign = oracle::compare_distance(p[0], p[1], p[2]);
  fuzz::check(thalweg::compare_distance(p[0], p[1], p[2]) == sign, "compare_distance is exact", p);
  fuzz::check(thalweg::compare_distance(p[0], p[2], p[1]) == -sign, "compare_distance changes its sign", p);
  fuzz::check(never_wrong(detail::compare_distance_words(p[0], p[1], p[2]), sign), "distances in words", p);
  fuzz::check(detail::compare_distance_exact(p[0], p[1], p[2]) == sign, "distances in long integers", p);
}

void check_circle(std::vector<Point2> p) {
  const int turn = oracle::orient2d(p[0], p[1], p[2]);
  if (turn == 0) return;
  if (turn < 0) std::swap(p[0], p[1]);
  const int sign = oracle::incircle(p[0], p[1], p[2], p[3]);
  fuzz::check(thalweg::incircle(p[0], p[1], p[2], p[3]) == sign, "incircle is exact", p);
  fuzz::check(thalweg::incircle(p[2], p[0], p[1], p[3]) == sign, "incircle turns", p);
  fuzz::check(never_wrong(detail::incircle_grid(p[0], p[1], p[2], p[3]), sign), "incircle on grids", p);
  fuzz::check(never_wrong(detail::incircle_products(p[0], p[1], p[2], p[3]), sign), "incircle by products",
              p);
  fuzz::check(never_wrong(detail::incircle_words(p[0], p[1], p[2], p[3]), sign), "incircle in words", p);
  fuzz::check(detail::incircle_exact(p[0], p[1], p[2], p[3]) == sign, "incircle in long integers", p);
}

/// The value a few units in its last place further.
double nudged(double value, int steps) {
  for (; steps > 0; --steps) value = std::nextafter(value, 1e308);
  return value;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::uint8_t steps = input.byte();
  std::vector<Point2> points = fuzz::take_points(input, 4);
  if (points.size() < 3 || !fuzz::all_finite(points)) return 0;
  // The fourth corner of a parallelogram where none is given: of a rectangle it is cocircular.
  if (points.size() == 3) {
    const Point2 fourth = {points[0].x - points[1].x + points[2].x, points[0].y - points[1].y + points[2].y};
    points.push_back(std::isfinite(fourth.x) && std::isfinite(fourth.y) ? fourth : points[0]);
  }
  points[2].x = nudged(points[2].x, steps % 4);
  points[3].y = nudged(points[3].y, steps / 4 % 4);
  check_orientation(points);
  check_distance(points);
  check_circle(points);
  return 0;
}
