/// What may be done to the input without changing the answer, and what must not matter far away.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "support/draws.hpp"

namespace {

using support::any_method;
using support::Cloud;
using support::minimize;
using support::orders;
using support::shape;
using thalweg::Method;
using thalweg::Minimized;

/// Moves that are exact change nothing: the library sees signs only.
RC_GTEST_PROP(MetamorphicLaws, ExactMovesChangeNothing, ()) {
  const Cloud cloud = *support::clouds(30);
  const unsigned k = *orders();
  const Method method = any_method();
  const Minimized here = minimize(cloud, method, k);
  const auto same = [&](const Cloud& moved) {
    const Minimized there = minimize(moved, method, k);
    return shape(there) == shape(here) && there.pits == here.pits && there.lower_bound == here.lower_bound;
  };

  Cloud shifted = cloud;
  const double dx = *rc::gen::inRange(-100000, 100000), dy = 4503599627000000.0;
  for (auto& p : shifted.points) p = {p.x + dx, p.y + dy, p.z};
  RC_ASSERT(same(shifted));

  for (const int exponent : {-1074, -500, 3, 1000}) RC_ASSERT(same(support::scaled(cloud, exponent)));

  std::map<double, double> level;  // any strictly monotone map of elevations
  for (const auto& p : cloud.points) level[p.z] = 0;
  double height = *rc::gen::element(-1.7e308, -1e9, -5e-324, 0.0, 1e300);
  for (auto& [z, raised_to] : level) {
    raised_to = height;
    const double steps[] = {std::nextafter(height, 1e308), height + std::fabs(height) / 3, height + 1};
    height = std::max(steps[0], steps[*rc::gen::inRange(0, 3)]);
  }
  Cloud mapped = cloud;
  for (auto& p : mapped.points) p.z = level[p.z];
  RC_ASSERT(same(mapped));

  Cloud raised = cloud;
  for (auto& p : raised.points) p.z = -std::ldexp(1.0, -static_cast<int>(p.z));
  RC_ASSERT(same(raised));
  Cloud stretched = cloud;
  for (auto& p : stretched.points) p.z = 3 * p.z * p.z * p.z - 1e9;
  RC_ASSERT(same(stretched));
}

/// Turning and mirroring keep everything where no four sites are cocircular and no two level: nothing is then
/// decided by ties of coordinates.
RC_GTEST_PROP(MetamorphicLaws, TurnsAndMirrorsInGeneralPosition, ()) {
  Cloud cloud = *support::clouds(25);
  std::uint64_t state = *rc::gen::arbitrary<std::uint64_t>();
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    auto& p = cloud.points[i];
    p = {p.x * 2000 + static_cast<double>((state >> 20) % 1999),
         p.y * 2000 + static_cast<double>((state >> 40) % 1999), p.z * 1000 + i};
  }
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const auto& q = cloud.points;
    for (std::uint32_t j = 0; j < i; ++j) RC_PRE(q[i].x != q[j].x || q[i].y != q[j].y);
  }
  const support::Prepared p(cloud);
  for (const oracle::Tri& t : support::triangles_of(p.delaunay)) {
    for (std::uint32_t v = 0; v < cloud.size(); ++v) {
      if (v == t[0] || v == t[1] || v == t[2]) continue;
      RC_PRE(oracle::in_circle(p.sites[t[0]], p.sites[t[1]], p.sites[t[2]], p.sites[v]) != 0);
    }
  }
  const unsigned k = *orders();
  const Method method = any_method();
  const Minimized here = minimize(cloud, method, k);
  for (int image = 1; image < 8; ++image) {
    Cloud moved = cloud;
    for (auto& q : moved.points) {
      if ((image & 4) != 0) q.x = -q.x;
      for (int turns = image & 3; turns > 0; --turns) q = {-q.y, q.x, q.z};
    }
    const Minimized there = minimize(moved, method, k);
    RC_LOG() << "image " << image << "\n";
    RC_ASSERT(here.delaunay_pits == there.delaunay_pits);
    RC_ASSERT(here.lower_bound == there.lower_bound);
    RC_ASSERT(here.pits == there.pits);
    auto triangles = support::triangles_of(there.triangulation);
    if ((image & 4) != 0) {
      for (oracle::Tri& t : triangles) std::swap(t[0], t[1]);
    }
    RC_ASSERT(shape(here) == oracle::normal_form(triangles));
  }
}

