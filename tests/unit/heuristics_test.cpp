/// flip_pits, insert_hulls, insert_overlapping on terrains small enough to know the answer; and what is
/// measured of their changes, against a full recount.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "oracle/terrain.hpp"
#include "support/cloud.hpp"
#include "support/random_mesh.hpp"
#include "support/surface.hpp"
#include "terrain/changes.hpp"
#include "terrain/flip.hpp"
#include "terrain/hull.hpp"

namespace {

using support::surface_of;
using support::triangles_of;
using support::vertex;
using thalweg::FaceId;
using thalweg::Point3;
using thalweg::TrailStep;
using thalweg::VertexId;
using thalweg::detail::changed_faces;
using thalweg::detail::edge_changes;
using thalweg::detail::find_exits;
using thalweg::detail::flip_pits;
using thalweg::detail::insert_hulls;
using thalweg::detail::insert_overlapping;
using thalweg::detail::Outcome;
using thalweg::detail::Surface;
using thalweg::detail::Watch;

Watch with_trail() {
  Watch watch;
  watch.keep_trail = true;
  return watch;
}

Outcome hulls(const Surface& surface, unsigned k, const Watch& watch = {}) {
  return insert_hulls(surface, find_exits(surface, k, 1, nullptr), k, watch);
}

TEST(FlipPits, OpensADamOfOneEdge) {
  const Surface surface = surface_of(support::dammed_valley());
  ASSERT_EQ(surface.pits().size(), 2u);
  std::vector<std::uint32_t> pits_at;
  const Outcome outcome = flip_pits(surface, 1, with_trail(), &pits_at);
  EXPECT_EQ(outcome.pits, 1u);
  EXPECT_EQ(pits_at, (std::vector<std::uint32_t>{2, 1}));
  EXPECT_TRUE(outcome.triangulation.joined(vertex(0), vertex(1)));
  EXPECT_FALSE(outcome.triangulation.joined(vertex(2), vertex(3)));
  EXPECT_EQ(outcome.flips, outcome.trail.size());
  EXPECT_GE(outcome.circle_counts, 2 * outcome.flips);  // both new triangles of each
  const auto step = std::find_if(outcome.trail.begin(), outcome.trail.end(),
                                 [](const TrailStep& s) { return s.pit.valid(); });
  ASSERT_NE(step, outcome.trail.end());
  EXPECT_EQ(step->kind, TrailStep::Kind::flip);
  EXPECT_EQ(step->order, 1u);
  EXPECT_EQ(step->u, vertex(1));  // the lower end
  EXPECT_EQ(step->v, vertex(0));
  EXPECT_EQ(std::minmax(step->old_u, step->old_v), std::minmax(vertex(2), vertex(3)));
  EXPECT_EQ(step->pit, vertex(0));
}

TEST(FlipPits, DoesNothingAtOrderZero) {
  const Surface surface = surface_of(support::dammed_valley());
  std::vector<std::uint32_t> pits_at;
  const Outcome outcome = flip_pits(surface, 0, with_trail(), &pits_at);
  EXPECT_EQ(outcome.triangulation, surface.delaunay());
  EXPECT_EQ(outcome.pits, 2u);
  EXPECT_EQ(outcome.flips, 0u);
  EXPECT_TRUE(outcome.trail.empty());
  EXPECT_EQ(pits_at, std::vector<std::uint32_t>{2});
}

TEST(FlipPits, JoinsTwoLakesIntoOne) {
  auto points = support::dammed_valley();
  points[0].z = points[1].z = 0;
  const Surface surface = surface_of(points);
  ASSERT_EQ(surface.pits().size(), 2u);
  const Outcome outcome = flip_pits(surface, 1, {});
  EXPECT_EQ(outcome.pits, 1u);
  EXPECT_EQ(find_pits(outcome.triangulation, surface.z()).size(), 1u);
}

TEST(FlipPits, KeepsNoTrailUnlessAsked) {
  const Surface surface = surface_of(support::dammed_valley());
  EXPECT_TRUE(flip_pits(surface, 1, {}).trail.empty());
  EXPECT_TRUE(hulls(surface, 1).trail.empty());
}

TEST(FlipPits, StopsWhenCancelled) {
  const Surface surface = surface_of(support::dammed_valley());
  const std::atomic<bool> cancel{true};
  Watch watch;
  watch.cancel = &cancel;
  EXPECT_EQ(flip_pits(surface, 1, watch).flips, 0u);
  EXPECT_EQ(hulls(surface, 1, watch).insertions, 0u);
}

TEST(InsertHulls, OpensADamOfOneEdge) {
  const Surface surface = surface_of(support::dammed_valley());
  const Outcome outcome = hulls(surface, 1, with_trail());
  EXPECT_EQ(outcome.pits, 1u);
  EXPECT_EQ(outcome.insertions, 1u);
  ASSERT_EQ(outcome.trail.size(), 1u);
  const TrailStep& step = outcome.trail[0];
  EXPECT_EQ(step.kind, TrailStep::Kind::insertion);
  EXPECT_EQ(step.order, 1u);
  EXPECT_EQ(step.u, vertex(0));  // from the pit to where it drains
  EXPECT_EQ(step.v, vertex(1));
  EXPECT_EQ(step.pit, vertex(0));
  EXPECT_FALSE(step.old_u.valid());
  EXPECT_EQ(hulls(surface, 0).insertions, 0u);
}

TEST(InsertHulls, JoinsTwoLakesByOneOfTheirTwoExits) {
  auto points = support::dammed_valley();
  points[0].z = points[1].z = 0;
  const Surface surface = surface_of(points);
  const Outcome outcome = hulls(surface, 1, with_trail());
  EXPECT_EQ(outcome.pits, 1u);
  EXPECT_EQ(outcome.insertions, 1u);
}

/// Two dams on end, 1 - 2 and 3 - 4: the way out of 0 to 5 crosses both.
///
///          1     3
///      0   |     |   5
///          2     4
std::vector<Point3> two_dams() {
  return {{0, 0, 1},    {4, 2, 9},    {4, -2, 9},    {6, 3, 9},   {6, -3, 9},
          {10, 0.5, 0}, {-80, 70, 9}, {-80, -70, 9}, {90, 70, 9}, {90, -70, 9}};
}

TEST(InsertHulls, CrossesTwoDamsAtOnce) {
  const Surface surface = surface_of(two_dams());
  ASSERT_EQ(surface.pits().size(), 2u);
  const auto exits = find_exits(surface, 7, 1, nullptr);
  ASSERT_FALSE(exits.empty());
  EXPECT_EQ(exits[0].from, vertex(0));
  EXPECT_EQ(exits[0].to, vertex(5));
  const unsigned needed = exits[0].order;
  EXPECT_GE(needed, 2u);
  EXPECT_EQ(hulls(surface, needed).pits, 1u);
  EXPECT_EQ(hulls(surface, needed).insertions, 1u);
  EXPECT_EQ(hulls(surface, needed - 1).pits, 2u);
  // Flips have to open the dams one after the other, which needs no smaller order.
  EXPECT_EQ(flip_pits(surface, needed - 1, {}).pits, 2u);
}

TEST(InsertOverlapping, NeverRaisesTheCount) {
  const Surface surface = surface_of(support::crossroads());
  ASSERT_EQ(surface.pits().size(), 4u);
  for (unsigned k = 0; k <= 8; ++k) {
    const auto exits = find_exits(surface, k, 1, nullptr);
    Outcome outcome = insert_hulls(surface, exits, k, {});
    const std::uint32_t before = outcome.pits;
    insert_overlapping(surface, exits, k, {}, outcome);
    EXPECT_LE(outcome.pits, before);
    EXPECT_EQ(outcome.pits, find_pits(outcome.triangulation, surface.z()).size());
    for (const unsigned order : face_orders(surface.graph(), outcome.triangulation, 20)) EXPECT_LE(order, k);
  }
}

TEST(InsertOverlapping, OpensWhatHullsApartCannot) {
  // At order 5 hulls keep away from the first one; across it there is a way for all.
  const Surface surface = surface_of(support::crossroads());
  const auto exits = find_exits(surface, 5, 1, nullptr);
  Outcome outcome = insert_hulls(surface, exits, 5, with_trail());
  EXPECT_EQ(outcome.pits, 3u);
  insert_overlapping(surface, exits, 5, with_trail(), outcome);
  EXPECT_LT(outcome.pits, 3u);
  EXPECT_EQ(outcome.trail.size(), outcome.insertions);
}

TEST(Heuristics, OfTwoCrossingWaysOutOnlyOneIsTaken) {
  const Surface surface = surface_of(support::crossroads());
  EXPECT_EQ(reach_bound(surface, find_exits(surface, 3, 1, nullptr)), 2u);
  EXPECT_EQ(flip_pits(surface, 3, {}).pits, 3u);
  EXPECT_EQ(hulls(surface, 3).pits, 3u);
  EXPECT_EQ(hulls(surface, 2).pits, 4u);
}

/// edge_changes and orders by looking at everything.
struct Recount {
  std::uint32_t changed = 0, non_delaunay = 0;
};

Recount recount(std::span<const oracle::Site> s, const Surface& surface, const thalweg::Triangulation& t) {
  Recount result;
  const auto before = oracle::edges_of(triangles_of(surface.delaunay()));
  for (const auto& edge : oracle::edges_of(triangles_of(t))) {
    if (!std::binary_search(before.begin(), before.end(), edge)) ++result.changed;
  }
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    const thalweg::HalfedgeId h(i);
    if (t.on_hull(h) || t.twin(h) < h) continue;
    if (oracle::in_circle(s[t.origin(h).index()], s[t.dest(h).index()], s[t.apex(h).index()],
                          s[t.apex(t.twin(h)).index()]) > 0) {
      ++result.non_delaunay;
    }
  }
  return result;
}

