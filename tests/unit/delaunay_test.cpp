/// The canonical Delaunay triangulation by example: errors, duplicates, ties, extremes, and sizes that need
/// threads and cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "kernel/delaunay_sites.hpp"
#include "kernel/spatial_order.hpp"
#include "support/delaunay_check.hpp"
#include "support/ordered_sites.hpp"
#include "support/random.hpp"
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
  std::vector<Point2> twice = points;
  twice.insert(twice.end(), points.begin(), points.end());
  EXPECT_EQ(support::OrderedSites(points).sites, support::OrderedSites(twice).sites);
}

TEST(SpatialOrder, FindsDuplicatesInACrowdedCell) {
  support::Random random(3);
  std::vector<Point2> points = {{0, 0}, {1, 1}};
  for (int i = 0; i < 100; ++i) {
    points.push_back({0.3 + 1e-9 * random.unit(), 0.7 + 1e-9 * random.unit()});
  }
  EXPECT_EQ(thalweg::detail::spatial_order(points, 1).site_count(), 102u);
  points.push_back(points[50]);
  const auto order = thalweg::detail::spatial_order(points, 1);
  EXPECT_EQ(order.site_count(), 102u);
  EXPECT_FALSE(order.distinct());
}

/// Of integers in a box of 2^16 units, x in the odd bits and y in the even ones; and of the same far from
/// zero, at other scales, and in a box that is not square.
TEST(SpatialOrder, KeysAreTheBitsOfBothCoordinates) {
  support::Random random(31);
  std::vector<std::array<std::uint32_t, 2>> cells = {{0, 0}, {65536, 65536}};
  for (int i = 0; i < 200; ++i) cells.push_back({random.below(65536), random.below(i % 2 == 0 ? 65536 : 9)});
  for (const double scale : {1.0, 0x1p-1060, 0x1p1007, 0x1p-510, 0x1p-40}) {
    for (const double shift : {0.0, -65536.0, 1000.0}) {
      std::vector<Point2> points;
      for (const auto& [x, y] : cells) points.push_back({scale * (x + shift), scale * (y + shift)});
      std::vector<std::uint32_t> keys(points.size());
      thalweg::detail::morton_keys(points, keys);
      for (std::size_t i = 0; i < cells.size(); ++i) {
        std::uint32_t expected = 0;
        for (std::uint32_t bit = 0; bit < 16; ++bit) {
          expected |= (std::min(cells[i][0], 65535u) >> bit & 1) << (2 * bit + 1);
          expected |= (std::min(cells[i][1], 65535u) >> bit & 1) << (2 * bit);
        }
        ASSERT_EQ(keys[i], expected) << scale << " " << shift << " " << cells[i][0] << " " << cells[i][1];
      }
    }
  }
}

