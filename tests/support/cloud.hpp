/// Random point sets that are degenerate on purpose, shrink well, and print as C++ to paste.
///
/// All coordinates are small integers, so that tests/oracle can judge them; `scaled` moves a set to other
/// exponents without rounding.
#pragma once

#include <rapidcheck.h>

#include <ostream>
#include <span>
#include <vector>

#include "thalweg/point.hpp"

namespace support {

/// Distinct (x, y), at least three, not all on one line.
struct Cloud {
  std::vector<thalweg::Point3> points;

  std::vector<thalweg::Point2> places() const;
  std::vector<double> elevations() const;
  std::uint32_t size() const { return static_cast<std::uint32_t>(points.size()); }
};

/// Prints as `const std::vector<thalweg::Point3> points = {{0, 0, 1}, ...};`, hexadecimal where decimal would
/// round.
void showValue(const Cloud& cloud, std::ostream& out);

/// The first of points with equal (x, y) each; points off the line are added if all are collinear.
Cloud make_cloud(std::vector<thalweg::Point3> points);

/// Clouds of at most `most` (+ 3) points: squares, tiny grids, lattices with gaps, rings of cocircular points
/// with and without near misses of one unit, runs of collinear and nearly collinear points inside and on the
/// hull, with few or many different elevations.
rc::Gen<Cloud> clouds(int most);

/// The integer points with x^2 + y^2 = radius^2, counter-clockwise from (radius, 0). 324 for 32045.
std::vector<thalweg::Point2> integer_circle(int radius);

/// The same points with x and y times 2^exponent. Requires: no coordinate over- or underflows.
Cloud scaled(const Cloud& cloud, int exponent);

/// A permutation of 0 .. size - 1 that depends on `seed` alone.
std::vector<std::uint32_t> permutation(std::uint32_t size, std::uint64_t seed);

/// The cloud with row i moved to row order[i].
Cloud permuted(const Cloud& cloud, std::span<const std::uint32_t> order);

}  // namespace support