double smallest_angle(std::span<const oracle::Site> s, const thalweg::Triangulation& t) {
  double smallest = 180;
  for (const oracle::Tri& f : triangles_of(t)) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto &a = s[f[i]], &b = s[f[(i + 1) % 3]], &c = s[f[(i + 2) % 3]];
      const double to_b = std::atan2(double(b.y - a.y), double(b.x - a.x));
      const double to_c = std::atan2(double(c.y - a.y), double(c.x - a.x));
      double angle = (to_c - to_b) * 180 / std::acos(-1.0);
      if (angle < 0) angle += 360;
      smallest = std::min(smallest, angle);
    }
  }
  return smallest;
}

RC_GTEST_PROP(ChangesLaws, EqualAFullRecount, ()) {
  const auto cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const auto s = oracle::sites_of(std::span<const Point3>(cloud.points));
  thalweg::Triangulation t = support::random_index(2) == 0
                                 ? surface.delaunay()
                                 : thalweg::Triangulation::revision_of(surface.delaunay());
  for (std::uint32_t i = support::random_index(30); i > 0; --i) support::flip_somewhere(s, t);

  const std::vector<FaceId> changed = changed_faces(surface, t);
  for (std::uint32_t f = 0; f < t.face_count(); ++f) {
    const bool same = t.corners(FaceId(f)) == surface.delaunay().corners(FaceId(f));
    RC_ASSERT(std::binary_search(changed.begin(), changed.end(), FaceId(f)) == !same);
  }
  const auto counted = edge_changes(surface, t, changed);
  const Recount expected = recount(s, surface, t);
  RC_ASSERT(counted.changed == expected.changed);
  RC_ASSERT(counted.non_delaunay == expected.non_delaunay);

  std::uint64_t counts = 7;
  const auto orders = orders_after(surface, t, changed, 50, 2, counts);
  RC_ASSERT(counts == 7 + changed.size());
  const auto triangles = triangles_of(t);
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    RC_ASSERT(orders[f] == oracle::triangle_order(s, triangles[f]));
  }
  const auto angles = smallest_angles(surface, t, 2);
  for (const auto& [deg, expected_deg] : {std::pair(angles.before_deg, smallest_angle(s, surface.delaunay())),
                                          std::pair(angles.after_deg, smallest_angle(s, t))})
    RC_ASSERT(std::abs(deg - expected_deg) <= 1e-9 * expected_deg + 1e-12);
}

