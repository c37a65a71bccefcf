/// The hard instances: what their proofs rest on, by definition and in exact arithmetic, and that the fewest
/// pits are 2n minus the largest set of non-crossing segments.
#include "thalweg/hard_instances.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "io/random_segments.hpp"
#include "oracle/exact_predicates.hpp"
#include "oracle/terrain.hpp"
#include "thalweg/minimize.hpp"

namespace {

using thalweg::corollary2_instance;
using thalweg::ErrorCode;
using thalweg::HardInstance;
using thalweg::LatticePoint;
using thalweg::LatticeSegment;
using thalweg::Method;
using thalweg::Point2;
using thalweg::Point3;
using thalweg::theorem1_instance;

using Segments = std::vector<LatticeSegment>;

Segments random_segments(std::uint32_t count, std::uint64_t seed) {
  return thalweg::io::random_segments(count, seed).value();
}

oracle::Site site(LatticePoint p) {
  return {p.x, p.y, 0};
}

bool cross(const LatticeSegment& s, const LatticeSegment& t) {
  return oracle::cross(site(s.a), site(s.b), site(t.a), site(t.b));
}

/// The most segments no two of which cross, by looking at every set of them.
unsigned largest_plane_subset(const Segments& segments) {
  int best = 0;
  for (unsigned set = 0; set < 1u << segments.size(); ++set) {
    bool plane = true;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if ((set >> i & set >> j & 1) != 0 && cross(segments[i], segments[j])) plane = false;
      }
    }
    if (plane) best = std::max(best, std::popcount(set));
  }
  return static_cast<unsigned>(best);
}

unsigned fewest_pits(const Segments& segments) {
  return 2 * static_cast<unsigned>(segments.size()) - largest_plane_subset(segments);
}

/// That minimising pits solves the problem of the segments, and says that it has.
void expect_solved(const Segments& segments, const HardInstance& instance) {
  for (const Method method : {Method::best, Method::exact}) {
    thalweg::MinimizeOptions options;
    options.order = instance.order;
    options.method = method;
    options.threads = 1;
    const auto result = thalweg::minimize_pits(instance.points, options);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->pits.total, fewest_pits(segments));
    EXPECT_TRUE(result->certified);
    EXPECT_LE(*std::ranges::max_element(result->face_orders), instance.order);
  }
}

bool partners(std::uint32_t a, std::uint32_t b) {
  return a / 2 == b / 2;
}

std::string place(const Segments& segments) {
  std::string text;
  for (const auto& [a, b] : segments) {
    text += "{{" + std::to_string(a.x) + ", " + std::to_string(a.y) + "}, {" + std::to_string(b.x) + ", " +
            std::to_string(b.y) + "}}, ";
  }
  return text;
}

/// Laws (a), (b), (c) of the proof of Theorem 1.
void expect_shielded(const HardInstance& instance) {
  const auto sites = oracle::sites_of(std::span<const Point3>(instance.points));
  const std::uint32_t ends = 2 * instance.segments;
  for (std::uint32_t a = 0; a < ends; ++a) {
    for (std::uint32_t b = a + 1; b < ends; ++b) {
      EXPECT_EQ(oracle::is_open_pair(sites, a, b), partners(a, b)) << a << " " << b;
    }
  }
  for (std::size_t i = 0; i < sites.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(sites[i].x == sites[j].x && sites[i].y == sites[j].y) << i << " " << j;
    }
  }
}

TEST(Theorem1, ShieldsExactlyTheEndsThatAreNotPartners) {
  for (std::uint32_t n = 2; n <= 6; ++n) {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Segments segments = random_segments(n, seed);
      SCOPED_TRACE(place(segments));
      const auto instance = theorem1_instance(segments);
      ASSERT_TRUE(instance) << instance.error().message;
      EXPECT_EQ(instance->shields, 2 * n * (2 * n - 2));
      EXPECT_EQ(instance->points.size(), 2 * n + instance->shields);
      EXPECT_EQ(instance->order, instance->points.size() - 3);
      expect_shielded(*instance);
    }
  }
}

TEST(Theorem1, PutsTheEndsWhereTheCallerSaidTimesTheScale) {
  const Segments segments = random_segments(4, 9);
  const HardInstance instance = theorem1_instance(segments).value();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto scaled = [&](std::int64_t c) { return static_cast<double>(c * instance.scale); };
    EXPECT_EQ(instance.points[2 * i], (Point3{scaled(segments[i].a.x), scaled(segments[i].a.y), 1}));
    EXPECT_EQ(instance.points[2 * i + 1], (Point3{scaled(segments[i].b.x), scaled(segments[i].b.y), 2}));
  }
  for (std::size_t i = 8; i < instance.points.size(); ++i) EXPECT_EQ(instance.points[i].z, 3);
}

