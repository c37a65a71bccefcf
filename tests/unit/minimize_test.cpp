/// minimize_pits and sweep_pits from outside: refusals, options, and what is reported of known terrains.
#include "thalweg/minimize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "support/cloud.hpp"
#include "support/special_values.hpp"
#include "support/surface.hpp"

namespace {

using support::crossroads;
using support::dammed_valley;
using support::kInfinity;
using support::kNan;
using thalweg::DuplicatePolicy;
using thalweg::ErrorCode;
using thalweg::Method;
using thalweg::Minimized;
using thalweg::MinimizeOptions;
using thalweg::PitCount;
using thalweg::PitReason;
using thalweg::Point3;
using thalweg::RemainingPit;
using thalweg::Result;
using thalweg::TrailStep;
using thalweg::VertexId;

constexpr Method kMethods[] = {Method::delaunay, Method::flip, Method::hull, Method::best, Method::exact};

using Rows = std::vector<std::uint32_t>;

MinimizeOptions with(Method method, unsigned order) {
  MinimizeOptions options;
  options.method = method;
  options.order = order;
  options.threads = 1;
  return options;
}

Minimized run(const std::vector<Point3>& points, Method method, unsigned order) {
  return minimize_pits(points, with(method, order)).value();
}

Rows vertices(const std::vector<RemainingPit>& pits) {
  Rows result;
  for (const RemainingPit& pit : pits) result.push_back(pit.vertex.index());
  return result;
}

Rows vertices(const std::vector<thalweg::RemovedPit>& pits) {
  Rows result;
  for (const auto& pit : pits) result.push_back(pit.vertex.index());
  return result;
}

TEST(MinimizePits, RefusesRowsThatAreNotFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int column = 0; column < 3; ++column) {
      auto points = dammed_valley();
      (column == 0 ? points[3].x : column == 1 ? points[3].y : points[3].z) = bad;
      points[6].z = kNan;
      const auto refused = minimize_pits(points);
      ASSERT_FALSE(refused);
      EXPECT_EQ(refused.error().code, ErrorCode::not_finite);
      EXPECT_EQ(refused.error().rows, (Rows{3, 6}));
      EXPECT_NE(refused.error().message.find("row 3"), std::string::npos);
      const auto sweep = sweep_pits(points, 0, 2);
      ASSERT_FALSE(sweep);
      EXPECT_EQ(sweep.error().code, ErrorCode::not_finite);
    }
  }
}

TEST(MinimizePits, RefusesTooFewPoints) {
  const std::vector<std::vector<Point3>> clouds = {
      {}, {{1, 2, 3}}, {{1, 2, 3}, {3, 4, 5}}, {{1, 2, 3}, {3, 4, 5}, {1, 2, 9}, {3, 4, 0}}};
  for (const auto& points : clouds) {
    const auto refused = minimize_pits(points);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::too_few_points);
    EXPECT_FALSE(refused.error().message.empty());
    EXPECT_EQ(sweep_pits(points, 0, 1).error().code, ErrorCode::too_few_points);
  }
}

TEST(MinimizePits, RefusesCollinearPoints) {
  std::vector<Point3> points;
  for (int i = 0; i < 9; ++i) points.push_back({0.1 * i, 0.3 * i, double(i)});
  for (Point3& p : points) p = {p.z * 3, p.z * 7, p.z};
  const auto refused = minimize_pits(points);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::all_collinear);
  EXPECT_EQ(sweep_pits(points, 0, 1).error().code, ErrorCode::all_collinear);
}

TEST(MinimizePits, RefusesDuplicatesIfAsked) {
  auto points = dammed_valley();
  points.push_back({0, 1, 2});
  auto options = with(Method::best, 1);
  options.duplicates = DuplicatePolicy::error;
  const auto refused = minimize_pits(points, options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::duplicate_points);
  EXPECT_EQ(refused.error().rows, (Rows{2, 8}));
  EXPECT_EQ(sweep_pits(points, 0, 1, options).error().code, ErrorCode::duplicate_points);
}

