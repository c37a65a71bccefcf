/// SiteIndex: where nothing overflows, the site near a place is the nearest, for many and few sites, in a
/// plane and on a line, far from zero too.
#include "order/site_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/random.hpp"
#include "kernel/delaunay_sites.hpp"
#include "kernel/spatial_order.hpp"

namespace {

using thalweg::Point2;
using thalweg::detail::SiteIndex;

double squared_distance(Point2 a, Point2 b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// Places of at most 2^20 in magnitude around the middle: all squares are exact.
void expect_nearest(const std::vector<Point2>& points, Point2 middle, double reach) {
  const auto order = thalweg::detail::spatial_order(points, 1);
  std::vector<Point2> sites;
  for (const std::uint32_t row : order.rows) sites.push_back(points[row]);
  const auto mesh = thalweg::detail::delaunay_of_sites(sites, order.keys, 1);
  const SiteIndex index(sites, mesh ? &*mesh : nullptr);
  thalweg::io::Random random(7);
  for (int i = 0; i < 200; ++i) {
    const auto draw = [&] { return static_cast<double>(random.below(1u << 21)) / (1 << 20) - 1; };
    const Point2 q{std::floor(middle.x + draw() * reach), std::floor(middle.y + draw() * reach)};
    double least = squared_distance(sites[0], q);
    for (const Point2 site : sites) least = std::min(least, squared_distance(site, q));
    const std::uint32_t found = index.near(q);
    ASSERT_LT(found, sites.size());
    ASSERT_EQ(squared_distance(sites[found], q), least) << q.x << " " << q.y;
  }
}

/// Distinct places: one in each cell of a lattice of `side` cells, each of `width`, around the middle.
std::vector<Point2> scattered(Point2 middle, int side, std::uint32_t width) {
  thalweg::io::Random random(3);
  std::vector<Point2> points;
  for (int i = 0; i < side * side; ++i) {
    const double x = static_cast<double>(random.below(width)) + double(width) * (i % side - side / 2);
    const double y = static_cast<double>(random.below(width)) + double(width) * (i / side - side / 2);
    points.push_back({middle.x + x, middle.y + y});
  }
  return points;
}

TEST(SiteIndex, FindsTheNearestOfManyAndOfFew) {
  for (const Point2 middle : {Point2{0, 0}, Point2{500000, -300000}, Point2{-300000, 700000}}) {
    for (const int side : {1, 2, 5, 12, 30}) {
      expect_nearest(scattered(middle, side, 40), middle, 20.0 * side);
      expect_nearest(scattered(middle, side, 40), middle, 100.0 * side);
    }
  }
}

TEST(SiteIndex, FindsTheNearestOnALine) {
  for (const Point2 step : {Point2{3, 0}, Point2{0, 5}, Point2{2, -7}}) {
    for (const int count : {2, 3, 25, 700}) {
      std::vector<Point2> points;
      for (int i = 0; i < count; ++i) points.push_back({1000 + i * step.x, 2000 + i * step.y});
      const Point2 middle = points[points.size() / 2];
      expect_nearest(points, middle, 3.0 * count);
    }
  }
}

/// From so far that only the direction counts, the nearest is the end of the arm of a cross.
TEST(SiteIndex, FindsTheOutermostFromFarAway) {
  for (const Point2 middle : {Point2{0, 0}, Point2{4096, -8192}, Point2{0x1p50, -0x1p50}}) {
    std::vector<Point2> points;
    for (int i = -100; i <= 100; ++i) {
      points.push_back({middle.x + i, middle.y});
      if (i != 0) points.push_back({middle.x, middle.y + i});
    }
    const auto order = thalweg::detail::spatial_order(points, 1);
    std::vector<Point2> sites;
    for (const std::uint32_t row : order.rows) sites.push_back(points[row]);
    const auto mesh = thalweg::detail::delaunay_of_sites(sites, order.keys, 1);
    const SiteIndex index(sites, &*mesh);
    for (const double far : {1e6, 1e100, 1e300}) {
      EXPECT_EQ(sites[index.near({middle.x + far, middle.y})], (Point2{middle.x + 100, middle.y}));
      EXPECT_EQ(sites[index.near({middle.x - far, middle.y})], (Point2{middle.x - 100, middle.y}));
      EXPECT_EQ(sites[index.near({middle.x, middle.y + far})], (Point2{middle.x, middle.y + 100}));
      EXPECT_EQ(sites[index.near({middle.x, middle.y - far})], (Point2{middle.x, middle.y - 100}));
    }
  }
}

}  // namespace
