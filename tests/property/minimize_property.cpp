/// What must hold for every terrain the library makes: section 2 of the design, one law each.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
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

RC_GTEST_PROP(MinimizeLaws, TellsTheTruth, ()) {
  const Cloud cloud = *support::clouds(25);
  const unsigned k = *orders();
  const Method method = any_method();
  const auto lie = support::find_lie(cloud, minimize(cloud, method, k), k);
  if (lie) RC_FAIL(*lie);
}

RC_GTEST_PROP(MinimizeLaws, GivesTheRightReasons, ()) {
  const Cloud cloud = *support::clouds(25);
  const unsigned k = *orders();
  const Method method = any_method();
  const auto wrong = support::find_wrong_reason(cloud, minimize(cloud, method, k), k);
  if (wrong) RC_FAIL(*wrong);
}

/// Every triangulation of a small set is looked at: none has fewer pits than the bound says, and no result
/// fewer than the best of them.
RC_GTEST_PROP(MinimizeLaws, BoundAndResultEncloseTheOptimum, ()) {
  const Cloud cloud = *support::clouds(7);
  const auto fewest = oracle::fewest_pits(oracle::sites_of(std::span<const thalweg::Point3>(cloud.points)));
  for (unsigned k = 0; k < fewest.size(); ++k) {
    for (const Method method : {Method::flip, Method::hull, Method::best, Method::exact}) {
      RC_LOG() << support::method_name(method) << " at order " << k << "\n";
      const Minimized m = minimize(cloud, method, k);
      RC_ASSERT(m.lower_bound <= fewest[k]);
      RC_ASSERT(m.pits.total >= fewest[k]);
      RC_ASSERT(!m.certified || m.pits.total == fewest[k]);
      RC_ASSERT(method != Method::exact || m.pits.total == fewest[k]);
      // At order 1 the hull heuristic is optimal; flips can get into each other's way, see below.
      RC_ASSERT(k != 1 || method == Method::flip || m.pits.total == fewest[k]);
    }
  }
}

/// The flip of (1, 1) - (4, 4) to the level pair (1, 4) - (4, 0) takes away the quadrilateral in which the
/// pit (1, 0) could drain to (4, 4): with collinear sites or level ground flips are not optimal at order 1.
TEST(MinimizeAtOrderOne, HullsDrainWhatFlipsBlock) {
  const Cloud cloud{{{1, 4, 0}, {1, 0, 1}, {4, 0, 2}, {1, 1, 2}, {4, 4, 0}}};
  EXPECT_EQ(minimize(cloud, Method::hull, 1).pits.total, 1u);
  EXPECT_EQ(minimize(cloud, Method::best, 1).pits.total, 1u);
  EXPECT_TRUE(minimize(cloud, Method::best, 1).certified);
}

RC_GTEST_PROP(MinimizeLaws, OrderOfRowsDoesNotMatter, ()) {
  const Cloud cloud = *support::clouds(40);
  const unsigned k = *orders();
  const Method method = any_method();
  const auto order = support::permutation(cloud.size(), *rc::gen::arbitrary<std::uint64_t>());
  const Minimized there = minimize(support::permuted(cloud, order), method, k);
  const Minimized here = minimize(cloud, method, k);
  std::vector<oracle::Tri> moved = support::triangles_of(here.triangulation);
  for (oracle::Tri& t : moved) t = {order[t[0]], order[t[1]], order[t[2]]};
  RC_ASSERT(oracle::normal_form(moved) == shape(there));
  RC_ASSERT(here.lower_bound == there.lower_bound);
  RC_ASSERT(here.order_searched == there.order_searched);
  RC_ASSERT(here.trail.size() == there.trail.size());
  for (std::size_t i = 0; i < here.trail.size(); ++i) {
    RC_ASSERT(order[here.trail[i].u.index()] == there.trail[i].u.index());
    RC_ASSERT(order[here.trail[i].v.index()] == there.trail[i].v.index());
  }
}