TEST(MinimizePits, OneTriangle) {
  for (const Method method : kMethods) {
    for (const unsigned order : {0u, 8u}) {
      const Minimized m = run({{0, 0, 2}, {1, 0, 1}, {0, 1, 3}}, method, order);
      EXPECT_EQ(m.triangulation.face_count(), 1u);
      EXPECT_EQ(m.pits, (PitCount{1, 0, 1}));
      EXPECT_EQ(m.lower_bound, 1u);
      EXPECT_TRUE(m.certified);
      ASSERT_EQ(m.remaining.size(), 1u);
      EXPECT_EQ(m.remaining[0].vertex, VertexId(1));
      EXPECT_EQ(m.remaining[0].reason, PitReason::unremovable);
      EXPECT_EQ(m.remaining[0].order_needed, std::nullopt);
    }
  }
}

TEST(MinimizePits, AFlatWorldIsOnePit) {
  for (const Method method : kMethods) {
    auto points = crossroads();
    for (Point3& p : points) p.z = -7;
    const Minimized m = run(points, method, 3);
    EXPECT_EQ(m.pits, (PitCount{1, 0, 1}));
    EXPECT_TRUE(m.certified);
    ASSERT_EQ(m.remaining.size(), 1u);
    EXPECT_EQ(m.remaining[0].vertices, points.size());
    EXPECT_EQ(m.remaining[0].order_needed, std::nullopt);
  }
}

TEST(MinimizePits, OrderZeroIsTheDelaunayTriangulation) {
  for (const Method method : kMethods) {
    const Minimized m = run(dammed_valley(), method, 0);
    EXPECT_EQ(m.pits, m.delaunay_pits);
    EXPECT_EQ(m.pits, (PitCount{2, 2, 0}));
    EXPECT_TRUE(m.certified);
    EXPECT_EQ(m.edges_changed, 0u);
    EXPECT_EQ(m.non_delaunay_edges, 0u);
    EXPECT_EQ(vertices(m.remaining), (Rows{0, 1}));
    EXPECT_EQ(m.remaining[0].reason, PitReason::unremovable);
    EXPECT_EQ(m.remaining[0].order_needed, 1u);
    EXPECT_GE(m.order_searched, 1u);
    EXPECT_TRUE(m.removed.empty());
    for (const std::uint32_t order : m.face_orders) EXPECT_EQ(order, 0u);
    EXPECT_EQ(m.min_angle_before_deg, m.min_angle_after_deg);
  }
}

TEST(MinimizePits, OpensADam) {
  for (const Method method : {Method::flip, Method::hull, Method::best, Method::exact}) {
    const Minimized m = run(dammed_valley(), method, 1);
    EXPECT_EQ(m.delaunay_pits, (PitCount{2, 2, 0}));
    EXPECT_EQ(m.pits, (PitCount{1, 1, 0}));
    EXPECT_EQ(m.lower_bound, 1u);
    EXPECT_TRUE(m.certified);
    EXPECT_EQ(vertices(m.remaining), Rows{1});
    EXPECT_EQ(vertices(m.removed), Rows{0});
    EXPECT_TRUE(m.triangulation.joined(VertexId(0), VertexId(1)));
    EXPECT_FALSE(m.triangulation.joined(VertexId(2), VertexId(3)));
    EXPECT_EQ(*std::max_element(m.face_orders.begin(), m.face_orders.end()), 1u);
  }
  const Minimized m = run(dammed_valley(), Method::best, 1);
  EXPECT_EQ(m.edges_changed, 1u);
  EXPECT_EQ(m.non_delaunay_edges, 1u);
}

TEST(MinimizePits, DelaunayKeepsWhatItCouldRemove) {
  const Minimized m = run(dammed_valley(), Method::delaunay, 1);
  EXPECT_EQ(m.pits.total, 2u);
  EXPECT_EQ(m.lower_bound, 1u);
  EXPECT_FALSE(m.certified);
  ASSERT_EQ(m.remaining.size(), 2u);
  EXPECT_EQ(m.remaining[0].reason, PitReason::kept);
  EXPECT_EQ(m.remaining[0].order_needed, 1u);
  EXPECT_EQ(m.remaining[1].reason, PitReason::unremovable);
}

