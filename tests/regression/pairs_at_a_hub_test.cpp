/// A site with 4 k + 16 neighbours or more: of the sites right behind these some were taken for neighbours,
/// and their pairs of low order not found.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "oracle/order.hpp"
#include "support/prepared.hpp"
#include "support/random.hpp"

namespace {

/// Around (0, 0) a ring of sites, and behind every gap of it one more that is just not a neighbour of (0, 0).
support::Cloud hub(int spokes) {
  support::Cloud cloud{{{0, 0, 0}}};
  support::Random random(11);
  const double gap = 2 * 3.14159265358979 / spokes;
  for (int i = 0; i < 2 * spokes; ++i) {
    const double radius = (i % 2 == 0 ? 1 : 1.006 / std::cos(gap / 2)) + 1e-3 * random.unit();
    const double angle = gap / 2 * (i + 0.1 * random.unit());
    cloud.points.push_back(
        {std::floor(1e6 * radius * std::cos(angle)), std::floor(1e6 * radius * std::sin(angle)), 0});
  }
  return cloud;
}

TEST(Regression, PairsOfAHubWithManyNeighborsAreFound) {
  for (const int spokes : {18, 19, 20, 21, 24, 30}) {
    const support::Prepared p(hub(spokes));
    EXPECT_EQ(p.graph.neighbors(support::vertex(0)).size(), static_cast<std::size_t>(spokes));
    std::vector<thalweg::UsefulPair> expected;
    for (std::uint32_t v = 1; v < p.size(); ++v) {
      const auto order = oracle::useful_order(p.sites, 0, v);
      if (order && *order <= 1) expected.push_back({support::vertex(0), support::vertex(v), *order});
    }
    EXPECT_GT(expected.size(), static_cast<std::size_t>(spokes));
    EXPECT_EQ(thalweg::useful_pairs_from(p.graph, support::vertex(0), 1), expected) << spokes;
  }
}

}  // namespace