/// As in the paper: shields are nearer to their end than a third of the least distance of two ends.
TEST(Theorem1, PutsShieldsWithinTheCircleOfThePaper) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const HardInstance instance = theorem1_instance(random_segments(5, seed)).value();
    const auto sites = oracle::sites_of(std::span<const Point3>(instance.points));
    const auto square = [&](std::size_t i, std::size_t j) {
      const std::int64_t x = sites[i].x - sites[j].x, y = sites[i].y - sites[j].y;
      return x * x + y * y;
    };
    std::int64_t least = square(0, 1);
    for (std::size_t i = 0; i < 10; ++i) {
      for (std::size_t j = 0; j < i; ++j) least = std::min(least, square(i, j));
    }
    for (std::size_t h = 10; h < sites.size(); ++h) {
      EXPECT_EQ(
          std::ranges::count_if(std::vector{0, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                                [&](int e) { return 9 * square(h, static_cast<std::size_t>(e)) < least; }),
          1);
    }
  }
}

TEST(Theorem1, HasTheFewestPitsOfEveryTriangulationEnumerated) {
  const Segments crossing = {{{0, 0}, {7, 5}}, {{1, 6}, {5, 0}}};
  const Segments apart = {{{0, 0}, {7, 1}}, {{1, 6}, {5, 4}}};
  for (const Segments& segments : {crossing, apart, random_segments(2, 1), random_segments(2, 2)}) {
    const HardInstance instance = theorem1_instance(segments).value();
    const auto sites = oracle::sites_of(std::span<const Point3>(instance.points));
    EXPECT_EQ(oracle::fewest_pits(sites).back(), fewest_pits(segments));
  }
}

TEST(Theorem1, IsSolvedAtEveryOrder) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const HardInstance instance = theorem1_instance(random_segments(2, seed)).value();
    const auto fewest = oracle::fewest_pits(oracle::sites_of(std::span<const Point3>(instance.points)));
    for (unsigned k = 0; k < fewest.size(); ++k) {
      thalweg::MinimizeOptions options;
      options.order = k;
      options.method = Method::exact;
      const auto result = thalweg::minimize_pits(instance.points, options).value();
      EXPECT_EQ(result.pits.total, fewest[k]) << "order " << k << ", seed " << seed;
      EXPECT_TRUE(result.certified);
    }
  }
}

TEST(Theorem1, IsSolvedForKnownArrangements) {
  const Segments star = {{{-10, -1}, {10, 2}}, {{-1, -10}, {2, 10}}, {{-7, 8}, {8, -7}}};
  const Segments ladder = {{{0, 0}, {30, 1}}, {{1, 10}, {31, 9}}, {{2, 20}, {29, 22}}};
  const Segments comb = {{{0, 0}, {40, 3}}, {{5, -5}, {6, 7}}, {{15, -6}, {16, 9}}, {{25, -7}, {24, 8}}};
  EXPECT_EQ(fewest_pits(star), 5u);
  EXPECT_EQ(fewest_pits(ladder), 3u);
  EXPECT_EQ(fewest_pits(comb), 5u);
  for (const Segments& segments : {star, ladder, comb}) {
    expect_solved(segments, theorem1_instance(segments).value());
  }
}

TEST(Theorem1, IsSolvedForRandomSegments) {
  for (std::uint32_t n = 2; n <= 6; ++n) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Segments segments = random_segments(n, 100 + seed);
      SCOPED_TRACE(place(segments));
      expect_solved(segments, theorem1_instance(segments).value());
    }
  }
}

/// Ends in line with others need no shield against those behind; segments on one line are legal.
TEST(Theorem1, TakesCollinearEnds) {
  const Segments on_one_line = {{{0, 0}, {2, 0}}, {{5, 0}, {9, 0}}, {{3, 4}, {6, -3}}};
  const Segments grid = {{{0, 0}, {6, 6}}, {{0, 6}, {6, 0}}, {{0, 3}, {6, 3}}};
  for (const Segments& segments : {on_one_line, grid}) {
    const auto instance = theorem1_instance(segments);
    ASSERT_TRUE(instance) << instance.error().message;
    expect_shielded(*instance);
    expect_solved(segments, *instance);
  }
  EXPECT_LT(theorem1_instance(on_one_line)->shields, 24u);
}

