/// A few sets too large for the slow references as a whole: lattices, a ring of 324 cocircular sites, flats.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "support/random.hpp"
#include "support/run.hpp"

namespace {

using support::Cloud;
using support::Random;
using thalweg::Method;
using thalweg::Minimized;

Cloud lattice(std::uint32_t side, std::uint32_t levels) {
  Random random(side);
  Cloud cloud;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    cloud.points.push_back({double(i % side), double(i / side), double(random.below(levels))});
  }
  return cloud;
}

Cloud ring_with_others() {
  Random random(5);
  std::vector<thalweg::Point3> points;
  for (const auto& p : support::integer_circle(32045))
    points.push_back({p.x, p.y, double(random.below(300))});
  for (int i = 0; i < 300; ++i) {
    points.push_back({random.whole(-45000, 45000), random.whole(-45000, 45000), random.whole(0, 299)});
  }
  return support::make_cloud(points);
}

Cloud scattered(std::uint32_t size, std::uint32_t levels) {
  Random random(size + levels);
  std::vector<thalweg::Point3> points;
  for (std::uint32_t i = 0; i < size; ++i) {
    points.push_back({random.whole(0, 19999), random.whole(0, 19999), double(random.below(levels))});
  }
  return support::make_cloud(points);
}

/// Everything that can be told in quadratic time.
void check(const Cloud& cloud, const Minimized& m, unsigned k) {
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
  const auto triangles = support::triangles_of(m.triangulation);
  ASSERT_TRUE(thalweg::find_faults(cloud.places(), triangles).empty());
  ASSERT_EQ(m.face_orders.size(), triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const unsigned order = oracle::triangle_order(sites, triangles[i]);
    ASSERT_LE(order, k);
    ASSERT_EQ(m.face_orders[i], order);
  }
  const auto pits = oracle::pits_of_graph(cloud.elevations(), oracle::edges_of(triangles));
  ASSERT_EQ(m.pits.total, pits.size());
  ASSERT_LE(m.lower_bound, m.pits.total);
}

void check_all_orders(const Cloud& cloud, std::vector<unsigned> orders) {
  std::uint32_t flip_before = cloud.size(), hull_before = cloud.size(), best_before = cloud.size();
  for (const unsigned k : orders) {
    SCOPED_TRACE("order " + std::to_string(k));
    const Minimized flip = support::minimize(cloud, Method::flip, k);
    const Minimized hull = support::minimize(cloud, Method::hull, k, 2);
    const Minimized best = support::minimize(cloud, Method::best, k, 2);
    for (const Minimized* m : {&flip, &hull, &best}) check(cloud, *m, k);
    EXPECT_LE(flip.pits.total, flip_before);
    EXPECT_LE(hull.pits.total, hull_before);
    EXPECT_LE(best.pits.total, std::min({best_before, flip.pits.total, hull.pits.total}));
    flip_before = flip.pits.total;
    hull_before = hull.pits.total;
    best_before = best.pits.total;
    EXPECT_EQ(best.triangulation, support::minimize(cloud, Method::best, k, 1).triangulation);
  }
}

TEST(LargeSets, LatticeWithFewLevels) {
  check_all_orders(lattice(34, 4), {0, 1, 2, 3, 8});
}
TEST(LargeSets, LatticeWithManyLevels) {
  check_all_orders(lattice(30, 1000000), {0, 1, 4, 8});
}
TEST(LargeSets, AllLevel) {
  const Cloud flat = lattice(20, 1);
  check_all_orders(flat, {0, 4});
  EXPECT_EQ(support::minimize(flat, Method::best, 3).pits.total, 1u);
}
TEST(LargeSets, RingAmongOthers) {
  check_all_orders(ring_with_others(), {0, 1, 2, 5, 8});
}
TEST(LargeSets, ScatteredWithFlats) {
  check_all_orders(scattered(1500, 12), {0, 1, 2, 4, 8});
}
TEST(LargeSets, Scattered) {
  check_all_orders(scattered(1500, 1000000), {0, 1, 2, 4, 8, 12});
}

}  // namespace
