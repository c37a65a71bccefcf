/// Triangulation: flip, replace, renamed.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "oracle/terrain.hpp"
#include "support/prepared.hpp"
#include "support/random_mesh.hpp"
#include "thalweg/triangulation.hpp"

namespace {

using support::tri;
using support::triangles_of;
using support::vertex;
using thalweg::FaceId;
using thalweg::HalfedgeId;
using thalweg::Triangle;
using thalweg::Triangulation;
using thalweg::VertexId;

/// All but `outgoing` of inner vertices, which edits may turn to another half-edge.
void expect_same_faces(const Triangulation& a, const Triangulation& b) {
  EXPECT_TRUE(std::ranges::equal(a.origins(), b.origins()));
  EXPECT_TRUE(std::ranges::equal(a.twins(), b.twins()));
}

std::vector<FaceId> faces(std::initializer_list<std::uint32_t> ids) {
  std::vector<FaceId> result;
  for (const std::uint32_t i : ids) result.emplace_back(i);
  return result;
}

TEST(TriangulationFlip, ReplacesTheDiagonalAsDrawn) {
  //  a = 0, b = 1, c = 2, d = 3
  Triangulation t = *Triangulation::from_triangles(std::vector{tri(0, 1, 2), tri(1, 0, 3)}, 4);
  const HalfedgeId h = t.find_halfedge(vertex(0), vertex(1));
  const FaceId here = Triangulation::face(h), there = Triangulation::face(t.twin(h));
  EXPECT_EQ(t.flip(h), h);
  EXPECT_EQ(t.origin(h), vertex(3));
  EXPECT_EQ(t.dest(h), vertex(2));
  EXPECT_EQ(t.apex(h), vertex(0));
  EXPECT_EQ(t.apex(t.twin(h)), vertex(1));
  EXPECT_EQ(Triangulation::face(h), here);
  EXPECT_EQ(Triangulation::face(t.twin(h)), there);
  EXPECT_FALSE(t.joined(vertex(0), vertex(1)));
  EXPECT_TRUE(t.joined(vertex(3), vertex(2)));
  EXPECT_EQ(t.find_fault(), std::nullopt);
}

TEST(TriangulationFlip, KeepsOutgoingOfHullVerticesOnTheHull) {
  Triangulation t = *Triangulation::from_triangles(std::vector{tri(2, 0, 1), tri(3, 1, 0)}, 4);
  t.flip(t.find_halfedge(vertex(1), vertex(0)));
  for (std::uint32_t v = 0; v < 4; ++v) {
    EXPECT_EQ(t.origin(t.outgoing(vertex(v))), vertex(v));
    EXPECT_TRUE(t.on_hull(t.outgoing(vertex(v))));
  }
  EXPECT_EQ(t.find_fault(), std::nullopt);
}

TEST(TriangulationFlip, TwiceIsTheSameTriangulationAndFourTimesTheSameArrays) {
  const support::Cloud cloud{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 2, 0}, {3, 2, 0}, {-1, 2, 0}}};
  const support::Prepared prepared(cloud);
  Triangulation t = prepared.delaunay;
  const auto before = oracle::normal_form(triangles_of(t));
  int flipped = 0;
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    if (!support::flippable(prepared.sites, t, HalfedgeId(i))) continue;
    ++flipped;
    for (int turn = 1; turn <= 4; ++turn) {
      t.flip(HalfedgeId(i));
      ASSERT_EQ(t.find_fault(), std::nullopt);
      EXPECT_EQ(oracle::normal_form(triangles_of(t)) == before, turn % 2 == 0);
    }
    expect_same_faces(t, prepared.delaunay);
  }
  EXPECT_GT(flipped, 5);
}

RC_GTEST_PROP(TriangulationFlipLaws, KeepsAllInvariants, ()) {
  const auto cloud = *support::clouds(20);
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
  Triangulation t = support::triangulation_of(sites);
  for (int i = 0; i < 15; ++i) {
    support::flip_somewhere(sites, t);
    RC_ASSERT(t.find_fault() == std::nullopt);
  }
  RC_ASSERT(oracle::is_triangulation(sites, triangles_of(t)));
}

/// A strip on the hull, its middle filled in two ways.
///
///     3---4---5
///     | \ | / |
///     0---1---2
class TriangulationReplace : public ::testing::Test {
 protected:
  Triangulation mesh_ =
      *Triangulation::from_triangles(std::vector{tri(0, 1, 3), tri(1, 4, 3), tri(1, 5, 4), tri(1, 2, 5)}, 6);
};

