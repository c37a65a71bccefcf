/// How far a site can be joined: bounds that are never wrong, worth having, and a search that misses nothing.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "oracle/order.hpp"
#include "order/reach.hpp"
#include "order/sleeve_search.hpp"
#include "support/prepared.hpp"
#include "support/random.hpp"
#include "support/random_mesh.hpp"

namespace {

using support::Cloud;
using support::Prepared;
using support::vertex;
using thalweg::CircleCounter;
using thalweg::DelaunayGraph;
using thalweg::Point2;
using thalweg::VertexId;
using thalweg::detail::Reach;
using thalweg::detail::SleeveSearch;
using thalweg::detail::way_between;

using Orders = std::vector<std::pair<VertexId, unsigned>>;

/// All that a search from a site finds up to order k; by the walk alone if wanted.
Orders found_from(const DelaunayGraph& graph, VertexId from, unsigned k, bool by_walk = false) {
  CircleCounter counter(graph);
  SleeveSearch search(graph, counter);
  Orders found;
  const auto wanted = [](VertexId) { return true; };
  const auto take = [&](VertexId q, unsigned order) {
    found.emplace_back(q, order);
    return false;
  };
  if (by_walk) {
    for (const VertexId q : graph.neighbors(from)) take(q, 0);
    search.reach().measure(graph, from, k);
    search.walk(from, k, wanted, take);
  } else {
    search.run(from, k, wanted, take);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The sites that are out of reach by the bounds alone.
std::vector<VertexId> beyond(const DelaunayGraph& graph, VertexId from, unsigned k) {
  Reach reach;
  reach.measure(graph, from, k);
  std::vector<VertexId> result;
  for (std::uint32_t v = 0; v < graph.sites().size(); ++v) {
    if (vertex(v) == from) continue;
    if (reach.is_beyond(way_between(graph.point(from), graph.point(vertex(v))))) result.push_back(vertex(v));
  }
  return result;
}

RC_GTEST_PROP(ReachLaws, SearchAndWalkFindEveryPair, ()) {
  const Prepared p(*support::clouds(60));
  const unsigned k = support::random_index(13);
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    Orders expected;
    for (std::uint32_t v = 0; v < p.size(); ++v) {
      if (u == v) continue;
      const auto order = oracle::useful_order(p.sites, u, v);
      if (order && *order <= k) expected.emplace_back(vertex(v), *order);
    }
    RC_ASSERT(found_from(p.graph, vertex(u), k) == expected);
    RC_ASSERT(found_from(p.graph, vertex(u), k, true) == expected);
  }
}

RC_GTEST_PROP(ReachLaws, NothingThatIsBeyondIsInReach, ()) {
  const Prepared p(*support::clouds(60));
  const unsigned k = support::random_index(6);
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    for (const VertexId v : beyond(p.graph, vertex(u), k)) {
      const auto order = oracle::useful_order(p.sites, u, v.index());
      RC_ASSERT(!order || *order > k);
    }
  }
}

/// Sites in a square of this size, too many for the oracle; `step` rounds them to a grid.
struct Square {
  Square(std::size_t count, double size, double step = 0)
      : places(uniform(count, size, step)),
        delaunay(thalweg::delaunay(places).value()),
        graph(places, delaunay) {}

