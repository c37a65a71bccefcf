/// The canonical Delaunay triangulation by example: errors, duplicates, ties, extremes, and sizes that need
/// threads and cells.
#include <gtest/gtest.h>

#include <algorithm>

#include "kernel/spatial_order.hpp"
#include "support/delaunay_check.hpp"
#include "thalweg/delaunay.hpp"

namespace {

using support::Kind;
using thalweg::delaunay;
using thalweg::ErrorCode;
using thalweg::Point2;
using thalweg::VertexId;

TEST(SpatialOrder, IsEmptyWithoutPoints) {
  const auto order = thalweg::detail::spatial_order({}, 1);
  EXPECT_TRUE(order.rows.empty());
  EXPECT_TRUE(order.distinct());
  EXPECT_EQ(order.site_count(), 0u);
}

TEST(SpatialOrder, TakesZerosOfBothSignsForEqual) {
  const std::vector<Point2> points = {{1, 1}, {0.0, -0.0}, {-0.0, 0.0}};
  const auto order = thalweg::detail::spatial_order(points, 1);
  EXPECT_TRUE(std::ranges::equal(order.rows, std::vector<std::uint32_t>{1, 2, 0}));
  EXPECT_EQ(order.starts, (std::vector<std::uint32_t>{0, 2, 3}));
}

TEST(SpatialOrder, DoesNotLetDuplicatesDecideHowACellIsOrdered) {
  // Forty sites of one cell, few enough for lexicographic order even when each comes twice.
  std::vector<Point2> points = support::point_set(Kind::one_cell, 41, 5);
  points[32] = {5, 5};
  const auto sites_of = [](const std::vector<Point2>& p) {
    const auto order = thalweg::detail::spatial_order(p, 1);
    std::vector<Point2> sites;
    for (std::uint32_t s = 0; s < order.site_count(); ++s) sites.push_back(p[order.first_row(s)]);
    return sites;
  };
  std::vector<Point2> twice = points;
  twice.insert(twice.end(), points.begin(), points.end());
  EXPECT_EQ(sites_of(points), sites_of(twice));
}

TEST(SpatialOrder, IsTheSameForAnyNumberOfThreads) {
  for (const Kind kind : {Kind::uniform, Kind::clusters}) {
    const auto points = support::point_set(kind, 200000, 23);  // enough for three parts
    const auto order = thalweg::detail::spatial_order(points, 1);
    for (const unsigned threads : {2u, 3u, 8u}) {
      const auto other = thalweg::detail::spatial_order(points, threads);
      EXPECT_TRUE(std::ranges::equal(order.rows, other.rows)) << threads;
      EXPECT_TRUE(std::ranges::equal(order.keys, other.keys)) << threads;
      EXPECT_EQ(order.starts, other.starts) << threads;
    }
  }
}

TEST(Delaunay, NamesRowsThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const std::vector<Point2> points = {{infinity, 1}, {0, 0}, {nan, 0}, {1, 0}, {0, -infinity}, {0, 1}};
  const auto t = delaunay(points);
  ASSERT_FALSE(t);
  EXPECT_EQ(t.error().code, ErrorCode::not_finite);
  EXPECT_EQ(t.error().rows, (std::vector<std::uint32_t>{0, 2, 4}));
}

TEST(Delaunay, NeedsThreeDistinctPoints) {
  EXPECT_EQ(delaunay({}).error().code, ErrorCode::too_few_points);
  EXPECT_EQ(delaunay(std::vector<Point2>{{1, 2}}).error().code, ErrorCode::too_few_points);
  EXPECT_EQ(delaunay(std::vector<Point2>(7, {1, 2})).error().code, ErrorCode::too_few_points);
  EXPECT_EQ(delaunay(std::vector<Point2>{{1, 2}, {0, 0}, {1, 2}}).error().code, ErrorCode::too_few_points);
}

TEST(Delaunay, NeedsATriangle) {
  std::vector<Point2> points;
  for (int i = 0; i < 5000; ++i) points.push_back({i * 3.0, i * -7.0});
  EXPECT_EQ(delaunay(points).error().code, ErrorCode::all_collinear);
  points.push_back({1, 0});
  EXPECT_EQ(delaunay(points)->face_count(), 4999u);
}

TEST(Delaunay, OneTriangle) {
  const std::vector<Point2> points = {{0, 0}, {0, 1}, {1, 0}};
  const auto t = delaunay(points);
  ASSERT_TRUE(t);
  EXPECT_EQ(t->face_count(), 1u);
  EXPECT_EQ(support::fault_of(points, *t), "");
}

TEST(Delaunay, DiagonalOfASquareAvoidsTheLargestCorner) {
  const std::vector<Point2> points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto t = delaunay(points);
  ASSERT_TRUE(t);
  EXPECT_TRUE(t->joined(VertexId(1), VertexId(3)));
  EXPECT_FALSE(t->joined(VertexId(0), VertexId(2)));
}

TEST(Delaunay, FirstOfEqualPointsIsTheVertex) {
  const std::vector<Point2> points = {{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 0}, {-0.0, 0}};
  const auto t = delaunay(points);
  ASSERT_TRUE(t);
  EXPECT_EQ(t->vertex_count(), 6u);
  EXPECT_EQ(support::fault_of(points, *t), "");
}

TEST(Delaunay, EveryKindOfPointsInTheHundreds) {
  for (int kind = 0; kind < static_cast<int>(Kind::kinds); ++kind) {
    const auto points = support::point_set(static_cast<Kind>(kind), 700, 11);
    const auto t = delaunay(points);
    if (!t) {
      EXPECT_EQ(kind, static_cast<int>(Kind::signed_zeros)) << t.error().message;
      continue;
    }
    EXPECT_EQ(support::fault_of(points, *t), "") << "kind " << kind;
  }
}

TEST(Delaunay, CrowdedCellsWithinCrowdedCells) {
  for (const Kind kind : {Kind::one_cell, Kind::clusters, Kind::spiral, Kind::far_clusters, Kind::flat_box}) {
    const auto points = support::point_set(kind, 20000, 3);
    const auto t = delaunay(points);
    ASSERT_TRUE(t);
    EXPECT_EQ(support::fault_of(points, *t), "") << "kind " << static_cast<int>(kind);
  }
}

TEST(Delaunay, FullGridInAnyOrderOfRows) {
  std::vector<Point2> rows, columns;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) {
      rows.push_back({static_cast<double>(i), static_cast<double>(j)});
      columns.push_back({static_cast<double>(j), static_cast<double>(i)});
    }
  }
  const auto t = delaunay(rows);
  const auto u = delaunay(columns);
  ASSERT_TRUE(t);
  ASSERT_TRUE(u);
  EXPECT_EQ(t->face_count(), 2u * 99 * 99);
  EXPECT_EQ(support::fault_of(rows, *t), "");
  EXPECT_EQ(support::triangle_set(rows, *t), support::triangle_set(columns, *u));
}

TEST(Delaunay, SameArraysForAnyNumberOfThreads) {
  for (const Kind kind : {Kind::uniform, Kind::wide_grid, Kind::clusters, Kind::utm}) {
    const auto points = support::point_set(kind, 100000, 17);
    const auto t = delaunay(points);
    ASSERT_TRUE(t);
    for (unsigned threads = 0; threads <= 8; ++threads) {
      const auto u = delaunay(points, {.threads = threads});
      ASSERT_TRUE(u);
      EXPECT_EQ(*t, *u) << threads << " threads, kind " << static_cast<int>(kind);
      for (std::uint32_t v = 0; v < t->vertex_count(); ++v) {
        ASSERT_EQ(t->outgoing(VertexId(v)), u->outgoing(VertexId(v))) << threads << " threads";
      }
    }
  }
}

}  // namespace