/// Ends in rows a unit apart, so that all the ways along the axes begin with (1, 0), (0, 1), (-1, 0) or (0,
/// -1).
TEST(Theorem1, ShieldsThePairsWithNoEndBetween) {
  const Segments upright = {{{0, 0}, {0, 5}}, {{1, 0}, {1, 4}}, {{2, 0}, {2, 3}}, {{3, 0}, {4, 5}}};
  Segments lying = upright;
  for (auto& s : lying) s = {{s.a.y, s.a.x}, {s.b.y, s.b.x}};
  Segments lattice;
  for (std::int64_t x = 0; x < 4; ++x) {
    lattice.push_back({{x, 0}, {x, 1}});
    lattice.push_back({{x, 3}, {x, 2}});
  }
  for (const Segments& segments : {upright, lying, lattice}) {
    std::vector<LatticePoint> ends;
    for (const auto& s : segments) ends.insert(ends.end(), {s.a, s.b});
    const auto between = [&](LatticePoint r, LatticePoint p, LatticePoint q) {
      const LatticePoint u{p.x - r.x, p.y - r.y}, v{q.x - r.x, q.y - r.y};
      return u.x * v.y == u.y * v.x && u.x * v.x + u.y * v.y < 0;
    };
    std::size_t expected = 0;
    for (std::size_t p = 0; p < ends.size(); ++p) {
      for (std::size_t q = 0; q < ends.size(); ++q) {
        if (p / 2 == q / 2) continue;
        expected += std::ranges::none_of(ends, [&](LatticePoint r) { return between(r, ends[p], ends[q]); });
      }
    }
    const auto instance = theorem1_instance(segments);
    ASSERT_TRUE(instance) << instance.error().message;
    EXPECT_EQ(instance->shields, expected);
    expect_shielded(*instance);
  }
}

void expect_refused(const Segments& segments, const std::vector<std::uint32_t>& rows,
                    const std::string& part) {
  const auto instance = theorem1_instance(segments);
  ASSERT_FALSE(instance);
  EXPECT_EQ(instance.error().code, ErrorCode::invalid_argument);
  EXPECT_EQ(instance.error().rows, rows);
  EXPECT_NE(instance.error().message.find(part), std::string::npos) << instance.error().message;
}

TEST(Theorem1, RefusesSegmentsThatTouch) {
  expect_refused({{{0, 0}, {4, 4}}, {{9, 0}, {0, 9}}, {{2, 2}, {7, 1}}}, {2, 0}, "(2, 2) of segment 2");
  expect_refused({{{0, 0}, {4, 4}}, {{2, 2}, {9, 9}}, {{0, 9}, {1, 7}}}, {0, 1}, "lies on segment 1");
  expect_refused({{{0, 0}, {4, 4}}, {{9, 0}, {0, 9}}, {{4, 4}, {7, 1}}}, {0, 2}, "share the end (4, 4)");
  expect_refused({{{0, 0}, {4, 4}}, {{9, 1}, {9, 1}}}, {1}, "is a point");
}

TEST(Theorem1, RefusesWhatDoesNotFit) {
  const std::int64_t far = std::int64_t{1} << 29;
  expect_refused({{{0, 0}, {far, 1}}, {{1, 1}, {far - 1, far}}}, {}, "2^53");
  expect_refused({{{0, 0}, {4, 5}}, {{1, 1}, {far + 1, 7}}}, {1}, "2^29");
  expect_refused({{{0, 0}, {4, 5}}}, {}, "from 2 to 2048");
  expect_refused(Segments(2049), {}, "2049 segments");
  const auto line = theorem1_instance(Segments{{{0, 0}, {1, 1}}, {{2, 2}, {3, 3}}});
  ASSERT_FALSE(line);
  EXPECT_EQ(line.error().code, ErrorCode::all_collinear);
}

std::vector<Point2> places(const HardInstance& instance) {
  std::vector<Point2> result;
  for (const Point3& p : instance.points) result.push_back({p.x, p.y});
  return result;
}

unsigned count_inside(const std::vector<Point2>& sites, Point2 a, Point2 b, Point2 c) {
  return static_cast<unsigned>(
      std::ranges::count_if(sites, [&](Point2 p) { return oracle::incircle(a, b, c, p) > 0; }));
}

