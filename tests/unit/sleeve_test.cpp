/// find_sleeve and triangulate_polygon: segments that cross one edge or many, vertices passed twice,
/// cocircular chains.
#include "kernel/sleeve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernel/edge_insertion.hpp"
#include "kernel/polygon.hpp"
#include "oracle/terrain.hpp"
#include "support/prepared.hpp"

namespace {

using support::vertex;
using thalweg::Point2;
using thalweg::Triangle;
using thalweg::Triangulation;
using thalweg::VertexId;
using thalweg::detail::EdgeInsertion;
using thalweg::detail::find_sleeve;
using thalweg::detail::Sleeve;
using thalweg::detail::triangulate_polygon;

using Ids = std::vector<std::uint32_t>;

Triangulation mesh(const std::vector<oracle::Tri>& triangles, std::uint32_t vertices) {
  return Triangulation::from_triangles(support::with_ids(triangles), vertices).value();
}

template <class Range>
Ids indices(const Range& range) {
  Ids result;
  for (const auto id : range) result.push_back(id.index());
  return result;
}

std::vector<VertexId> vertices(const Ids& ids) {
  std::vector<VertexId> result;
  for (const std::uint32_t i : ids) result.push_back(vertex(i));
  return result;
}

std::vector<oracle::Tri> polygon(const std::vector<Point2>& sites, std::uint32_t from, std::uint32_t to,
                                 const Ids& chain) {
  std::vector<Triangle> triangles;
  triangulate_polygon(sites, vertex(from), vertex(to), vertices(chain), triangles);
  std::vector<oracle::Tri> result;
  for (const Triangle& t : triangles) result.push_back({t[0].index(), t[1].index(), t[2].index()});
  return oracle::normal_form(result);
}

using Tris = std::vector<oracle::Tri>;

///     3---4---5
///     | \ | / |
///     0---1---2
const std::vector<Point2> kStrip = {{0, 0}, {2, 0}, {4, 0}, {0, 2}, {2, 2}, {4, 2}};
const std::vector<oracle::Tri> kStripFaces = {{0, 1, 3}, {1, 4, 3}, {1, 5, 4}, {1, 2, 5}};

TEST(Sleeve, CrossesOneEdge) {
  const Triangulation t = mesh(kStripFaces, 6);
  Sleeve sleeve;
  ASSERT_TRUE(find_sleeve(t, kStrip, vertex(0), vertex(4), sleeve));
  EXPECT_EQ(indices(sleeve.faces), (Ids{0, 1}));
  EXPECT_EQ(indices(sleeve.left), Ids{3});
  EXPECT_EQ(indices(sleeve.right), Ids{1});
  ASSERT_TRUE(find_sleeve(t, kStrip, vertex(4), vertex(0), sleeve));
  EXPECT_EQ(indices(sleeve.faces), (Ids{1, 0}));
  EXPECT_EQ(indices(sleeve.left), Ids{1});
  EXPECT_EQ(indices(sleeve.right), Ids{3});
}

TEST(Sleeve, CrossesSeveralEdgesInOrder) {
  const Triangulation t = mesh(kStripFaces, 6);
  Sleeve sleeve;
  ASSERT_TRUE(find_sleeve(t, kStrip, vertex(0), vertex(5), sleeve));
  EXPECT_EQ(indices(sleeve.faces), (Ids{0, 1, 2}));
  EXPECT_EQ(indices(sleeve.left), (Ids{3, 4}));
  EXPECT_EQ(indices(sleeve.right), Ids{1});
}

TEST(Sleeve, IsOverwritten) {
  const Triangulation t = mesh(kStripFaces, 6);
  Sleeve sleeve;
  ASSERT_TRUE(find_sleeve(t, kStrip, vertex(0), vertex(5), sleeve));
  ASSERT_TRUE(find_sleeve(t, kStrip, vertex(2), vertex(4), sleeve));
  EXPECT_EQ(sleeve.faces.size(), 2u);
  EXPECT_EQ(sleeve.left.size() + sleeve.right.size(), 2u);
}

TEST(Sleeve, RefusesAVertexThatIsANeighborOnTheSegment) {
  Sleeve sleeve;
  const Triangulation t = mesh(kStripFaces, 6);
  EXPECT_FALSE(find_sleeve(t, kStrip, vertex(0), vertex(2), sleeve));  // along the hull
  EXPECT_FALSE(find_sleeve(t, kStrip, vertex(5), vertex(3), sleeve));
}

TEST(Sleeve, RefusesAVertexFartherOnTheSegment) {
  // From 0 to 6 the segment crosses the edge 1 - 2 and then meets 5.
  const std::vector<Point2> sites = {{0, 0}, {2, -1}, {2, 1}, {8, -1}, {8, 1}, {4, 0}, {10, 0}};
  const Triangulation t = mesh({{0, 1, 2}, {1, 5, 2}, {1, 3, 5}, {2, 5, 4}, {5, 3, 6}, {5, 6, 4}}, 7);
  Sleeve sleeve;
  EXPECT_TRUE(find_sleeve(t, sites, vertex(0), vertex(5), sleeve));
  EXPECT_FALSE(find_sleeve(t, sites, vertex(0), vertex(6), sleeve));
  EXPECT_FALSE(find_sleeve(t, sites, vertex(6), vertex(0), sleeve));
  EdgeInsertion insertion;
  EXPECT_FALSE(insertion.plan(t, sites, vertex(0), vertex(6)));
}

/// 0 far on the left, 1 far on the right, between them posts in two rows, zigzag.
TEST(Sleeve, CrossesManyEdges) {
  constexpr std::uint32_t kPosts = 200;
  std::vector<Point2> sites = {{-1, 0}, {kPosts, 0}};
  for (std::uint32_t i = 0; i < kPosts; ++i) sites.push_back({double(i), i % 2 == 0 ? 1.0 : -1.0});
  std::vector<oracle::Tri> faces = {{0, 3, 2}, {1, kPosts, kPosts + 1}};
  for (std::uint32_t i = 2; i + 2 < kPosts + 2; ++i) {
    faces.push_back(i % 2 == 0 ? oracle::Tri{i, i + 1, i + 2} : oracle::Tri{i, i + 2, i + 1});
  }
  Triangulation t = mesh(faces, kPosts + 2);
  Sleeve sleeve;
  ASSERT_TRUE(find_sleeve(t, sites, vertex(0), vertex(1), sleeve));
  EXPECT_EQ(sleeve.faces.size(), kPosts);
  ASSERT_EQ(sleeve.left.size(), kPosts / 2);
  ASSERT_EQ(sleeve.right.size(), kPosts / 2);
  for (std::uint32_t i = 0; i < kPosts / 2; ++i) {
    EXPECT_EQ(sleeve.left[i], vertex(2 + 2 * i));
    EXPECT_EQ(sleeve.right[i], vertex(3 + 2 * i));
  }
  EdgeInsertion insertion;
  ASSERT_TRUE(insertion.plan(t, sites, vertex(0), vertex(1)));
  EXPECT_EQ(insertion.vertices().size(), kPosts + 2);
  insertion.apply(t);
  EXPECT_EQ(t.find_fault(), std::nullopt);
  EXPECT_TRUE(t.joined(vertex(0), vertex(1)));
}

/// The triangle 1, 3, 2 with 4 inside; the segment 0 - 5 passes under 4, so 2 is on its left before and
/// after.
const std::vector<Point2> kPocket = {{-20, 0}, {-5, -10}, {0, 10}, {5, -10}, {0, 1}, {20, 0}};
const std::vector<oracle::Tri> kPocketFaces = {{0, 1, 2}, {1, 4, 2}, {1, 3, 4}, {4, 3, 2}, {3, 5, 2}};

TEST(Sleeve, NamesAVertexTwiceThatItPassesTwice) {
  const Triangulation t = mesh(kPocketFaces, 6);
  Sleeve sleeve;
  ASSERT_TRUE(find_sleeve(t, kPocket, vertex(0), vertex(5), sleeve));
  EXPECT_EQ(indices(sleeve.faces), (Ids{0, 1, 2, 3, 4}));
  EXPECT_EQ(indices(sleeve.left), (Ids{2, 4, 2}));
  EXPECT_EQ(indices(sleeve.right), (Ids{1, 3}));
  ASSERT_TRUE(find_sleeve(t, kPocket, vertex(5), vertex(0), sleeve));
  EXPECT_EQ(indices(sleeve.left), (Ids{3, 1}));
  EXPECT_EQ(indices(sleeve.right), (Ids{2, 4, 2}));
}

TEST(EdgeInsertionDangling, KeepsTheDanglingEdge) {
  Triangulation t = mesh(kPocketFaces, 6);
  EdgeInsertion insertion;
  ASSERT_TRUE(insertion.plan(t, kPocket, vertex(0), vertex(5)));
  EXPECT_EQ(indices(insertion.vertices()), (Ids{0, 5, 2, 4, 2, 1, 3}));
  insertion.apply(t);
  EXPECT_EQ(t.find_fault(), std::nullopt);
  EXPECT_EQ(oracle::normal_form(support::triangles_of(t)),
            (Tris{{0, 1, 3}, {0, 3, 5}, {0, 4, 2}, {0, 5, 4}, {2, 4, 5}}));
}

/// A long thin fan: tip 2 high up, feet 3, 5, 7, ... below the segment 0 - 1, and between each two feet a
/// vertex 4, 6, ... inside the fan's triangle, just above the segment. The tip is passed before and after
/// every one.
TEST(EdgeInsertionDangling, AFanPassedManyTimes) {
  constexpr int kFeet = 12;
  std::vector<Point2> sites = {{-100, 0}, {100, 0}, {0, 10000}};
  std::vector<oracle::Tri> faces;
  for (int i = 0; i < kFeet; ++i) {
    sites.push_back({12.0 * i - 66, -5});
    sites.push_back({12.0 * i - 60, 1.0 + i % 3});
  }
  sites.pop_back();
  std::vector<oracle::Site> s = oracle::sites_of(std::span<const Point2>(sites));
  const auto last = static_cast<std::uint32_t>(sites.size()) - 1;
  faces.push_back({0, 3, 2});
  for (std::uint32_t foot = 3; foot < last; foot += 2) {
    faces.push_back({foot, foot + 1, 2});
    faces.push_back({foot, foot + 2, foot + 1});
    faces.push_back({foot + 1, foot + 2, 2});
  }
  faces.push_back({last, 1, 2});
  Triangulation t = mesh(faces, last + 1);
  const Triangulation before = t;

  Sleeve sleeve;
  ASSERT_TRUE(find_sleeve(t, sites, vertex(0), vertex(1), sleeve));
  EXPECT_EQ(sleeve.left.size(), 2u * kFeet - 1);
  EXPECT_EQ(std::count(sleeve.left.begin(), sleeve.left.end(), vertex(2)), kFeet);
  EXPECT_EQ(sleeve.right.size(), static_cast<std::size_t>(kFeet));

  EdgeInsertion insertion;
  ASSERT_TRUE(insertion.plan(t, sites, vertex(0), vertex(1)));
  insertion.apply(t);
  EXPECT_EQ(t.find_fault(), std::nullopt);
  for (std::uint32_t i = 4; i < last; i += 2) EXPECT_TRUE(t.joined(vertex(2), vertex(i)));
  std::int64_t area_before = 0, area_after = 0;
  for (const oracle::Tri& f : faces) area_before += oracle::area(s[f[0]], s[f[1]], s[f[2]]);
  for (const oracle::Tri& f : support::triangles_of(t)) {
    EXPECT_GT(oracle::area(s[f[0]], s[f[1]], s[f[2]]), 0);
    area_after += oracle::area(s[f[0]], s[f[1]], s[f[2]]);
  }
  EXPECT_EQ(area_before, area_after);
  insertion.undo(t);
  EXPECT_EQ(support::triangles_of(t), support::triangles_of(before));
}

TEST(Polygon, OfOneVertexIsOneTriangle) {
  EXPECT_EQ(polygon(kStrip, 0, 2, {4}), (Tris{{0, 2, 4}}));
  EXPECT_EQ(polygon(kStrip, 0, 2, {}), Tris{});
}

TEST(Polygon, TakesTheApexWithTheEmptyCircle) {
  const std::vector<Point2> sites = {{-3, 0}, {3, 0}, {-2, 2}, {0, 9}, {2, 2}};
  EXPECT_EQ(polygon(sites, 0, 1, {2, 3, 4}), (Tris{{0, 1, 4}, {0, 4, 2}, {2, 4, 3}}));
}

TEST(Polygon, IsAppended) {
  std::vector<Triangle> triangles = {{vertex(7), vertex(8), vertex(9)}};
  triangulate_polygon(kStrip, vertex(0), vertex(2), vertices({4}), triangles);
  ASSERT_EQ(triangles.size(), 2u);
  EXPECT_EQ(triangles[0], (Triangle{vertex(7), vertex(8), vertex(9)}));
}

/// On one circle the triangulation is the canonical Delaunay one, however its polygon is presented.
TEST(Polygon, OfCocircularVerticesIsCanonical) {
  const std::vector<Point2> circle = support::integer_circle(65);
  const auto n = static_cast<std::uint32_t>(circle.size());
  const Triangulation delaunay = thalweg::delaunay(circle).value();
  const Tris expected = oracle::normal_form(support::triangles_of(delaunay));
  ASSERT_EQ(expected.size(), n - 2);
  for (std::uint32_t base = 0; base < n; ++base) {
    // The side base -> base + 1 of the whole polygon: the chain leads around, listed from `from` to `to`.
    Ids chain;
    for (std::uint32_t i = 1; i + 1 < n; ++i) chain.push_back((base + n - i) % n);
    EXPECT_EQ(polygon(circle, base, (base + 1) % n, chain), expected);
  }
}

TEST(Polygon, SplitsDeepWithoutRecursion) {
  // On a parabola every apex is an end of its chain: the splits go as deep as the chain is long.
  std::vector<Point2> sites = {{0, 0}, {1, 0}};
  Ids chain;
  for (std::uint32_t i = 2; i < 2000; ++i) {
    sites.push_back({double(i), double(i) * (i - 1)});
    chain.insert(chain.begin(), i);
  }
  const Tris triangles = polygon(sites, 0, 1, chain);
  EXPECT_EQ(triangles.size(), chain.size());
  EXPECT_EQ(triangles[0], (oracle::Tri{0, 1, 2}));
}

TEST(EdgeInsertion, RefusesWhatIsJoined) {
  const Triangulation t = mesh(kStripFaces, 6);
  EdgeInsertion insertion;
  EXPECT_FALSE(insertion.plan(t, kStrip, vertex(1), vertex(3)));
  EXPECT_FALSE(insertion.plan(t, kStrip, vertex(1), vertex(0)));  // a hull edge that runs the other way
  EXPECT_FALSE(insertion.plan(t, kStrip, vertex(0), vertex(1)));
  EXPECT_TRUE(insertion.plan(t, kStrip, vertex(0), vertex(4)));
}

TEST(EdgeInsertion, UndoGivesTheSameArraysOfCorners) {
  Triangulation t = mesh(kStripFaces, 6);
  const Triangulation before = t;
  EdgeInsertion insertion;
  ASSERT_TRUE(insertion.plan(t, kStrip, vertex(0), vertex(5)));
  EXPECT_EQ(insertion.triangles().size(), insertion.faces().size());
  EXPECT_EQ(t, before);  // a plan changes nothing
  insertion.apply(t);
  EXPECT_EQ(t.find_fault(), std::nullopt);
  for (std::size_t i = 0; i < insertion.faces().size(); ++i) {
    EXPECT_EQ(t.corners(insertion.faces()[i]), insertion.triangles()[i]);
  }
  insertion.undo(t);
  EXPECT_TRUE(std::ranges::equal(t.origins(), before.origins()));
  EXPECT_TRUE(std::ranges::equal(t.twins(), before.twins()));
  EXPECT_EQ(t.find_fault(), std::nullopt);
}

}  // namespace
