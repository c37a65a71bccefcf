/// merge_sites: which row stands for a place, and with which elevation.
#include "terrain/merge.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "support/cloud.hpp"
#include "support/random_mesh.hpp"
#include "support/special_values.hpp"

namespace {

using support::kInfinity;
using support::kNan;
using thalweg::DuplicatePolicy;
using thalweg::ErrorCode;
using thalweg::Point2;
using thalweg::Point3;
using thalweg::detail::merge_sites;
using thalweg::detail::MergedSites;

constexpr double kMax = std::numeric_limits<double>::max();

using Rows = std::vector<std::uint32_t>;
using Merges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

MergedSites merge(const std::vector<Point3>& points, DuplicatePolicy policy) {
  return merge_sites(points, policy, 1).value();
}

/// The elevation of the only place with several rows, at (0, 0).
double elevation(const std::vector<double>& z, DuplicatePolicy policy) {
  std::vector<Point3> points = {{1, 0, 7}};
  for (const double value : z) points.push_back({0, 0, value});
  const MergedSites sites = merge(points, policy);
  for (std::size_t i = 0; i < sites.xy.size(); ++i) {
    if (sites.xy[i] == Point2{0, 0}) return sites.z[i];
  }
  return kNan;
}

/// The row that stands for the place; rows are numbered from 1.
std::uint32_t row(const std::vector<double>& z, DuplicatePolicy policy) {
  std::vector<Point3> points = {{1, 0, 7}};
  for (const double value : z) points.push_back({0, 0, value});
  const MergedSites sites = merge(points, policy);
  for (std::size_t i = 0; i < sites.xy.size(); ++i) {
    if (sites.xy[i] == Point2{0, 0}) return sites.row[i];
  }
  return 0;
}

TEST(MergeSites, WithoutDuplicatesKeepsEveryRow) {
  const std::vector<Point3> points = {{3, 1, 4}, {1, 5, 9}, {2, 6, 5}, {3, 5, 8}};
  for (const auto policy : {DuplicatePolicy::lowest, DuplicatePolicy::mean, DuplicatePolicy::error}) {
    const MergedSites sites = merge(points, policy);
    ASSERT_EQ(sites.row.size(), 4u);
    EXPECT_EQ(std::set<std::uint32_t>(sites.row.begin(), sites.row.end()).size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
      const Point3& p = points[sites.row[i]];
      EXPECT_EQ(sites.xy[i], (Point2{p.x, p.y}));
      EXPECT_EQ(sites.z[i], p.z);
    }
    EXPECT_TRUE(sites.merged.empty());
    EXPECT_TRUE(sites.mean_elevations.empty());
    EXPECT_EQ(sites.keys.size(), 4u);
  }
}

TEST(MergeSites, TakesTheRowOfThePolicy) {
  const std::vector<double> z = {4, 2, 9, 2, 9, 5};
  EXPECT_EQ(row(z, DuplicatePolicy::lowest), 2u);  // of equals the first
  EXPECT_EQ(row(z, DuplicatePolicy::highest), 3u);
  EXPECT_EQ(row(z, DuplicatePolicy::first), 1u);
  EXPECT_EQ(row(z, DuplicatePolicy::last), 6u);
  EXPECT_EQ(row(z, DuplicatePolicy::mean), 1u);
  EXPECT_EQ(elevation(z, DuplicatePolicy::lowest), 2);
  EXPECT_EQ(elevation(z, DuplicatePolicy::highest), 9);
  EXPECT_EQ(elevation(z, DuplicatePolicy::first), 4);
  EXPECT_EQ(elevation(z, DuplicatePolicy::last), 5);
  EXPECT_EQ(elevation({1, 2, 6}, DuplicatePolicy::mean), 3);
}

TEST(MergeSites, SaysWhichRowsWentIntoWhich) {
  const std::vector<Point3> points = {{0, 0, 3}, {5, 5, 1}, {0, 0, 1}, {5, 5, 1}, {2, 2, 2}, {0, 0, 2}};
  EXPECT_EQ(merge(points, DuplicatePolicy::lowest).merged, (Merges{{0, 2}, {3, 1}, {5, 2}}));
  EXPECT_EQ(merge(points, DuplicatePolicy::highest).merged, (Merges{{2, 0}, {3, 1}, {5, 0}}));
  EXPECT_EQ(merge(points, DuplicatePolicy::first).merged, (Merges{{2, 0}, {3, 1}, {5, 0}}));
  EXPECT_EQ(merge(points, DuplicatePolicy::last).merged, (Merges{{0, 5}, {1, 3}, {2, 5}}));
  EXPECT_EQ(merge(points, DuplicatePolicy::mean).merged, (Merges{{2, 0}, {3, 1}, {5, 0}}));
}

TEST(MergeSites, NamesMeanElevationsThatNoRowHas) {
  const std::vector<Point3> points = {{0, 0, 3}, {5, 5, 1}, {0, 0, 1}, {5, 5, 1}, {0, 0, 5}, {0, 0, 0}};
  const MergedSites sites = merge(points, DuplicatePolicy::mean);
  EXPECT_EQ(sites.mean_elevations, (std::vector<std::pair<std::uint32_t, double>>{{0, 2.25}}));
  EXPECT_TRUE(merge(points, DuplicatePolicy::lowest).mean_elevations.empty());
}

TEST(MergeSites, MeanDoesNotOverflow) {
  EXPECT_EQ(elevation({kMax, kMax}, DuplicatePolicy::mean), kMax);
  EXPECT_EQ(elevation({kMax, kMax / 2}, DuplicatePolicy::mean), kMax / 2 + kMax / 4);
  EXPECT_EQ(elevation({-kMax, -kMax / 2}, DuplicatePolicy::mean), -(kMax / 2 + kMax / 4));
  EXPECT_EQ(elevation({-kMax, kMax}, DuplicatePolicy::mean), 0);
  EXPECT_EQ(elevation({-kMax, kMax, -kMax, kMax}, DuplicatePolicy::mean), 0);
  EXPECT_TRUE(std::isfinite(elevation({kMax, kMax, kMax, -1}, DuplicatePolicy::mean)));
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(elevation({tiny, 3 * tiny}, DuplicatePolicy::mean), 2 * tiny);
}

TEST(MergeSites, MeanLiesBetweenItsValues) {
  // Rounded sums of many values can leave their range.
  std::vector<double> z(9, 0.1);
  z.push_back(std::nextafter(0.1, 1));
  const double mean = elevation(z, DuplicatePolicy::mean);
  EXPECT_GE(mean, z.front());
  EXPECT_LE(mean, z.back());
}

TEST(MergeSites, MeanDoesNotDependOnTheOrderOfRows) {
  std::vector<double> z = {0.1, 1e16, -1e16, 0.3, 7e-9, 0.7};
  std::sort(z.begin(), z.end());
  const double expected = elevation(z, DuplicatePolicy::mean);
  do {
    ASSERT_EQ(elevation(z, DuplicatePolicy::mean), expected);
  } while (std::next_permutation(z.begin(), z.end()));
}

TEST(MergeSites, NegativeZeroIsZero) {
  const std::vector<Point3> points = {{0.0, -0.0, 3}, {-0.0, 0.0, 1}, {0.0, 0.0, 2}, {1, 1, 1}};
  const MergedSites sites = merge(points, DuplicatePolicy::lowest);
  EXPECT_EQ(sites.xy.size(), 2u);
  EXPECT_EQ(sites.merged, (Merges{{0, 1}, {2, 1}}));
  EXPECT_EQ(row({0.0, -0.0}, DuplicatePolicy::lowest), 1u);  // equal: the first, not the one with the sign
  EXPECT_EQ(row({-0.0, 0.0}, DuplicatePolicy::highest), 1u);
}

TEST(MergeSites, RefusesDuplicatesIfAsked) {
  const std::vector<Point3> points = {{4, 4, 1}, {0, 0, 1}, {1, 0, 1}, {0, 0, 2}, {-0.0, 0, 3}};
  const auto refused = merge_sites(points, DuplicatePolicy::error, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::duplicate_points);
  EXPECT_EQ(refused.error().rows, (Rows{1, 3, 4}));
  EXPECT_NE(refused.error().message.find("rows 1 and 3"), std::string::npos);
}

TEST(MergeSites, NamesTheRowsThatAreNotFinite) {
  const std::vector<Point3> points = {
      {0, 0, 0}, {kNan, 0, 0}, {0, kInfinity, 0}, {0, 1, -kInfinity}, {1, 1, 1}};
  const auto refused = merge_sites(points, DuplicatePolicy::lowest, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::not_finite);
  EXPECT_EQ(refused.error().rows, (Rows{1, 2, 3}));
  EXPECT_NE(refused.error().message.find("row 1 "), std::string::npos);
}

TEST(MergeSites, NamesTheFirstTenOfManyRows) {
  std::vector<Point3> points(20, {kNan, 0, 0});
  points[0] = points[3] = {1, 2, 3};
  const auto refused = merge_sites(points, DuplicatePolicy::lowest, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().rows, (Rows{1, 2, 4, 5, 6, 7, 8, 9, 10, 11}));
}

/// So many rows that they are shared among threads; one of them, in the last share, is not finite.
TEST(MergeSites, LooksAtEveryRowOfMany) {
  std::vector<Point3> points;
  for (int i = 0; i < 300'000; ++i) points.push_back({double(i % 600), double(i / 600), double(i)});
  const MergedSites sites = merge_sites(points, DuplicatePolicy::error, 3).value();
  ASSERT_EQ(sites.row.size(), points.size());
  for (std::size_t s = 0; s < points.size(); ++s) {
    ASSERT_EQ(sites.z[s], sites.row[s]);
    ASSERT_EQ(sites.xy[s], (Point2{points[sites.row[s]].x, points[sites.row[s]].y}));
  }
  points[299'998].z = kInfinity;
  EXPECT_EQ(merge_sites(points, DuplicatePolicy::error, 3).error().rows, Rows{299'998});
}

TEST(MergeSites, OfNothingIsNothing) {
  const MergedSites sites = merge({}, DuplicatePolicy::lowest);
  EXPECT_TRUE(sites.xy.empty());
  EXPECT_TRUE(sites.row.empty());
  EXPECT_TRUE(sites.merged.empty());
}

/// Against a map, under every policy and after a permutation of the rows.
RC_GTEST_PROP(MergeSitesLaws, AgreeWithTheDefinition, ()) {
  const auto count = support::random_index(40);
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < count; ++i) {
    points.push_back({double(support::random_index(4)), double(support::random_index(4)) - 1,
                      double(support::random_index(5))});
  }
  std::map<std::pair<double, double>, Rows> groups;
  for (std::uint32_t i = 0; i < count; ++i) groups[{points[i].x, points[i].y}].push_back(i);
  for (const auto policy : {DuplicatePolicy::lowest, DuplicatePolicy::highest, DuplicatePolicy::first,
                            DuplicatePolicy::last, DuplicatePolicy::mean}) {
    const MergedSites sites = merge(points, policy);
    RC_ASSERT(sites.row.size() == groups.size());
    RC_ASSERT(sites.merged.size() == count - groups.size());
    for (std::size_t s = 0; s < sites.row.size(); ++s) {
      const Rows& group = groups[{sites.xy[s].x, sites.xy[s].y}];
      std::uint32_t expected = policy == DuplicatePolicy::last ? group.back() : group.front();
      for (const std::uint32_t r : group) {
        if (policy == DuplicatePolicy::lowest && points[r].z < points[expected].z) expected = r;
        if (policy == DuplicatePolicy::highest && points[r].z > points[expected].z) expected = r;
      }
      RC_ASSERT(sites.row[s] == expected);
      if (policy != DuplicatePolicy::mean) RC_ASSERT(sites.z[s] == points[expected].z);
      for (const std::uint32_t r : group) {
        const std::pair merge{r, expected};
        RC_ASSERT(std::count(sites.merged.begin(), sites.merged.end(), merge) == (r != expected));
      }
    }
    RC_ASSERT(std::is_sorted(sites.merged.begin(), sites.merged.end()));
  }
}

/// Where the policy does not look at rows, the places and elevations do not depend on their order.
RC_GTEST_PROP(MergeSitesLaws, DoNotDependOnTheOrderOfRows, ()) {
  const auto count = support::random_index(40) + 1;
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < count; ++i) {
    points.push_back({double(support::random_index(5)), double(support::random_index(3)),
                      double(support::random_index(1000)) / 7});
  }
  const auto order = support::permutation(count, support::random_index(1u << 30));
  std::vector<Point3> moved(count);
  for (std::uint32_t i = 0; i < count; ++i) moved[order[i]] = points[i];
  for (const auto policy : {DuplicatePolicy::lowest, DuplicatePolicy::highest, DuplicatePolicy::mean}) {
    const MergedSites a = merge(points, policy), b = merge(moved, policy);
    RC_ASSERT(a.xy == b.xy);
    RC_ASSERT(a.z == b.z);
    RC_ASSERT(a.keys == b.keys);
  }
}

}  // namespace