/// The useful order of two sites, by its definition. Requires: general position.
unsigned useful_order(const std::vector<Point2>& sites, Point2 a, Point2 b) {
  unsigned order = 0;
  for (const auto& [u, v] : {std::pair(a, b), std::pair(b, a)}) {
    const Point2* nearest = nullptr;
    for (const Point2& p : sites) {
      if (oracle::orient2d(u, v, p) <= 0) continue;
      if (nearest == nullptr || oracle::incircle(u, v, *nearest, p) > 0) nearest = &p;
    }
    if (nearest != nullptr) order = std::max(order, count_inside(sites, u, v, *nearest));
  }
  return order;
}

TEST(Corollary2, LetsNoEdgeJoinEndsThatAreNotPartners) {
  for (std::uint32_t n = 2; n <= 3; ++n) {
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const HardInstance instance = corollary2_instance(random_segments(n, seed)).value();
      EXPECT_EQ(instance.order, 2 * n * n);
      EXPECT_EQ(instance.shields, 2 * n * (n - 1));
      EXPECT_EQ(instance.guards, instance.shields * (instance.order + 1));
      const std::vector<Point2> sites = places(instance);
      for (std::uint32_t a = 0; a < 2 * n; ++a) {
        for (std::uint32_t b = a + 1; b < 2 * n; ++b) {
          EXPECT_EQ(useful_order(sites, sites[a], sites[b]) > instance.order, !partners(a, b))
              << a << " " << b;
        }
      }
    }
  }
}

TEST(Corollary2, HasNoThreeCollinearSites) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const std::vector<Point2> sites = places(corollary2_instance(random_segments(2, seed)).value());
    for (std::size_t i = 0; i < sites.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) ASSERT_NE(oracle::orient2d(sites[i], sites[j], sites[k]), 0);
      }
    }
  }
}

TEST(Corollary2, IsSolvedAtItsOrder) {
  for (std::uint32_t n = 2; n <= 4; ++n) {
    unsigned fitting = 0;
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      const Segments segments = random_segments(n, seed);
      SCOPED_TRACE(place(segments));
      const auto instance = corollary2_instance(segments);
      if (!instance) continue;
      ++fitting;
      expect_solved(segments, *instance);
    }
    EXPECT_GE(fitting, 9u);
  }
}

/// Shields at one fraction of all segments would be collinear here.
TEST(Corollary2, TakesSymmetricSegments) {
  const Segments star = {{{-10, -1}, {10, 2}}, {{-1, -10}, {2, 10}}, {{-7, 8}, {8, -7}}, {{20, 0}, {21, 9}}};
  const auto instance = corollary2_instance(star);
  ASSERT_TRUE(instance) << instance.error().message;
  expect_solved(star, *instance);
}

TEST(Corollary2, RefusesWhatIsTooLargeOrCollinear) {
  const auto many = corollary2_instance(random_segments(9, 1));
  ASSERT_FALSE(many);
  EXPECT_NE(many.error().message.find("23634 points"), std::string::npos) << many.error().message;
  const auto collinear =
      corollary2_instance(Segments{{{0, 0}, {5, 9}}, {{2, 0}, {7, 3}}, {{40, 0}, {9, 11}}});
  ASSERT_FALSE(collinear);
  EXPECT_EQ(collinear.error().rows, (std::vector<std::uint32_t>{0, 1, 2}));
  const auto slanted = corollary2_instance(Segments{{{1, 2}, {5, 9}}, {{30, 1}, {4, 4}}, {{7, 6}, {9, -11}}});
  ASSERT_FALSE(slanted);
  EXPECT_EQ(slanted.error().rows, (std::vector<std::uint32_t>{0, 1, 2}));
}

/// The square of the radius of the circle through three sites.
double squared_radius(Point2 a, Point2 b, Point2 c) {
  const auto square = [](Point2 p, Point2 q) {
    return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
  };
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return square(a, b) * square(b, c) * square(c, a) / (4 * area * area);
}

