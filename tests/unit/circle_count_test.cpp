/// CircleCounter and the search for pairs: how little they look at.
#include "thalweg/circle_count.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "kernel/sleeve.hpp"
#include "order/reach.hpp"
#include "order/sleeve_search.hpp"
#include "support/random.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/predicates.hpp"

namespace {

using thalweg::CircleCounter;
using thalweg::DelaunayGraph;
using thalweg::Point2;
using thalweg::VertexId;
using thalweg::detail::SleeveSearch;

struct Scattered {
  explicit Scattered(std::size_t count) {
    support::Random random(29);
    while (places.size() < count) {
      const double x = random.unit();
      places.push_back({x, random.unit()});
    }
    // Three corners of nearly all.
    places.insert(places.end(), {{-1, -1}, {2, -1}, {0.5, 3}});
    delaunay = thalweg::delaunay(places).value();
  }

  VertexId corner(std::uint32_t i) const {
    return VertexId(static_cast<std::uint32_t>(places.size()) - 3 + i);
  }

  std::vector<Point2> places;
  thalweg::Triangulation delaunay;
};

TEST(CircleCounter, StopsSoonBeyondTheLimit) {
  const Scattered sites(2000);
  const DelaunayGraph graph(sites.places, sites.delaunay);
  CircleCounter counter(graph);
  const auto count = [&](unsigned limit) {
    return counter.count_in_circle(sites.corner(0), sites.corner(1), sites.corner(2), limit);
  };
  for (const unsigned limit : {0u, 3u, 40u}) {
    EXPECT_EQ(count(limit), limit + 1);
    EXPECT_GT(counter.inside().size(), limit);
    EXPECT_LT(counter.inside().size(), limit + 100);  // the neighbours of the last site looked at
  }
  EXPECT_EQ(count(5000), 2000u);
  EXPECT_EQ(counter.inside().size(), 2000u);
}

TEST(CircleCounter, FindsTheSameByADiagram) {
  const Scattered sites(100);
  const DelaunayGraph graph(sites.places, sites.delaunay);
  const auto diagram = thalweg::order_k_voronoi(sites.places, 12).value();
  DelaunayGraph with_diagram(sites.places, sites.delaunay);
  with_diagram.count_by(diagram);
  const auto sorted = [](std::span<const VertexId> inside) {
    std::vector<VertexId> result(inside.begin(), inside.end());
    std::sort(result.begin(), result.end());
    return result;
  };
  CircleCounter crawl(graph);
  for (std::uint32_t i = 0; i + 2 < 100; ++i) {
    VertexId u(i), v(i + 1);
    const VertexId w(i + 2);
    if (thalweg::orient2d(graph.point(u), graph.point(v), graph.point(w)) < 0) std::swap(u, v);
    CircleCounter by_diagram(with_diagram);  // a new one: it has no room yet
    ASSERT_EQ(by_diagram.count_in_circle(u, v, w, 11), crawl.count_in_circle(u, v, w, 11));
    if (crawl.inside().size() <= 11) {
      EXPECT_EQ(sorted(by_diagram.inside()), sorted(crawl.inside()));
    }
  }
}

/// A pair has at least the order of the number of sites on either side of its sleeve.
TEST(SleeveSearch, CountsNoCirclesWhereASideHasMoreThanK) {
  const Scattered sites(600);
  const DelaunayGraph graph(sites.places, sites.delaunay);
  for (const unsigned k : {2u, 5u}) {
    std::uint64_t counted = 0;
    CircleCounter expected(graph);
    for (std::uint32_t i = 0; i < 600; i += 10) {
      CircleCounter counter(graph);
      SleeveSearch search(graph, counter);
      unsigned limit = k;
      const auto all = [](VertexId) { return true; };
      search.run(VertexId(i), limit, all, [](VertexId, unsigned) { return false; });
      if (!search.reach().collect(graph)) continue;
      counted += counter.calls();
      thalweg::detail::Sleeve sleeve;
      for (const VertexId v : search.reach().sites()) {
        if (!find_sleeve(sites.delaunay, sites.places, VertexId(i), v, sleeve)) continue;
        const std::set<VertexId> left(sleeve.left.begin(), sleeve.left.end());
        const std::set<VertexId> right(sleeve.right.begin(), sleeve.right.end());
        if (std::max(left.size(), right.size()) > k) continue;
        SleeveSearch::pair_order(graph, expected, VertexId(i), v, sleeve.left, sleeve.right, k);
      }
    }
    EXPECT_EQ(counted, expected.calls()) << k;
    EXPECT_GT(counted, 500u) << k;
  }
}

}  // namespace