RC_GTEST_PROP(MinimizeLaws, NumberOfThreadsDoesNotMatter, ()) {
  const Cloud cloud = *support::clouds(60);
  const unsigned k = *orders();
  const Method method = any_method();
  const Minimized one = minimize(cloud, method, k, 1);
  for (const unsigned threads : {2u, 3u, 4u, 5u, 6u, 7u, 8u, 0u}) {
    const Minimized many = minimize(cloud, method, k, threads);
    RC_ASSERT(many.triangulation == one.triangulation);
    RC_ASSERT(many.face_orders == one.face_orders);
    RC_ASSERT(many.lower_bound == one.lower_bound);
    RC_ASSERT(many.circle_counts == one.circle_counts);
    RC_ASSERT(many.order_searched == one.order_searched);
    RC_ASSERT(many.trail.size() == one.trail.size());
  }
}

RC_GTEST_PROP(MinimizeLaws, CounterDoesNotMatter, ()) {
  const Cloud cloud = *support::clouds(40);
  thalweg::MinimizeOptions options;
  options.order = *orders();
  options.method = any_method();
  options.threads = 1;
  const Minimized crawled = thalweg::minimize_pits(cloud.points, options).value();
  options.counter = thalweg::Counter::voronoi;
  const Minimized located = thalweg::minimize_pits(cloud.points, options).value();
  RC_ASSERT(located.triangulation == crawled.triangulation);
  RC_ASSERT(located.face_orders == crawled.face_orders);
  RC_ASSERT(located.lower_bound == crawled.lower_bound);
  RC_ASSERT(located.circle_counts == crawled.circle_counts);
}

RC_GTEST_PROP(MinimizeLaws, LargerOrderIsNeverWorse, ()) {
  const Cloud cloud = *support::clouds(40);
  std::map<Method, std::uint32_t> least;
  for (unsigned k = 0; k <= 8; ++k) {
    const std::uint32_t flip = minimize(cloud, Method::flip, k).pits.total;
    const std::uint32_t hull = minimize(cloud, Method::hull, k).pits.total;
    const Minimized best = minimize(cloud, Method::best, k);
    RC_LOG() << "order " << k << "\n";
    RC_ASSERT(best.pits.total <= std::min(flip, hull));
    if (k > 0) {
      RC_ASSERT(flip <= least[Method::flip]);
      RC_ASSERT(hull <= least[Method::hull]);
      RC_ASSERT(best.pits.total <= least[Method::best]);
    }
    least[Method::flip] = flip;
    least[Method::hull] = hull;
    least[Method::best] = best.pits.total;
  }
}

RC_GTEST_PROP(SweepLaws, IsEveryRunAtOnce, ()) {
  const Cloud cloud = *support::clouds(30);
  const unsigned first = *rc::gen::inRange(0u, 4u);
  const unsigned last = first + *rc::gen::inRange(0u, 5u);
  const auto sweep = thalweg::sweep_pits(cloud.points, first, last);
  RC_ASSERT(static_cast<bool>(sweep));
  RC_ASSERT(sweep->sites == cloud.size());
  RC_ASSERT(sweep->rows.size() == last - first + 1);
  for (unsigned k = first; k <= last; ++k) {
    const thalweg::SweepRow& row = sweep->rows[k - first];
    const Minimized best = minimize(cloud, Method::best, k);
    RC_LOG() << "order " << k << "\n";
    RC_ASSERT(row.order == k);
    RC_ASSERT(row.flip == minimize(cloud, Method::flip, k).pits.total);
    RC_ASSERT(row.hull == minimize(cloud, Method::hull, k).pits.total);
    RC_ASSERT(row.best == best.pits.total);
    RC_ASSERT(row.lower_bound == best.lower_bound);
    RC_ASSERT(row.certified == best.certified);
  }
}