TEST(MinimizePits, SaysWhichPitLostTheConflict) {
  for (const Method method : {Method::best, Method::exact}) {
    const Minimized m = run(crossroads(), method, 3);
    EXPECT_EQ(m.delaunay_pits.total, 4u);
    EXPECT_EQ(m.pits.total, 3u);
    EXPECT_EQ(m.lower_bound, 3u);  // the reach bound alone is 2
    EXPECT_TRUE(m.certified);
    ASSERT_EQ(m.remaining.size(), 3u);
    ASSERT_EQ(m.removed.size(), 1u);
    const std::uint32_t removed = m.removed[0].vertex.index();
    EXPECT_TRUE(removed == 0 || removed == 2);
    EXPECT_EQ(m.remaining[0].vertex.index(), removed == 0 ? 1u : 0u);
    for (const RemainingPit& pit : m.remaining) {
      switch (pit.vertex.index()) {
        case 1:
          EXPECT_EQ(pit.reason, PitReason::unremovable);
          EXPECT_EQ(pit.order_needed, std::nullopt);
          break;
        case 3:
          EXPECT_EQ(pit.reason, PitReason::unremovable);
          EXPECT_EQ(pit.order_needed, 5u);
          break;
        default:
          EXPECT_EQ(pit.reason, PitReason::conflict);
          EXPECT_EQ(pit.order_needed, 3u);
      }
    }
  }
}

TEST(MinimizePits, BestFindsMoreThanTheHeuristics) {
  EXPECT_EQ(run(crossroads(), Method::flip, 5).pits.total, 2u);
  EXPECT_EQ(run(crossroads(), Method::hull, 5).pits.total, 3u);
  const Minimized m = run(crossroads(), Method::best, 5);
  EXPECT_EQ(m.pits.total, 1u);
  EXPECT_TRUE(m.certified);
}

TEST(MinimizePits, OrdersBeyondTheNumberOfSitesAreAllTheSame) {
  for (const Method method : kMethods) {
    const auto points = crossroads();
    const auto largest = static_cast<unsigned>(points.size()) - 3;
    const Minimized expected = run(points, method, largest);
    for (const unsigned order : {largest + 1, 1000u, 2'000'000'000u, std::numeric_limits<unsigned>::max()}) {
      const Minimized m = run(points, method, order);
      EXPECT_EQ(m.triangulation, expected.triangulation);
      EXPECT_EQ(m.lower_bound, expected.lower_bound);
      EXPECT_EQ(m.face_orders, expected.face_orders);
    }
  }
}

TEST(MinimizePits, ReportsDuplicates) {
  auto points = dammed_valley();
  points.insert(points.begin(), {0, 1, 6});  // every row moves by one; the dam's end is now rows 0 and 3
  points.push_back({-2, 0, 0.5});            // a lower elevation for the pit of row 1
  const Minimized m = run(points, Method::best, 1);
  EXPECT_EQ(m.sites, 8u);
  EXPECT_EQ(m.merged, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{0, 3}, {1, 9}}));
  EXPECT_TRUE(m.mean_elevations.empty());
  EXPECT_EQ(m.triangulation.vertex_count(), 10u);
  EXPECT_TRUE(m.triangulation.isolated(VertexId(0)));
  EXPECT_TRUE(m.triangulation.isolated(VertexId(1)));
  EXPECT_FALSE(m.triangulation.isolated(VertexId(9)));
  EXPECT_EQ(vertices(m.removed), Rows{9});
  EXPECT_EQ(vertices(m.remaining), Rows{2});

  auto options = with(Method::best, 1);
  options.duplicates = DuplicatePolicy::mean;
  const Minimized mean = minimize_pits(points, options).value();
  EXPECT_EQ(mean.mean_elevations, (std::vector<std::pair<std::uint32_t, double>>{{0, 5.5}, {1, 0.75}}));
  EXPECT_EQ(mean.merged, (std::vector<std::pair<std::uint32_t, std::uint32_t>>{{3, 0}, {9, 1}}));
}

