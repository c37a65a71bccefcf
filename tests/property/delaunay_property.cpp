/// Laws of the spatial order and of the canonical Delaunay triangulation, over point sets that are degenerate
/// on purpose.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "kernel/delaunay_sites.hpp"
#include "kernel/spatial_order.hpp"
#include "oracle/lawson.hpp"
#include "support/delaunay_check.hpp"
#include "support/ordered_sites.hpp"
#include "thalweg/delaunay.hpp"

namespace {

using support::Kind;
using support::Random;
using support::sites_in_order;
using thalweg::Point2;
using thalweg::Triangulation;
using thalweg::detail::spatial_order;
using thalweg::detail::SpatialOrder;

/// A number in [low, high), whatever the size parameter.
int between(int low, int high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high));
}

/// Some kind of point set with fewer than `most` points.
std::vector<Point2> any_points(int most) {
  const auto kind = static_cast<Kind>(between(0, static_cast<int>(Kind::kinds)));
  const int count = between(0, most);
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  return support::point_set(kind, static_cast<std::uint32_t>(count), seed);
}

std::vector<Point2> shuffled(std::vector<Point2> points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[random.below(static_cast<std::uint32_t>(i))]);
  }
  return points;
}

RC_GTEST_PROP(SpatialOrder, HoldsEveryRowOnceAndEqualPointsTogether, ()) {
  const auto points = any_points(300);
  const SpatialOrder order = spatial_order(points, 1);
  auto rows = order.rows;
  std::sort(rows.begin(), rows.end());
  for (std::uint32_t i = 0; i < rows.size(); ++i) RC_ASSERT(rows[i] == i);
  RC_ASSERT(rows.size() == points.size());
  RC_ASSERT(std::is_sorted(order.keys.begin(), order.keys.end()));

  std::map<std::pair<double, double>, std::vector<std::uint32_t>> groups;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    groups[{points[i].x + 0.0, points[i].y + 0.0}].push_back(i);
  RC_ASSERT(groups.size() == order.site_count());
  RC_ASSERT(order.distinct() == (groups.size() == points.size()));
  RC_ASSERT(std::ranges::equal(order.sites, sites_in_order(points, order)));
  for (std::uint32_t s = 0; s < order.site_count(); ++s) {
    const Point2 p = points[order.first_row(s)];
    const auto begin = order.rows.begin() + (order.distinct() ? s : order.starts[s]);
    const auto end = order.rows.begin() + (order.distinct() ? s + 1 : order.starts[s + 1]);
    RC_ASSERT(std::vector<std::uint32_t>(begin, end) == (groups[{p.x + 0.0, p.y + 0.0}]));
  }
}

RC_GTEST_PROP(SpatialOrder, DependsOnCoordinatesAlone, (std::uint32_t seed)) {
  const auto points = any_points(300);
  auto again = shuffled(points, seed);
  if (!points.empty()) again.insert(again.end(), 1 + seed % 60, points[seed % points.size()]);
  RC_ASSERT(sites_in_order(points, spatial_order(points, 1)) ==
            sites_in_order(again, spatial_order(again, 2)));
}

RC_GTEST_PROP(Delaunay, IsCanonicalOnEveryKindOfPoints, ()) {
  const auto points = any_points(150);
  const auto t = thalweg::delaunay(points);
  if (t) RC_ASSERT(support::fault_of(points, *t) == "");
  const auto sites = sites_in_order(points, spatial_order(points, 1));
  bool flat = true;
  for (std::size_t i = 2; i < sites.size(); ++i)
    flat = flat && oracle::orient2d(sites[0], sites[1], sites[i]) == 0;
  RC_ASSERT(static_cast<bool>(t) == !flat);
  if (!t && sites.size() < 3) RC_ASSERT(t.error().code == thalweg::ErrorCode::too_few_points);
  if (!t && sites.size() >= 3) RC_ASSERT(t.error().code == thalweg::ErrorCode::all_collinear);
}

RC_GTEST_PROP(Delaunay, EqualsTheSlowConstruction, (std::uint32_t seed)) {
  const int width = between(1, 14), height = between(1, 14), count = between(0, 60);
  Random random(seed);
  std::vector<Point2> points;
  std::vector<oracle::lawson::GridPoint> grid;
  std::set<oracle::lawson::GridPoint> seen;
  for (int i = 0; i < count; ++i) {
    const oracle::lawson::GridPoint p{random.below(static_cast<std::uint32_t>(width)),
                                      random.below(static_cast<std::uint32_t>(height))};
    if (!seen.insert(p).second) continue;
    grid.push_back(p);
    points.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  }
  std::set<oracle::lawson::IndexTriangle> found;
  if (const auto t = thalweg::delaunay(points)) {
    for (std::uint32_t f = 0; f < t->face_count(); ++f) {
      const thalweg::Triangle c = t->corners(thalweg::FaceId(f));
      found.insert(oracle::lawson::rotated_to_lowest({c[0].index(), c[1].index(), c[2].index()}));
    }
  }
  RC_ASSERT(found == oracle::lawson::delaunay(grid));
}

RC_GTEST_PROP(Delaunay, SameTrianglesWhateverTheOrderOfRows, (std::uint32_t seed)) {
  const auto points = any_points(300);
  const auto again = shuffled(points, seed);
  const auto t = thalweg::delaunay(points);
  const auto u = thalweg::delaunay(again);
  RC_PRE(static_cast<bool>(t));
  RC_ASSERT(static_cast<bool>(u));
  RC_ASSERT(support::triangle_set(points, *t) == support::triangle_set(again, *u));
}

RC_GTEST_PROP(Delaunay, SameArraysAfterExactTranslationAndScaling, (std::uint32_t seed)) {
  Random random(seed);
  std::vector<Point2> points(3 + random.below(200));
  for (Point2& p : points) p = {random.whole(0, 40), random.whole(0, 40)};
  const auto t = thalweg::delaunay(points);
  RC_PRE(static_cast<bool>(t));
  const double dx = random.whole(-1000000, 1000000), dy = random.whole(-1000000, 1000000);
  const int exponent = static_cast<int>(random.whole(-1074, 990));
  for (Point2& p : points) p = {std::ldexp(p.x + dx, exponent), std::ldexp(p.y + dy, exponent)};
  const auto moved = thalweg::delaunay(points);
  RC_ASSERT(static_cast<bool>(moved));
  RC_ASSERT(*moved == *t);
}

RC_GTEST_PROP(Delaunay, SameForSitesInOrderWithAndWithoutKeys, ()) {
  const auto points = any_points(300);
  const SpatialOrder order = spatial_order(points, 1);
  const auto sites = sites_in_order(points, order);
  const auto t = thalweg::detail::delaunay_of_sites(sites, 1);
  const auto u = thalweg::detail::delaunay_of_sites(sites, order.keys, 1);
  const auto v = thalweg::delaunay(sites);
  RC_ASSERT(static_cast<bool>(t) == static_cast<bool>(u));
  RC_ASSERT(static_cast<bool>(t) == static_cast<bool>(v));
  RC_PRE(static_cast<bool>(t));
  RC_ASSERT(*t == *u);
  RC_ASSERT(*t == *v);
}

}  // namespace