TEST_F(TriangulationReplace, ChangesTheseFacesAndNoOther) {
  const Triangulation before = mesh_;
  const std::vector<FaceId> olds = faces({1, 0});
  mesh_.replace(olds, std::vector{tri(4, 0, 1), tri(0, 4, 3)});
  EXPECT_EQ(mesh_.corners(FaceId(1)), tri(4, 0, 1));
  EXPECT_EQ(mesh_.corners(FaceId(0)), tri(0, 4, 3));
  EXPECT_EQ(mesh_.corners(FaceId(2)), before.corners(FaceId(2)));
  EXPECT_EQ(mesh_.find_fault(), std::nullopt);

  mesh_.replace(olds, std::vector{before.corners(olds[0]), before.corners(olds[1])});
  expect_same_faces(mesh_, before);
  EXPECT_EQ(mesh_.find_fault(), std::nullopt);
}

TEST_F(TriangulationReplace, OfEveryFaceByItself) {
  const Triangulation before = mesh_;
  mesh_.replace(faces({0, 1, 2, 3}), std::vector{tri(0, 1, 3), tri(1, 4, 3), tri(1, 5, 4), tri(1, 2, 5)});
  EXPECT_EQ(mesh_, before);
}

TEST_F(TriangulationReplace, TurnsAndSwapsFaces) {
  mesh_.replace(faces({0, 1, 2, 3}), std::vector{tri(5, 1, 2), tri(5, 4, 1), tri(3, 1, 4), tri(3, 0, 1)});
  EXPECT_EQ(mesh_.corners(FaceId(3)), tri(3, 0, 1));
  EXPECT_EQ(mesh_.find_fault(), std::nullopt);
  EXPECT_TRUE(mesh_.joined(vertex(3), vertex(0)));
}

TEST_F(TriangulationReplace, OfNothing) {
  const Triangulation before = mesh_;
  mesh_.replace({}, {});
  EXPECT_EQ(mesh_, before);
}

/// The triangle v, r, s (2, 1, 3) with w (4) inside, and p (0), q (5) beyond two of its sides: the segment pq
/// passes between w and the side r - s, and takes out all faces; v - w then dangles into the upper half.
///
///           2
///         / | \        p = (-20, 0), r = (-5, -10), v = (0, 10), s = (5, -10), w = (0, 1), q = (20, 0)
///       0 - 4 - 5
///        \ / \ /
///         1---3
TEST(TriangulationReplaceDangling, BothSidesOfAnEdgeInsideTheRegion) {
  Triangulation t = *Triangulation::from_triangles(
      std::vector{tri(0, 1, 2), tri(1, 4, 2), tri(1, 3, 4), tri(4, 3, 2), tri(3, 5, 2)}, 6);
  const Triangulation before = t;
  const std::vector<FaceId> olds = faces({0, 1, 2, 3, 4});
  t.replace(olds, std::vector{tri(0, 5, 4), tri(0, 4, 2), tri(4, 5, 2), tri(5, 0, 1), tri(5, 1, 3)});
  EXPECT_EQ(t.find_fault(), std::nullopt);
  EXPECT_TRUE(t.joined(vertex(0), vertex(5)));
  EXPECT_TRUE(t.joined(vertex(2), vertex(4)));
  std::vector<Triangle> back;
  for (const FaceId f : olds) back.push_back(before.corners(f));
  t.replace(olds, back);
  expect_same_faces(t, before);
  EXPECT_EQ(t.find_fault(), std::nullopt);
}

TEST_F(TriangulationReplace, RenamedCallsEveryVertexByItsNewName) {
  const Triangulation before = mesh_;
  const std::vector<std::uint32_t> names = {7, 0, 3, 9, 4, 1};
  const Triangulation after = std::move(mesh_).renamed(names, 11);
  EXPECT_EQ(after.vertex_count(), 11u);
  EXPECT_EQ(after.find_fault(), std::nullopt);
  EXPECT_TRUE(std::ranges::equal(after.twins(), before.twins()));
  std::set<std::uint32_t> used;
  for (std::uint32_t v = 0; v < 6; ++v) {
    EXPECT_EQ(after.outgoing(vertex(names[v])), before.outgoing(vertex(v)));
    used.insert(names[v]);
  }
  for (std::uint32_t i = 0; i < before.halfedge_count(); ++i) {
    EXPECT_EQ(after.origins()[i], names[before.origins()[i]]);
  }
  for (std::uint32_t v = 0; v < 11; ++v) EXPECT_EQ(after.isolated(vertex(v)), used.count(v) == 0);
}

TEST_F(TriangulationReplace, RenamedByTheSameNamesIsTheSame) {
  const Triangulation before = mesh_;
  EXPECT_EQ(std::move(mesh_).renamed(std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}, 6), before);
}

}  // namespace