TEST(MinimizePits, KeepsATrailIfAsked) {
  for (const Method method : kMethods) {
    auto options = with(method, 1);
    EXPECT_TRUE(minimize_pits(dammed_valley(), options)->trail.empty());
    options.keep_trail = true;
    const Minimized m = minimize_pits(dammed_valley(), options).value();
    if (method == Method::delaunay) {
      EXPECT_TRUE(m.trail.empty());
      continue;
    }
    ASSERT_FALSE(m.trail.empty());
    EXPECT_EQ(m.trail.size(), m.flips + m.insertions);
    EXPECT_EQ(std::count_if(m.trail.begin(), m.trail.end(),
                            [](const TrailStep& step) { return step.pit == VertexId(0); }),
              1);
  }
}

TEST(MinimizePits, NamesTheCallersRowsInTheTrail) {
  auto points = crossroads();
  auto options = with(Method::hull, 5);
  options.keep_trail = true;
  const auto here = minimize_pits(points, options).value().trail;
  std::reverse(points.begin(), points.end());
  const auto there = minimize_pits(points, options).value().trail;
  const auto last = static_cast<std::uint32_t>(points.size()) - 1;
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(here[i].u.index(), last - there[i].u.index());
    EXPECT_EQ(here[i].v.index(), last - there[i].v.index());
    EXPECT_EQ(here[i].pit.index(), last - there[i].pit.index());
    EXPECT_FALSE(there[i].old_u.valid());
  }
}

TEST(MinimizePits, CancelledBeforeItBegins) {
  const std::atomic<bool> cancel{true};
  for (const Method method : kMethods) {
    auto options = with(method, 5);
    options.cancel = &cancel;
    const auto cancelled = minimize_pits(crossroads(), options);
    ASSERT_FALSE(cancelled);
    EXPECT_EQ(cancelled.error().code, ErrorCode::cancelled);
    EXPECT_EQ(sweep_pits(crossroads(), 0, 5, options).error().code, ErrorCode::cancelled);
  }
}

TEST(MinimizePits, CancelledAtAnyReportOfProgress) {
  for (const Method method : kMethods) {
    for (int stop = 1;; ++stop) {
      std::atomic<bool> cancel{false};
      int reports = 0;
      auto options = with(method, 5);
      options.cancel = &cancel;
      options.progress = [&](const char*, double) { cancel = ++reports >= stop; };
      const auto result = minimize_pits(crossroads(), options);
      EXPECT_EQ(static_cast<bool>(result), reports < stop);
      if (result) break;
      EXPECT_EQ(result.error().code, ErrorCode::cancelled);
      ASSERT_LT(stop, 1000);
    }
  }
}

TEST(MinimizePits, ReportsProgressFromTheCallingThread) {
  const auto caller = std::this_thread::get_id();
  for (const Method method : kMethods) {
    auto options = with(method, 5);
    options.threads = 3;
    std::map<std::string, double> fractions;
    options.progress = [&](const char* stage, double fraction) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      EXPECT_GE(fraction, 0);
      EXPECT_LE(fraction, 1);
      const auto [known, fresh] = fractions.emplace(stage, fraction);
      EXPECT_LE(known->second, fraction) << stage;
      known->second = fraction;
    };
    ASSERT_TRUE(minimize_pits(crossroads(), options));
    EXPECT_GE(fractions.size(), 3u);
  }
}

TEST(MinimizePits, ElevationsMayBeAnyFiniteDoubles) {
  auto points = dammed_valley();
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  points[0].z = kTiny;
  points[1].z = -0.0;
  for (std::size_t i = 2; i < points.size(); ++i) points[i].z = std::numeric_limits<double>::max();
  EXPECT_EQ(run(points, Method::delaunay, 1).pits.total, 2u);
  EXPECT_EQ(run(points, Method::best, 1).pits.total, 1u);
  points[0].z = 0.0;  // as high as -0.0
  const Minimized m = run(points, Method::best, 1);
  EXPECT_EQ(m.pits.total, 1u);
  ASSERT_EQ(m.remaining.size(), 1u);
  EXPECT_EQ(m.remaining[0].vertices, 2u);
}

