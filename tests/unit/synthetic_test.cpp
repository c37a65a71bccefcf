/// Synthetic terrain: the same points on every machine, and of each kind what it is meant to try.
#include "io/synthetic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/random_segments.hpp"
#include "oracle/plane.hpp"
#include "thalweg/minimize.hpp"

namespace {

using thalweg::ErrorCode;
using thalweg::Point3;
using thalweg::io::synthetic_terrain;
using thalweg::io::TerrainKind;

constexpr TerrainKind kKinds[] = {TerrainKind::fractal, TerrainKind::ridge, TerrainKind::plateau,
                                  TerrainKind::ring,    TerrainKind::grid,  TerrainKind::lidar};

std::vector<Point3> terrain(TerrainKind kind, std::uint64_t count, std::uint64_t seed = 1) {
  return synthetic_terrain(kind, count, seed).value();
}

/// FNV-1a over the bits of all coordinates.
std::uint64_t fingerprint(const std::vector<Point3>& points) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const Point3& p : points) {
    for (const double c : {p.x, p.y, p.z}) hash = (hash ^ std::bit_cast<std::uint64_t>(c)) * 0x100000001b3u;
  }
  return hash;
}

/// Written down once: a change would change everybody's data, a difference between machines shows here.
TEST(Synthetic, IsTheSameEverywhere) {
  const std::uint64_t expected[] = {0x426de7d3fabd1618, 0x9ea4686baac82d25, 0x8c60157c67421a4a,
                                    0x5aae75f5da464b85, 0x719aaba3b249a9d4, 0xe4651b9989e99d95};
  for (std::size_t i = 0; i < std::size(kKinds); ++i) {
    EXPECT_EQ(fingerprint(terrain(kKinds[i], 1000)), expected[i])
        << name_of(kKinds[i]) << " " << std::hex << fingerprint(terrain(kKinds[i], 1000));
  }
}

TEST(Synthetic, HasAsManyDistinctPlacesAsAskedFor) {
  for (const TerrainKind kind : kKinds) {
    for (const std::uint64_t count : {3u, 10u, 325u, 5000u}) {
      const auto points = terrain(kind, count);
      std::set<std::pair<double, double>> places;
      for (const Point3& p : points) {
        EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        places.emplace(p.x, p.y);
      }
      EXPECT_EQ(places.size(), count) << name_of(kind);
    }
  }
}

TEST(Synthetic, SeedsDiffer) {
  for (const TerrainKind kind : kKinds) {
    EXPECT_NE(fingerprint(terrain(kind, 100, 1)), fingerprint(terrain(kind, 100, 2))) << name_of(kind);
  }
}

TEST(Synthetic, NamesAndKindsCorrespond) {
  for (const TerrainKind kind : kKinds) EXPECT_EQ(thalweg::io::terrain_kind(name_of(kind)), kind);
  EXPECT_FALSE(thalweg::io::terrain_kind("flat"));
}

TEST(Synthetic, RefusesTooFewAndTooMany) {
  EXPECT_EQ(synthetic_terrain(TerrainKind::grid, 2, 1).error().code, ErrorCode::too_few_points);
  EXPECT_EQ(synthetic_terrain(TerrainKind::grid, 0xffffffffu, 1).error().code, ErrorCode::too_many_points);
}

thalweg::Minimized build(const std::vector<Point3>& points, unsigned order) {
  thalweg::MinimizeOptions options;
  options.order = order;
  options.threads = 1;
  return thalweg::minimize_pits(points, options).value();
}

double share_of_pits(TerrainKind kind) {
  constexpr std::uint64_t kCount = 20000;
  return build(terrain(kind, kCount), 0).delaunay_pits.total / static_cast<double>(kCount);
}

TEST(Synthetic, FractalIsAsRoughAsRealGround) {
  EXPECT_GT(share_of_pits(TerrainKind::fractal), 0.03);
  EXPECT_LT(share_of_pits(TerrainKind::fractal), 0.05);
}

TEST(Synthetic, RidgesDamManyValleys) {
  const auto points = terrain(TerrainKind::ridge, 2000);
  const thalweg::Minimized m = build(points, 8);
  EXPECT_GT(m.delaunay_pits.total, 100u);
  EXPECT_LT(m.pits.total * 4, m.delaunay_pits.total * 3);
}

TEST(Synthetic, PlateausHaveAFewElevations) {
  std::set<double> elevations;
  for (const Point3& p : terrain(TerrainKind::plateau, 5000)) elevations.insert(p.z);
  EXPECT_GE(elevations.size(), 5u);
  EXPECT_LE(elevations.size(), 24u);
}

TEST(Synthetic, RingsAreCocircularExactly) {
  const auto points = terrain(TerrainKind::ring, 648);
  const auto distance = [](const Point3& p) { return p.x * p.x + p.y * p.y; };
  constexpr double kSquare = 32045.0 * 32045.0;
  EXPECT_TRUE(std::all_of(points.begin(), points.begin() + 324,
                          [&](const Point3& p) { return distance(p) == kSquare; }));
  EXPECT_TRUE(std::all_of(points.begin() + 324, points.end(), [&](const Point3& p) {
    return distance(p) != kSquare && std::fabs(std::sqrt(distance(p)) - 32045) < 1;
  }));
}

TEST(Synthetic, GridsAreFull) {
  const auto points = terrain(TerrainKind::grid, 900);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].x, static_cast<double>(i % 30));
    EXPECT_EQ(points[i].y, static_cast<double>(i / 30));
  }
}

TEST(Synthetic, LidarIsInCentimetresAtUtmCoordinates) {
  for (const Point3& p : terrain(TerrainKind::lidar, 3000)) {
    EXPECT_GT(p.x, 490000);
    EXPECT_GT(p.y, 4000000);
    for (const double c : {p.x, p.y, p.z}) EXPECT_EQ(std::floor(c * 100 + 0.5) / 100, c);
  }
}

TEST(RandomSegments, AreInGeneralPosition) {
  for (const std::uint32_t count : {2u, 10u, 50u}) {
    const auto segments = thalweg::io::random_segments(count, 7).value();
    ASSERT_EQ(segments.size(), count);
    std::vector<oracle::Site> ends;
    for (const auto& [a, b] : segments) {
      ends.push_back({a.x, a.y, 0});
      ends.push_back({b.x, b.y, 0});
    }
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) ASSERT_NE(oracle::turn(ends[i], ends[j], ends[k]), 0);
      }
    }
  }
  EXPECT_EQ(thalweg::io::random_segments(201, 1).error().code, ErrorCode::invalid_argument);
}

}  // namespace
