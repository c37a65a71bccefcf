/// The predicates alone: exact where rounded arithmetic answers wrongly.
#include <thalweg/predicates.hpp>

#include <cstdio>

namespace {

/// What orient2d is the sign of, as doubles give it.
double rounded(thalweg::Point2 a, thalweg::Point2 b, thalweg::Point2 c) {
  return (a.x - c.x) * (b.y - c.y) - (a.y - c.y) * (b.x - c.x);
}

}  // namespace

int main() {
  using thalweg::Point2;
  // The first point is a hair above the line through the others; the rounded determinant is 0.
  const Point2 a{0.5, 0.5 + 0x1p-53}, b{12, 12}, c{24, 24};
  std::printf("rounded %g, exact %d\n", rounded(a, b, c), thalweg::orient2d(a, b, c));
  if (thalweg::orient2d(a, b, c) != +1) return 1;
  if (thalweg::orient2d({0.5, 0.5}, b, c) != 0) return 2;

  // Four points on one circle, and the last one moved inwards by the least that a double can express.
  const Point2 east{5, 0}, north{3, 4}, west{-5, 0};
  if (thalweg::incircle(east, north, west, {0, -5}) != 0) return 3;
  if (thalweg::incircle(east, north, west, {0, -5 + 0x1p-50}) != +1) return 4;

  // Any finite double will do: the sum of squares of these would overflow.
  if (thalweg::compare_distance({0, 0}, {1e300, 1e300}, {2e300, 0}) != -1) return 5;
  return 0;
}