/// Enough sites that every stage is shared among threads.
TEST(MinimizePits, IsTheSameOnAnyNumberOfThreads) {
  std::uint64_t state = 3;
  const auto next = [&state](std::uint64_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>((state >> 33) % below);
  };
  std::vector<Point3> points;
  for (int i = 0; i < 9000; ++i) points.push_back({next(1 << 20), next(1 << 20), next(1000)});
  for (const Method method : {Method::flip, Method::best}) {
    MinimizeOptions options = with(method, 2);
    const Minimized alone = minimize_pits(points, options).value();
    options.threads = 3;
    const Minimized shared = minimize_pits(points, options).value();
    EXPECT_EQ(shared.triangulation, alone.triangulation);
    EXPECT_EQ(shared.face_orders, alone.face_orders);
    EXPECT_EQ(shared.circle_counts, alone.circle_counts);
    EXPECT_EQ(shared.lower_bound, alone.lower_bound);
    EXPECT_EQ(shared.min_angle_before_deg, alone.min_angle_before_deg);
    EXPECT_EQ(shared.min_angle_after_deg, alone.min_angle_after_deg);
    EXPECT_EQ(vertices(shared.remaining), vertices(alone.remaining));
    EXPECT_EQ(vertices(shared.removed), vertices(alone.removed));
    EXPECT_EQ(*std::max_element(alone.face_orders.begin(), alone.face_orders.end()), 2u);
  }
}

TEST(SweepPits, RefusesAnEmptyRange) {
  const auto refused = sweep_pits(dammed_valley(), 3, 2);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalid_argument);
}

TEST(SweepPits, TakesAMillionOrders) {
  const auto sweep = sweep_pits(dammed_valley(), 1, 1'000'000);
  ASSERT_TRUE(sweep);
  ASSERT_EQ(sweep->rows.size(), 1'000'000u);
  EXPECT_EQ(sweep->rows.back().order, 1'000'000u);
  EXPECT_EQ(sweep->rows.back().best, 1u);
  EXPECT_EQ(sweep_pits(dammed_valley(), 0, 1'000'000).error().code, ErrorCode::invalid_argument);
}

TEST(SweepPits, EqualsEveryRunByItself) {
  const auto sweep = sweep_pits(crossroads(), 1, 30);
  ASSERT_TRUE(sweep);
  EXPECT_EQ(sweep->sites, 24u);
  ASSERT_EQ(sweep->rows.size(), 30u);
  for (const auto& row : sweep->rows) {
    EXPECT_EQ(row.order, static_cast<unsigned>(&row - sweep->rows.data()) + 1);
    EXPECT_EQ(row.flip, run(crossroads(), Method::flip, row.order).pits.total);
    EXPECT_EQ(row.hull, run(crossroads(), Method::hull, row.order).pits.total);
    const Minimized best = run(crossroads(), Method::best, row.order);
    EXPECT_EQ(row.best, best.pits.total);
    EXPECT_EQ(row.lower_bound, best.lower_bound);
    EXPECT_EQ(row.certified, best.certified);
  }
}

TEST(SweepPits, OfOrdersBeyondTheSitesOnly) {
  constexpr unsigned kMost = std::numeric_limits<unsigned>::max();
  const auto sweep = sweep_pits(crossroads(), kMost - 1, kMost);
  ASSERT_TRUE(sweep);
  ASSERT_EQ(sweep->rows.size(), 2u);
  EXPECT_EQ(sweep->rows[1].order, kMost);
  EXPECT_EQ(sweep->rows[1].best, run(crossroads(), Method::best, 21).pits.total);
  EXPECT_EQ(sweep->rows[0].flip, run(crossroads(), Method::flip, 21).pits.total);
}

TEST(SweepPits, ReportsProgressUpToOne) {
  MinimizeOptions options;
  double last = 0;
  options.progress = [&](const char*, double fraction) { last = fraction; };
  ASSERT_TRUE(sweep_pits(dammed_valley(), 0, 3, options));
  EXPECT_EQ(last, 1);
}

}  // namespace