/// The four conditions at the head of guarded_instance.cpp.
TEST(Corollary2, MeetsTheConditionsOfItsProof) {
  for (std::uint32_t n = 2; n <= 4; ++n) {
    const HardInstance instance = corollary2_instance(random_segments(n, 3)).value();
    const std::vector<Point2> sites = places(instance);
    const std::span<const Point2> core = std::span(sites).first(2 * n + instance.shields);
    const std::span<const Point2> guards = std::span(sites).subspan(core.size());
    double reach = 0;  // the square of U
    std::size_t shield = 2 * n;
    for (std::uint32_t a = 0; a < 2 * n; ++a) {
      for (std::uint32_t b = a + 1; b < 2 * n; ++b) {
        if (partners(a, b)) continue;
        const Point2 from = sites[a], to = sites[b], h = sites[shield];
        ASSERT_GT(oracle::orient2d(from, to, h), 0);
        for (const Point2 s : sites) {
          if (s == h || oracle::orient2d(from, to, s) <= 0) continue;
          ASSERT_GT(oracle::orient2d(to, s, h), 0);
          ASSERT_GT(oracle::orient2d(s, from, h), 0);
        }
        for (const Point2 end : core.first(2 * n)) {
          if (oracle::orient2d(from, to, end) >= 0) continue;
          ASSERT_GT(oracle::incircle(from, to, h, end), 0);
        }
        const std::size_t each = instance.order + std::size_t{1};
        for (const Point2 g : guards.subspan((shield - 2 * n) * each, each)) {
          ASSERT_GT(oracle::incircle(from, to, h, g), 0);
        }
        for (std::size_t s = b + std::size_t{1}; s < core.size(); ++s) {
          if (s != shield) reach = std::max(reach, squared_radius(from, to, core[s]));
        }
        ++shield;
      }
    }
    for (std::size_t i = 0; i < core.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        reach = std::max(reach, std::pow(core[i].x - core[j].x, 2) + std::pow(core[i].y - core[j].y, 2));
        for (std::size_t k = 0; k < j; ++k) {
          ASSERT_NE(oracle::orient2d(core[i], core[j], core[k]), 0);
          if (j >= 2 * n || partners(static_cast<std::uint32_t>(j), static_cast<std::uint32_t>(k)))
            reach = std::max(reach, squared_radius(core[i], core[j], core[k]));
        }
      }
    }
    for (const Point2 c : core) {
      for (const Point2 g : guards) ASSERT_GE(std::pow(c.x - g.x, 2) + std::pow(c.y - g.y, 2), 16 * reach);
    }
  }
}

/// A hash of all coordinates.
std::uint64_t digest(const HardInstance& instance) {
  std::uint64_t hash = 14695981039346656037u;
  for (const Point3& p : instance.points) {
    for (const double value : {p.x, p.y, p.z}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211u;
    }
  }
  return hash;
}

TEST(HardInstances, AreTheSameOnEveryMachine) {
  const Segments comb = {{{0, 0}, {40, 3}}, {{5, -5}, {6, 7}}, {{15, -6}, {16, 9}}, {{25, -7}, {24, 8}}};
  // An end near the middle of another segment; two ends of one segment near each other.
  const Segments near = {{{0, 0}, {1000, 0}}, {{500, 3}, {500, 900}}};
  const Segments shorter = {{{0, 0}, {1, 2}}, {{50, 60}, {90, -30}}};
  const Segments in_a_row = {{{0, 0}, {0, 5}}, {{1, 0}, {1, 4}}, {{2, 0}, {2, 3}}, {{3, 0}, {4, 5}}};
  std::uint64_t first = 0, second = 0;
  for (const Segments& segments : {comb, in_a_row, near, shorter})
    first ^= digest(theorem1_instance(segments).value());
  // Shields that are collinear at first; guards of two pairs in one row.
  const Segments parallel = {{{4, 2}, {16, 3}}, {{7, -5}, {19, -4}}};
  const Segments in_one_row = {{{0, 11}, {7, 12}}, {{11, 4}, {3, 5}}};
  for (const Segments& segments : {parallel, in_one_row}) {
    second ^= digest(corollary2_instance(segments).value());
  }
  for (std::uint32_t n = 2; n <= 5; ++n) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const Segments segments = random_segments(n, seed);
      first = first * 3 + digest(theorem1_instance(segments).value());
      const auto guarded = corollary2_instance(segments);
      second = second * 3 + (guarded ? digest(*guarded) : 1);
    }
  }
  EXPECT_EQ(first, 7631822104016459432u);
  EXPECT_EQ(second, 11600242632413231200u);
}

TEST(Theorem1, RefusesTooLargeCoordinatesInAnySegment) {
  const LatticeSegment far = {{std::int64_t{1} << 30, 0}, {0, 1}}, near = {{5, 5}, {6, 7}};
  expect_refused({far, near}, {0}, "has the coordinate");
  expect_refused({near, far}, {1}, "has the coordinate");
}

}  // namespace