  static std::vector<Point2> uniform(std::size_t count, double size, double step) {
    support::Random random(20060101);
    std::vector<Point2> places;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = random.unit(), y = random.unit();
      places.push_back(step > 0 ? Point2{std::floor(x / step), std::floor(y / step)}
                                : Point2{size * x, size * y});
    }
    std::sort(places.begin(), places.end(),
              [](Point2 a, Point2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    const auto same = [](Point2 a, Point2 b) { return a.x == b.x && a.y == b.y; };
    places.erase(std::unique(places.begin(), places.end(), same), places.end());
    return places;
  }

  VertexId at(double share) const {
    return vertex(static_cast<std::uint32_t>(share * static_cast<double>(places.size() - 1)));
  }

  std::vector<Point2> places;
  thalweg::Triangulation delaunay;
  DelaunayGraph graph;
};

TEST(Reach, LeavesLittleOfWhatIsFarAway) {
  const Square square(3000, 1);
  int bounded = 0;
  for (double share = 0.05; share < 1; share += 0.05) {
    Reach reach;
    reach.measure(square.graph, square.at(share), 8);
    if (!reach.collect(square.graph)) continue;
    ++bounded;
    EXPECT_LT(reach.sites().size(), 150u);
    EXPECT_GT(beyond(square.graph, square.at(share), 8).size(), 2800u);
  }
  EXPECT_GT(bounded, 12);
}

constexpr double kTurn = 2 * 3.14159265358979323846;

Point2 towards(Point2 from, double angle, double distance) {
  return {from.x + distance * std::cos(angle), from.y + distance * std::sin(angle)};
}

/// The distance from which on all in this direction is beyond, found by halving; 0 if it is not at 2.
double bound_of(const Reach& reach, Point2 from, double angle) {
  double low = 0, high = 2;
  if (!reach.is_beyond(way_between(from, towards(from, angle, high)))) return 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (reach.is_beyond(way_between(from, towards(from, angle, middle))) ? high : low) = middle;
  }
  return high;
}

/// The largest distances in these directions at which a site is in reach: its inverse is the least, over the
/// directions x of centres, of the (k + 1)-th largest w' . x over the cosine. Some directions x only.
std::vector<double> true_reach(const Square& square, VertexId from, std::size_t k,
                               const std::vector<double>& angles) {
  constexpr int kCentres = 180;
  const Point2 p = square.graph.point(from);
  std::vector<double> nearest(angles.size(), HUGE_VAL), inverted;
  for (int i = 0; i < kCentres; ++i) {
    const double centre = kTurn * i / kCentres;
    inverted.clear();
    for (const Point2 w : square.places) {
      const double x = w.x - p.x, y = w.y - p.y, square_length = x * x + y * y;
      if (square_length > 0)
        inverted.push_back((x * std::cos(centre) + y * std::sin(centre)) / square_length);
    }
    const auto last = inverted.begin() + static_cast<std::ptrdiff_t>(k);
    std::nth_element(inverted.begin(), last, inverted.end(), std::greater<>());
    for (std::size_t j = 0; j < angles.size(); ++j) {
      const double cosine = std::cos(angles[j] - centre);
      if (cosine > 1e-3) nearest[j] = std::min(nearest[j], *last / cosine);
    }
  }
  for (double& value : nearest) value = 1 / value;
  return nearest;
}

std::vector<double> all_around(int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back(kTurn * (i + 0.37) / count);
  return angles;
}

TEST(Reach, BoundsAreNotFarFromTheTruth) {
  struct Looseness {
    unsigned k;
    double most;  // on average
  };
  const Square square(1000, 1);
  const std::vector<double> angles = all_around(32);
  for (const auto& [k, most] : {Looseness{0, 1.3}, {3, 1.32}, {16, 1.47}}) {
    double sum = 0, count = 0;
    for (std::uint32_t i = 0; i < 1000; i += 40) {
      const Point2 p = square.places[i];
      if (std::max(std::fabs(p.x - 0.5), std::fabs(p.y - 0.5)) > 0.25) continue;
      Reach reach;
      reach.measure(square.graph, vertex(i), k);
      const std::vector<double> expected = true_reach(square, vertex(i), k, angles);
      for (std::size_t j = 0; j < angles.size(); ++j) {
        const double ratio = bound_of(reach, p, angles[j]) / expected[j];
        EXPECT_GE(ratio, 1) << k;
        sum += ratio;
        ++count;
      }
    }
    EXPECT_LT(sum / count, most) << k;
  }
}

/// All sites are near enough for their order not to matter.
TEST(Reach, BoundsTurnWithTheSites) {
  Square square(48, 1);
  for (const unsigned k : {8u, 12u}) {
    for (std::uint32_t i = 0; i < 48; ++i) {
      std::vector<Point2> turned, mirrored;
      for (const Point2 p : square.places) {
        turned.push_back({-p.y, p.x});
        mirrored.push_back({p.y, p.x});
      }
      const auto bounds = [&](const std::vector<Point2>& places, double first, double step) {
        const auto delaunay = thalweg::delaunay(places).value();
        const DelaunayGraph graph(places, delaunay);
        Reach reach;
        reach.measure(graph, vertex(i), k);
        std::vector<double> result;
        for (int j = 0; j < 16; ++j) {
          result.push_back(bound_of(reach, places[i], kTurn * (first + step * j + step / 2) / 16));
        }
        return result;
      };
      const std::vector<double> expected = bounds(square.places, 0, 1);
      const std::vector<double> of_turned = bounds(turned, 4, 1), of_mirrored = bounds(mirrored, 4, -1);
      for (std::size_t j = 0; j < 16; ++j) {
        EXPECT_NEAR(of_turned[j], expected[j], 1e-9);
        EXPECT_NEAR(of_mirrored[j], expected[j], 1e-9);
      }
    }
  }
}

/// A cone is beyond if both ends of the stretch of the edge that it crosses are, and so far that the middle
/// of the stretch is too: for rays within one sector or two that are neighbours.
TEST(Reach, ConesAreBeyondWhereTheirEdgeIs) {
  const Square square(600, 1);
  const VertexId from = square.at(0.5);
  const Point2 p = square.graph.point(from);
  Reach reach;
  reach.measure(square.graph, from, 3);
  int beyond = 0, within = 0;
  for (std::uint32_t i = 0; i < square.delaunay.halfedge_count(); ++i) {
    const thalweg::HalfedgeId h(i);
    const Point2 a = square.graph.point(square.delaunay.origin(h));
    const Point2 b = square.graph.point(square.delaunay.dest(h));
    if (thalweg::orient2d(a, b, p) <= 0) continue;
    for (const auto& [first, last] : {std::pair{0.0, 1.0}, std::pair{0.25, 0.375}, std::pair{0.5, 1.0}}) {
      // The rays cross the edge at a share of its length, and run through sites before it.
      const auto way_to = [&](double share, double before) {
        return way_between(p, {p.x + before * (a.x + share * (b.x - a.x) - p.x),
                               p.y + before * (a.y + share * (b.y - a.y) - p.y)});
      };
      const auto right = way_to(first, 0.4), left = way_to(last, 0.7);
      const unsigned gap = (left.sector - right.sector) % 16;
      const double right_bound = bound_of(reach, p, std::atan2(right.y, right.x));
      const double left_bound = bound_of(reach, p, std::atan2(left.y, left.x));
      const double least = std::max(right_bound, left_bound) / std::cos(gap == 0 ? kTurn / 32 : kTurn / 16);
      const double margin = std::min(std::sqrt(right.square) / 0.4, std::sqrt(left.square) / 0.7) / least;
      if (std::fabs(margin - 1) < 1e-9) continue;
      const bool expected = gap <= 1 && margin > 1;
      EXPECT_EQ(reach.is_beyond(way_between(p, a), way_between(p, b), way_between(a, b), right, left),
                expected)
          << i << " " << first;
      ++(expected ? beyond : within);
    }
  }
  EXPECT_GT(beyond, 1000);
  EXPECT_GT(within, 100);
}

TEST(Reach, IsNotBoundedAtTheRim) {
  Cloud bowl;
  for (int i = 0; i < 60; ++i) bowl.points.push_back({double(i), double(i) * i, 0});
  const Prepared p(bowl);
  Reach reach;
  reach.measure(p.graph, vertex(30), 2);
  EXPECT_FALSE(reach.collect(p.graph));
}

TEST(Reach, IsNotBoundedByTooFewSites) {
  const Square square(60, 1);
  Reach reach;
  for (const unsigned k : {57u, 58u, 1000u}) {
    reach.measure(square.graph, square.at(0.5), k);
    EXPECT_FALSE(reach.collect(square.graph)) << k;
  }
}

/// A site with thousands of neighbours among those near: looking at them all for each of these would be
/// quadratic work.
TEST(Reach, GivesUpAtAHub) {
  std::vector<Point2> places{{0, 0}};
  support::Random random(7);
  for (int i = 0; i < 5000; ++i) {
    const double angle = 2 * 3.14159265358979 * random.unit(), radius = 1 + 1e-7 * random.unit();
    places.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    places.push_back({2 * radius * std::cos(angle), 2 * radius * std::sin(angle)});
  }
  const auto delaunay = thalweg::delaunay(places).value();
  const DelaunayGraph graph(places, delaunay);
  Reach reach;
  reach.measure(graph, vertex(1), 3);
  EXPECT_FALSE(reach.collect(graph));
  EXPECT_EQ(found_from(graph, vertex(1), 3), found_from(graph, vertex(1), 3, true));
}

/// Lengths whose squares or inverses are out of range may prove less, never more.
TEST(Reach, FindsTheSameAtAnyScale) {
  const Square square(600, 1);
  for (const double size :
       {0x1p-1000, 0x1p-600, 0x1p-532, 0x1p-531, 0x1p-530, 0x1p-190, 0x1p190, 0x1p520, 0x1p1000}) {
    const Square scaled(600, size);
    for (const double share : {0.0, 0.3, 0.5, 1.0}) {
      EXPECT_EQ(found_from(scaled.graph, scaled.at(share), 12),
                found_from(square.graph, square.at(share), 12, true))
          << size;
    }
  }
}

TEST(Reach, SearchAndWalkFindTheSameAmongManySites) {
  const Square square(3000, 1), grid(3000, 1, 1.0 / 50);
  for (const Square* sites : {&square, &grid}) {
    for (double share = 0; share <= 1; share += 0.1) {
      for (const unsigned k : {1u, 3u, 8u, 40u}) {
        const Orders found = found_from(sites->graph, sites->at(share), k);
        EXPECT_EQ(found, found_from(sites->graph, sites->at(share), k, true)) << share << " " << k;
      }
    }
  }
}

}  // namespace