/// Rows at the same place: the result is that of the merged rows, by each policy.
RC_GTEST_PROP(DuplicateLaws, AreMergedByThePolicy, ()) {
  const Cloud cloud = *support::clouds(20);
  const unsigned k = *orders();
  std::vector<thalweg::Point3> rows = cloud.points;
  const auto copies = *rc::gen::container<std::vector<std::pair<int, int>>>(
      rc::gen::pair(rc::gen::inRange(0, 1000), rc::gen::inRange(-5, 30)));
  for (const auto& [of, z] : copies) {
    const auto& p = cloud.points[static_cast<std::size_t>(of) % cloud.points.size()];
    rows.push_back({p.x, p.y, static_cast<double>(z)});
  }
  using Policy = thalweg::DuplicatePolicy;
  const Policy policy = *rc::gen::element(Policy::lowest, Policy::highest, Policy::first, Policy::last);

  Cloud merged = cloud;
  for (std::size_t i = cloud.points.size(); i < rows.size(); ++i) {
    for (std::size_t j = 0; j < cloud.points.size(); ++j) {
      if (rows[i].x != rows[j].x || rows[i].y != rows[j].y) continue;
      double& z = merged.points[j].z;
      if (policy == Policy::lowest) z = std::min(z, rows[i].z);
      if (policy == Policy::highest) z = std::max(z, rows[i].z);
      if (policy == Policy::last) z = rows[i].z;
    }
  }
  thalweg::MinimizeOptions options;
  options.order = k;
  options.duplicates = policy;
  const auto result = thalweg::minimize_pits(rows, options);
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(result->sites == cloud.size());
  RC_ASSERT(result->merged.size() == rows.size() - cloud.points.size());
  RC_ASSERT(result->triangulation.vertex_count() == rows.size());

  std::map<std::pair<double, double>, std::uint32_t> place;
  for (std::uint32_t j = 0; j < cloud.size(); ++j) place[{rows[j].x, rows[j].y}] = j;
  const auto place_of = [&](std::uint32_t row) { return place.at({rows[row].x, rows[row].y}); };
  for (const auto& [gone, stands] : result->merged) {
    RC_ASSERT(gone != stands);
    RC_ASSERT(place_of(gone) == place_of(stands));
    RC_ASSERT(result->triangulation.isolated(support::vertex(gone)));
    RC_ASSERT(rows[stands].z == merged.points[place_of(stands)].z);
  }
  auto triangles = support::triangles_of(result->triangulation);
  for (oracle::Tri& t : triangles) {
    for (const std::uint32_t row : t) RC_ASSERT(rows[row].z == merged.points[place_of(row)].z);
    t = {place_of(t[0]), place_of(t[1]), place_of(t[2])};
  }
  RC_ASSERT(oracle::normal_form(triangles) == shape(minimize(merged, Method::best, k)));
}

/// Under DuplicatePolicy::mean a merged site has the mean of its rows, reported by the row that stands for
/// it.
RC_GTEST_PROP(DuplicateLaws, MeanIsReported, ()) {
  const Cloud cloud = *support::clouds(15);
  std::vector<thalweg::Point3> rows = cloud.points;
  Cloud merged = cloud;
  const auto copies = *rc::gen::inRange<std::size_t>(0, cloud.points.size() + 1);
  for (std::size_t i = 0; i < copies; ++i) {  // integers of equal parity: the mean is exact
    rows.push_back({cloud.points[i].x, cloud.points[i].y, cloud.points[i].z + 2 * static_cast<double>(i)});
    merged.points[i].z += static_cast<double>(i);
  }
  thalweg::MinimizeOptions options;
  options.duplicates = thalweg::DuplicatePolicy::mean;
  const auto result = thalweg::minimize_pits(rows, options);
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(result->merged.size() == copies);
  for (const auto& [row, z] : result->mean_elevations) {
    const auto same = [&, r = row](const thalweg::Point3& p) { return p.x == rows[r].x && p.y == rows[r].y; };
    const auto at = std::find_if(merged.points.begin(), merged.points.end(), same);
    RC_ASSERT(at != merged.points.end() && at->z == z);
  }
  RC_ASSERT(result->pits == minimize(merged, Method::best, options.order).pits);

  options.duplicates = thalweg::DuplicatePolicy::error;
  const auto refused = thalweg::minimize_pits(rows, options);
  RC_ASSERT(static_cast<bool>(refused) == (copies == 0));
  if (!refused) {
    RC_ASSERT(refused.error().code == thalweg::ErrorCode::duplicate_points);
    RC_ASSERT(!refused.error().rows.empty());
  }
}

}  // namespace
