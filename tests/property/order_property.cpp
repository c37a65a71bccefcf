/// Circle counts, orders of faces and useful orders against the definitions, on degenerate point sets.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "oracle/order.hpp"
#include "support/prepared.hpp"

namespace {

using support::Cloud;
using support::Prepared;
using support::vertex;
using thalweg::CircleCounter;
using thalweg::UsefulPair;

/// What a count or order becomes under a limit.
unsigned saturated(unsigned value, unsigned limit) {
  return std::min(value, limit + 1);
}

RC_GTEST_PROP(DelaunayLaws, CirclesAreEmpty, ()) {
  const Prepared p(*support::clouds(25));
  RC_ASSERT(oracle::is_triangulation(p.sites, support::triangles_of(p.delaunay)));
  for (const oracle::Tri& t : support::triangles_of(p.delaunay)) {
    RC_ASSERT(oracle::triangle_order(p.sites, t) == 0u);
  }
}

RC_GTEST_PROP(CircleCounterLaws, CountsAllTriples, ()) {
  const Prepared p(*support::clouds(14));
  CircleCounter counter(p.graph);
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    for (std::uint32_t v = 0; v < p.size(); ++v) {
      for (std::uint32_t w = 0; w < p.size(); ++w) {
        if (oracle::turn(p.sites[u], p.sites[v], p.sites[w]) <= 0) continue;
        const unsigned order = oracle::triangle_order(p.sites, u, v, w);
        for (const unsigned limit : {0u, order > 0 ? order - 1 : 0, order, order + 1, 50u}) {
          RC_ASSERT(counter.count_in_circle(vertex(u), vertex(v), vertex(w), limit) ==
                    saturated(order, limit));
          RC_ASSERT(counter.order_at_most(limit, {vertex(u), vertex(v), vertex(w)}) == (order <= limit));
        }
      }
    }
  }
}

RC_GTEST_PROP(FaceOrdersLaws, AreTheOrdersOfTheFaces, ()) {
  const Prepared p(*support::clouds(20));
  const std::vector<oracle::Tri> triangles = oracle::any_triangulation(p.sites);
  const auto mesh = thalweg::Triangulation::from_triangles(support::with_ids(triangles), p.size());
  RC_ASSERT(mesh.has_value());
  const auto limit = *rc::gen::inRange(0u, 25u);
  for (const unsigned threads : {1u, 3u}) {
    const auto orders = thalweg::face_orders(p.graph, *mesh, limit, threads);
    RC_ASSERT(orders.size() == triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      RC_ASSERT(orders[i] == saturated(oracle::triangle_order(p.sites, triangles[i]), limit));
    }
  }
}

RC_GTEST_PROP(UsefulOrderLaws, IsTheDefinitionForEveryPair, ()) {
  const Prepared p(*support::clouds(25));
  CircleCounter counter(p.graph);
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    for (std::uint32_t v = 0; v < p.size(); ++v) {
      if (u == v) continue;
      const auto expected = oracle::useful_order(p.sites, u, v);
      for (const unsigned limit : {0u, 1u, 3u, 40u}) {
        const auto order = thalweg::useful_order(p.graph, counter, vertex(u), vertex(v), limit);
        RC_LOG() << "pair " << u << ", " << v << " limit " << limit << "\n";
        RC_ASSERT(order.has_value() == expected.has_value());
        if (order) RC_ASSERT(*order == saturated(*expected, limit));
      }
    }
  }
}

/// A site off a pair's segment may block no order; one on it blocks all, whatever the limit.
TEST(UsefulOrder, NothingWhenASiteLiesBetweenWhateverTheLimit) {
  Cloud lattice;
  for (int i = 0; i < 64; ++i) lattice.points.push_back({double(i % 8), double(i / 8), 0});
  const Prepared p(lattice);
  CircleCounter counter(p.graph);
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    for (std::uint32_t v = 0; v < p.size(); ++v) {
      if (u == v) continue;
      const auto expected = oracle::useful_order(p.sites, u, v);
      for (const unsigned limit : {0u, 2u, 64u}) {
        const auto order = thalweg::useful_order(p.graph, counter, vertex(u), vertex(v), limit);
        ASSERT_EQ(order.has_value(), expected.has_value()) << u << ", " << v << " limit " << limit;
        if (order) {
          ASSERT_EQ(*order, saturated(*expected, limit)) << u << ", " << v << " limit " << limit;
        }
      }
    }
  }
}

