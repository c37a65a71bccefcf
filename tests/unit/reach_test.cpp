/// How far a site can be joined: bounds that are never wrong, worth having, and a search that misses nothing.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
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
  for (const double size : {0x1p-1000, 0x1p-600, 0x1p-190, 0x1p190, 0x1p520, 0x1p1000}) {
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