TEST(Changes, OfNothingAreNone) {
  const Surface surface = surface_of(support::dammed_valley());
  const auto changed = changed_faces(surface, surface.delaunay());
  EXPECT_TRUE(changed.empty());
  const auto edges = edge_changes(surface, surface.delaunay(), changed);
  EXPECT_EQ(edges.changed, 0u);
  EXPECT_EQ(edges.non_delaunay, 0u);
}

/// Of a triangulation that has not changed.
double smallest_angle_deg(const Surface& surface) {
  const auto angles = smallest_angles(surface, surface.delaunay(), 1);
  EXPECT_EQ(angles.before_deg, angles.after_deg);
  return angles.before_deg;
}

TEST(MinAngle, OfRightTriangles) {
  const Surface square = surface_of(std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  EXPECT_NEAR(smallest_angle_deg(square), 45, 1e-12);
  const Surface thin = surface_of(std::vector<Point3>{{0, 0, 0}, {1e9, 0, 0}, {0, 1, 0}});
  EXPECT_NEAR(smallest_angle_deg(thin), 5.7295779513082e-8, 1e-18);
}

TEST(MinAngle, OfTheLargestAndTheSmallestTriangles) {
  for (const double size : {1e308, 1e-308}) {
    const Surface square = surface_of(
        std::vector<Point3>{{-size, -size, 0}, {size, -size, 0}, {size, size, 0}, {-size, size, 0}});
    EXPECT_NEAR(smallest_angle_deg(square), 45, 1e-12) << size;
  }
}

/// More triangles than one thread takes at a time, and the thinnest of them anywhere among these.
TEST(MinAngle, OfManyTriangles) {
  std::uint64_t state = 5;
  std::vector<Point3> points;
  for (int i = 0; i < 20000; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    points.push_back({double((state >> 33) % 1000), double((state >> 43) % 1000), double(i)});
  }
  points = support::make_cloud(points).points;
  ASSERT_GT(points.size(), 18000u);
  for (const double x : {0.25, 250.25, 500.25, 999.25}) {
    for (const double y : {0.0, 500.0, 999.0}) {
      std::vector<Point3> with_needle = points;
      with_needle.push_back({x, y + 0.25, 0});
      with_needle.push_back({x, y + 0.25 + 1e-7, 0});
      const Surface surface = surface_of(with_needle);
      const thalweg::Triangulation& t = surface.delaunay();
      double least = 180;
      for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
        const thalweg::HalfedgeId h(i);
        const auto at = [&](VertexId v) { return surface.sites()[v.index()]; };
        const auto a = at(t.origin(h)), b = at(t.dest(h)), c = at(t.apex(h));
        const double cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const double dot = (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
        least = std::min(least, std::atan2(cross, dot) * 180 / std::acos(-1.0));
      }
      EXPECT_NEAR(smallest_angle_deg(surface), least, 1e-9 * least) << x << " " << y;
    }
  }
}

/// Counts kept along the way are those of a full count, at every smaller order too; the trail names every pit
/// that went once.
RC_GTEST_PROP(FlipPitsLaws, PitsAreWhatIsFoundAfterwards, ()) {
  const auto cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const unsigned k = support::random_index(6);
  std::vector<std::uint32_t> flip_at, hull_at;
  const Outcome flips = flip_pits(surface, k, with_trail(), &flip_at);
  const auto exits = find_exits(surface, k, 1, nullptr);
  const Outcome inserted = insert_hulls(surface, exits, k, with_trail(), &hull_at);
  for (const Outcome* outcome : {&flips, &inserted}) {
    RC_ASSERT(outcome->pits == find_pits(outcome->triangulation, surface.z()).size());
    for (const unsigned order : face_orders(surface.graph(), outcome->triangulation, 100)) {
      RC_ASSERT(order <= k);
    }
  }
  RC_ASSERT(flip_at.size() == k + 1 && flip_at.front() == surface.pits().size());
  RC_ASSERT(hull_at.size() == k + 1);
  RC_ASSERT(std::is_sorted(flip_at.rbegin(), flip_at.rend()));
  RC_ASSERT(std::is_sorted(hull_at.rbegin(), hull_at.rend()));
  RC_ASSERT(flip_at.back() == flips.pits && hull_at.back() == inserted.pits);

  std::multiset<std::uint32_t> named;
  for (const TrailStep& step : flips.trail) {
    if (step.pit.valid()) named.insert(step.pit.index());
  }
  RC_ASSERT(named.size() == surface.pits().size() - flips.pits);
  for (const std::uint32_t v : named) RC_ASSERT(named.count(v) == 1u);
}

/// When a run of order k ends, no flip towards the lowest corner is left of which both triangles are of order
/// k; not even one that became possible late.
RC_GTEST_PROP(FlipPitsLaws, LeaveNothingToFlip, ()) {
  const auto cloud = *support::clouds(30);
  const Surface surface = surface_of(cloud.points);
  const auto s = oracle::sites_of(std::span<const Point3>(cloud.points));
  const unsigned k = support::random_index(7);
  const thalweg::Triangulation t = flip_pits(surface, k, {}).triangulation;
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    const thalweg::HalfedgeId h(i);
    if (k == 0 || !support::flippable(s, t, h)) continue;
    const VertexId a = t.origin(h), b = t.dest(h), c = t.apex(h), d = t.apex(t.twin(h));
    const bool towards_lowest = surface.lower(c, a) && surface.lower(c, b) && surface.lower(c, d);
    RC_ASSERT(!towards_lowest || std::max(oracle::triangle_order(s, d.index(), c.index(), a.index()),
                                          oracle::triangle_order(s, c.index(), d.index(), b.index())) > k);
  }
}

}  // namespace