void check_pairs(const Prepared& p, unsigned k) {
  std::vector<UsefulPair> expected;
  for (const auto& pair : oracle::useful_pairs(p.sites, k)) {
    expected.push_back({vertex(pair.u), vertex(pair.v), pair.order});
  }
  for (const unsigned threads : {1u, 2u, 0u})
    RC_ASSERT(thalweg::useful_pairs(p.graph, k, threads) == expected);
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    std::vector<UsefulPair> mine;
    for (const UsefulPair& pair : expected) {
      if (pair.u == vertex(u)) mine.push_back(pair);
      if (pair.v == vertex(u)) mine.push_back({pair.v, pair.u, pair.order});
    }
    std::sort(mine.begin(), mine.end());
    RC_ASSERT(thalweg::useful_pairs_from(p.graph, vertex(u), k) == mine);
  }
}

RC_GTEST_PROP(UsefulPairsLaws, AreAllPairsOfTheOrder, ()) {
  const Prepared p(*support::clouds(30));
  check_pairs(p, *rc::gen::inRange(0u, 8u));
}

/// The first `size` integer points of the circle of radius 32045, which has 324.
Cloud ring(std::size_t size) {
  Cloud result;
  for (const auto& q : support::integer_circle(32045)) {
    if (result.points.size() < size) result.points.push_back({q.x, q.y, 0});
  }
  return result;
}

TEST(UsefulPairs, AllPairsOfAnEmptyRingHaveOrderZero) {
  const Prepared p(ring(324));
  ASSERT_EQ(p.size(), 324u);
  EXPECT_EQ(thalweg::useful_pairs(p.graph, 0).size(), 324u * 323 / 2);
  EXPECT_EQ(thalweg::useful_pairs(p.graph, 5, 2).size(), 324u * 323 / 2);
}

TEST(UsefulPairs, RingAmongOtherSites) {
  Cloud cloud = ring(324);
  std::uint64_t state = 1;
  const auto next = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(static_cast<int>((state >> 33) % 80001) - 40000);
  };
  while (cloud.points.size() < 624) {
    const double x = next();
    cloud.points.push_back({x, next(), 0});
  }
  const Prepared p(support::make_cloud(cloud.points));
  CircleCounter counter(p.graph);
  constexpr unsigned kOrder = 4;
  for (std::uint32_t u = 0; u < p.size(); u += 17) {
    std::vector<UsefulPair> expected;
    for (std::uint32_t v = 0; v < p.size(); ++v) {
      if (u == v) continue;
      const auto order = oracle::useful_order(p.sites, u, v);
      if (order && *order <= kOrder) expected.push_back({vertex(u), vertex(v), *order});
      const auto found = thalweg::useful_order(p.graph, counter, vertex(u), vertex(v), 100);
      ASSERT_EQ(found.has_value(), order.has_value()) << u << ", " << v;
      if (found) {
        ASSERT_EQ(*found, saturated(*order, 100)) << u << ", " << v;
      }
    }
    ASSERT_EQ(thalweg::useful_pairs_from(p.graph, vertex(u), kOrder), expected) << u;
  }
  // All of them at once, against one by one.
  std::vector<UsefulPair> all;
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    for (const UsefulPair& pair : thalweg::useful_pairs_from(p.graph, vertex(u), kOrder)) {
      if (pair.u < pair.v) all.push_back(pair);
    }
  }
  EXPECT_EQ(thalweg::useful_pairs(p.graph, kOrder, 2), all);
}

/// Moving every site to the far end of the doubles' range changes nothing.
RC_GTEST_PROP(UsefulPairsLaws, DoNotDependOnTheExponent, ()) {
  const Cloud cloud = *support::clouds(20);
  const int exponent = *rc::gen::element(-1074, -1000, -300, 300, 1000);
  const auto k = *rc::gen::inRange(0u, 6u);
  const auto pairs_of = [&](const Cloud& c) {
    const auto places = c.places();
    const auto mesh = thalweg::delaunay(places);
    RC_ASSERT(static_cast<bool>(mesh));
    return thalweg::useful_pairs(thalweg::DelaunayGraph(places, *mesh), k);
  };
  RC_ASSERT(pairs_of(support::scaled(cloud, exponent)) == pairs_of(cloud));
}

}  // namespace
