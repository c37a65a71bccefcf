/// The bound by half disks: never wrong, and worth having.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "oracle/order.hpp"
#include "order/half_disks.hpp"
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
using thalweg::detail::HalfDisks;
using thalweg::detail::SleeveSearch;

/// All that a search from p finds up to order k.
std::vector<std::pair<VertexId, unsigned>> found_from(const DelaunayGraph& graph, VertexId from, unsigned k,
                                                      unsigned half_disks_from) {
  CircleCounter counter(graph);
  SleeveSearch search(graph, counter, half_disks_from);
  std::vector<std::pair<VertexId, unsigned>> found;
  search.run(
      from, k, [](VertexId) { return true; },
      [&](VertexId q, unsigned order) {
        found.emplace_back(q, order);
        return false;
      });
  std::sort(found.begin(), found.end());
  return found;
}

struct Leg {
  double x, y;
};

/// Whether the half disks of the pair alone prove that its useful order is more than k.
bool exceeds(const HalfDisks& disks, const DelaunayGraph& graph, VertexId u, VertexId v, unsigned k) {
  const Point2 a = graph.point(u), b = graph.point(v);
  const Leg leg{b.x - a.x, b.y - a.y};
  return disks.exceed(k, leg, leg, leg, leg);
}

RC_GTEST_PROP(HalfDisksLaws, PruneNoPairThatIsInReach, ()) {
  const Prepared p(*support::clouds(40));
  unsigned k = support::random_index(13);
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    std::vector<std::pair<VertexId, unsigned>> expected;
    for (std::uint32_t v = 0; v < p.size(); ++v) {
      if (u == v) continue;
      const auto order = oracle::useful_order(p.sites, u, v);
      if (order && *order <= k) expected.emplace_back(vertex(v), *order);
    }
    RC_ASSERT(found_from(p.graph, vertex(u), k, 0) == expected);
  }
}

RC_GTEST_PROP(HalfDisksLaws, ExceedNoOrderThatIsNotExceeded, ()) {
  const Prepared p(*support::clouds(30));
  HalfDisks disks;
  for (std::uint32_t u = 0; u < p.size(); ++u) {
    const unsigned k = support::random_index(10);
    disks.gather(p.graph, vertex(u), k);
    for (std::uint32_t v = 0; v < p.size(); ++v) {
      if (u == v || !exceeds(disks, p.graph, vertex(u), vertex(v), k)) continue;
      const auto order = oracle::useful_order(p.sites, u, v);
      RC_ASSERT(!order || *order > k);
    }
  }
}

/// Uniform sites in a square of this size, too fine for the oracle.
struct Square {
  Square(std::size_t count, double size)
      : places(uniform(count, size)), delaunay(thalweg::delaunay(places).value()), graph(places, delaunay) {}

  static std::vector<Point2> uniform(std::size_t count, double size) {
    support::Random random(20060101);
    std::vector<Point2> places;
    for (std::size_t i = 0; i < count; ++i) {
      const double x = random.unit();
      places.push_back({size * x, size * random.unit()});
    }
    return places;
  }

  std::vector<Point2> places;
  thalweg::Triangulation delaunay;
  DelaunayGraph graph;
};

/// The number of pairs with `from` that are proved to be out of reach.
std::size_t proofs_from(const DelaunayGraph& graph, VertexId from, unsigned k) {
  HalfDisks disks;
  disks.gather(graph, from, k);
  std::size_t proofs = 0;
  for (std::uint32_t v = 0; v < graph.sites().size(); ++v) {
    if (vertex(v) != from) proofs += exceeds(disks, graph, from, vertex(v), k) ? 1 : 0;
  }
  return proofs;
}

TEST(HalfDisks, RuleOutMostOfWhatIsFarAway) {
  const Square square(2000, 1);
  for (const std::uint32_t from : {0u, 777u, 1999u}) {
    EXPECT_GT(proofs_from(square.graph, vertex(from), 8), 1500u);
  }
}

TEST(HalfDisks, ProveNothingWhereAllSitesAreOnOneSide) {
  Cloud bowl;
  for (int i = 0; i < 30; ++i) bowl.points.push_back({double(i), double(i) * i, 0});
  const Prepared p(bowl);
  EXPECT_EQ(proofs_from(p.graph, vertex(0), 30), 0u);
}

/// Squares that overflow or underflow may prove less, never more: the search finds the same.
TEST(HalfDisks, FindTheSameAtAnyScale) {
  const Square square(300, 1);
  for (const double size : {0x1p-600, 0x1p-520, 0x1p520, 0x1p1000}) {
    const Square scaled(300, size);
    for (const std::uint32_t from : {0u, 299u}) {
      EXPECT_EQ(found_from(scaled.graph, vertex(from), 20, 0),
                found_from(square.graph, vertex(from), 20, 1000))
          << size;
    }
  }
}

TEST(HalfDisks, FindTheSameAmongManySites) {
  const Square square(3000, 1);
  for (const std::uint32_t from : {0u, 1234u, 2999u}) {
    const auto found = found_from(square.graph, vertex(from), 40, 0);
    EXPECT_EQ(found, found_from(square.graph, vertex(from), 40, 1000));
    EXPECT_GT(found.size(), 15u);
  }
}

}  // namespace