/// Sets that ranges of keys divide well and badly.
std::vector<std::vector<Point2>> sets_to_order() {
  std::vector<std::vector<Point2>> sets;
  for (const std::uint32_t count : {1u, 2047u, 2049u, 70'000u})
    sets.push_back(support::point_set(Kind::uniform, count, 7));
  sets.push_back(support::point_set(Kind::clusters, 200'000, 23));  // enough for three parts
  sets.back().back() = sets.back().front();
  sets.push_back(support::point_set(Kind::uniform, 150'000, 11));
  sets.back()[77'777] = {1e9, -1e12};  // all others in one cell
  sets.emplace_back(140'000, Point2{3, -5});
  sets.emplace_back();
  for (std::uint32_t i = 0; i < 150'000; ++i)  // a quarter of the places twice
    sets.back().push_back({static_cast<double>(i % 100), static_cast<double>(i * 7 % 120'000)});
  return sets;
}

TEST(SpatialOrder, HasEveryRowAtItsSiteInTheOrderOfKeys) {
  for (const std::vector<Point2>& points : sets_to_order()) {
    const auto order = thalweg::detail::spatial_order(points, 2);
    std::vector<std::uint32_t> keys(points.size());
    thalweg::detail::morton_keys(points, keys);
    std::vector<char> met(points.size(), 0);
    for (std::uint32_t s = 0; s < order.site_count(); ++s) {
      const std::uint32_t begin = order.distinct() ? s : order.starts[s];
      const std::uint32_t end = order.distinct() ? s + 1 : order.starts[s + 1];
      ASSERT_LT(begin, end);
      for (std::uint32_t i = begin; i < end; ++i) {
        const std::uint32_t row = order.rows[i];
        ASSERT_EQ(points[row], order.sites[s]);
        ASSERT_EQ(keys[row], order.keys[s]);
        ASSERT_EQ(std::exchange(met[row], 1), 0);
        ASSERT_TRUE(i == begin || order.rows[i - 1] < row);
      }
    }
    ASSERT_EQ(std::ranges::count(met, 1), static_cast<std::ptrdiff_t>(points.size()));
    EXPECT_TRUE(std::ranges::is_sorted(order.keys));
    std::set<std::pair<double, double>> places;
    for (const Point2 p : points) places.insert({p.x, p.y});
    EXPECT_EQ(order.site_count(), places.size());
  }
}

TEST(SpatialOrder, IsTheSameForAnyNumberOfThreads) {
  for (const std::vector<Point2>& points : sets_to_order()) {
    const auto order = thalweg::detail::spatial_order(points, 1);
    for (const unsigned threads : {2u, 3u}) {
      const auto other = thalweg::detail::spatial_order(points, threads);
      EXPECT_TRUE(std::ranges::equal(order.rows, other.rows)) << threads;
      EXPECT_TRUE(std::ranges::equal(order.keys, other.keys)) << threads;
      EXPECT_TRUE(std::ranges::equal(order.sites, other.sites)) << threads;
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

TEST(Delaunay, OfSitesHasAVertexForEach) {
  for (const std::uint32_t n : {3u, 4u, 100u, 20000u}) {
    const std::vector<Point2> points = support::point_set(Kind::uniform, n, 3);
    const auto order = thalweg::detail::spatial_order(points, 1);
    thalweg::detail::Array<Point2> sites;
    for (const std::uint32_t row : order.rows) sites.push_back(points[row]);
    for (const unsigned threads : {1u, 2u}) {
      const auto t = thalweg::detail::delaunay_of_sites(sites, order.keys, threads);
      ASSERT_TRUE(t);
      EXPECT_EQ(t->vertex_count(), n);
    }
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

TEST(Delaunay, CellsAtTheLimitOfBeingCrowded) {
  support::Random random(5);
  std::vector<Point2> points = {{0, 0}, {1, 1}};
  while (points.size() < 65) {
    points.push_back({0.3 + 1e-9 * random.unit(), 0.7 + 1e-9 * random.unit()});
    if (points.size() < 45) continue;
    const auto t = delaunay(points);
    ASSERT_TRUE(t);
    EXPECT_EQ(support::fault_of(points, *t), "") << points.size();
  }
}

/// A crowd at the corner of boxes within boxes, one more than are looked into.
TEST(Delaunay, CrowdBelowTheLastLevel) {
  for (int levels = 1; levels <= 6; ++levels) {
    support::Random random(7);
    std::vector<Point2> points;
    for (int level = 0; level < levels; ++level) {
      const double size = std::ldexp(1, -20 * level);
      points.insert(points.end(), {{size, 0}, {0, size}});
    }
    const double size = std::ldexp(1, -20 * levels);
    for (int i = 0; i < 120; ++i) points.push_back({size * random.unit(), size * random.unit()});
    const auto t = delaunay(points);
    ASSERT_TRUE(t);
    EXPECT_EQ(support::fault_of(points, *t), "") << levels;
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

/// Most faces have a corner in another thread's part of the sites, and the last merge is begun at many edges.
TEST(Delaunay, SameArraysForACurveOnTwoThreads) {
  const auto points = support::point_set(Kind::parabola, 70000, 23);
  const auto one = delaunay(points), two = delaunay(points, {.threads = 2});
  ASSERT_TRUE(one && two);
  EXPECT_EQ(*one, *two);
  for (std::uint32_t v = 0; v < one->vertex_count(); ++v)
    ASSERT_EQ(one->outgoing(VertexId(v)), two->outgoing(VertexId(v)));
}

TEST(Delaunay, SameArraysForAnyNumberOfThreads) {
  for (const Kind kind :
       {Kind::uniform, Kind::wide_grid, Kind::ring, Kind::parabola, Kind::clusters, Kind::utm}) {
    const auto points = support::point_set(kind, 100000, 17);
    const auto t = delaunay(points);
    ASSERT_TRUE(t);
    std::vector<thalweg::HalfedgeId> outgoing(t->vertex_count());  // along the hull, or else the first
    for (std::uint32_t h = t->halfedge_count(); h-- > 0;) {
      thalweg::HalfedgeId& of_vertex = outgoing[t->origin(thalweg::HalfedgeId(h)).index()];
      if (!of_vertex.valid() || !t->on_hull(of_vertex)) of_vertex = thalweg::HalfedgeId(h);
    }
    for (unsigned threads = 0; threads <= 8; ++threads) {
      const auto u = delaunay(points, {.threads = threads});
      ASSERT_TRUE(u);
      EXPECT_EQ(*t, *u) << threads << " threads, kind " << static_cast<int>(kind);
      for (std::uint32_t v = 0; v < t->vertex_count(); ++v) {
        ASSERT_EQ(u->outgoing(VertexId(v)), outgoing[v]) << threads << " threads";
      }
    }
  }
}

}  // namespace