/// The hill country of a cloud in a wide frame of sites, higher than all of it and the higher the farther
/// out, so that no site of the frame is a pit; and sites far beyond, higher still.
struct Island {
  Cloud alone, with_others;
  std::uint32_t inner = 0;  // sites of the country: the first ones
};

Island draw_island() {
  Island island;
  std::vector<thalweg::Point3> points;
  const Cloud country = *support::clouds(20);
  for (const auto& p : country.points) {
    if (std::max(std::fabs(p.x), std::fabs(p.y)) <= 40) points.push_back(p);
  }
  for (int i = 0; i < 3; ++i) points.push_back({double(i), double(i % 2), double(9 - i)});
  island.alone = support::make_cloud(points);
  island.inner = island.alone.size();
  points = island.alone.points;
  for (int ring = 60; ring <= 180; ring += 20) {
    for (int at = -ring; at < ring; at += 20) {
      for (const auto& [x, y] : {std::pair(at, -ring), {ring, at}, {-at, ring}, {-ring, -at}}) {
        points.push_back({double(x), double(y), 2000.0 + x * x + y * y});
      }
    }
  }
  island.alone = support::make_cloud(points);
  const auto others = *rc::gen::resize(20, rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(
                                               rc::gen::inRange(-9000, 9000), rc::gen::inRange(5000, 9000))));
  for (const auto& [across, out] : others) {
    const double x = (across & 1) != 0 ? across : out, y = (across & 1) != 0 ? out : across;
    points.push_back({x, (across & 2) != 0 ? y : -y, 1e9 + x * x + y * y});
  }
  island.with_others = support::make_cloud(points);
  return island;
}

/// The triangles with a corner in the country.
std::vector<oracle::Tri> inner_triangles(const Island& island, const Minimized& m) {
  std::vector<oracle::Tri> inner;
  for (const oracle::Tri& t : shape(m)) {
    if (std::min({t[0], t[1], t[2]}) < island.inner) inner.push_back(t);
  }
  return inner;
}

RC_GTEST_PROP(MetamorphicLaws, FarSitesChangeNothingWhereNoCircleReachesThem, ()) {
  const Island island = draw_island();
  const unsigned k = *orders();
  const Method method = any_method();
  RC_LOG() << "with: ";
  support::showValue(island.with_others, RC_LOG());
  const Minimized alone = minimize(island.alone, method, k), with = minimize(island.with_others, method, k);
  RC_ASSERT(with.pits.total == alone.pits.total);
  RC_ASSERT(with.delaunay_pits.total == alone.delaunay_pits.total);
  RC_ASSERT(with.lower_bound == alone.lower_bound);
  RC_ASSERT(inner_triangles(island, with) == inner_triangles(island, alone));
}

/// Work that is really shared: enough of it for eight threads.
TEST(MetamorphicLaws, OneToEightThreadsAgree) {
  support::Cloud cloud;
  std::uint64_t state = 5;
  std::vector<thalweg::Point3> points;
  for (int i = 0; i < 40000; ++i) {
    const auto draw = [&](std::uint64_t below) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      return static_cast<double>((state >> 33) % below);
    };
    const double x = draw(1500), y = draw(1500);
    points.push_back({x, y, draw(200)});
  }
  cloud = support::make_cloud(points);
  for (const Method method : {Method::flip, Method::best}) {
    const Minimized one = minimize(cloud, method, 3, 1);
    for (unsigned threads = 2; threads <= 8; ++threads) {
      const Minimized many = minimize(cloud, method, 3, threads);
      ASSERT_TRUE(many.triangulation == one.triangulation) << threads;
      ASSERT_EQ(many.face_orders, one.face_orders) << threads;
      ASSERT_EQ(many.lower_bound, one.lower_bound) << threads;
      ASSERT_EQ(many.circle_counts, one.circle_counts) << threads;
    }
  }
}

}  // namespace
