/// Triangulation: what from_triangles refuses, and how its half-edges hang together.
#include "thalweg/triangulation.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/ids.hpp"
#include "thalweg/id.hpp"

namespace {

using support::tri;
using thalweg::FaceId;
using thalweg::HalfedgeId;
using thalweg::Triangle;
using thalweg::Triangulation;
using thalweg::VertexId;

std::optional<Triangulation> make(const std::vector<Triangle>& triangles, std::uint32_t vertices) {
  return Triangulation::from_triangles(triangles, vertices);
}

/// Vertex 0 in the middle of the square 1, 2, 3, 4 (counter-clockwise), and vertex 5 beyond the side 1 - 2:
///
///      4-----3
///      | \ / |
///      |  0  |
///      | / \ |
///      1-----2
///       \   /
///         5
Triangulation house() {
  return *make({tri(0, 1, 2), tri(2, 3, 0), tri(4, 0, 3), tri(4, 1, 0), tri(5, 2, 1)}, 6);
}

std::vector<std::uint32_t> neighbors(const Triangulation& t, std::uint32_t v) {
  std::vector<std::uint32_t> result;
  t.for_each_neighbor(VertexId(v), [&](VertexId w) { result.push_back(w.index()); });
  return result;
}

using Ids = std::vector<std::uint32_t>;

TEST(TriangulationFromTriangles, KeepsFacesAndTheirRotation) {
  const Triangulation t = house();
  EXPECT_EQ(t.vertex_count(), 6u);
  EXPECT_EQ(t.face_count(), 5u);
  EXPECT_EQ(t.halfedge_count(), 15u);
  EXPECT_EQ(t.corners(FaceId(0)), tri(0, 1, 2));
  EXPECT_EQ(t.corners(FaceId(2)), tri(4, 0, 3));
  EXPECT_EQ(t.corners(FaceId(4)), tri(5, 2, 1));
  EXPECT_EQ(t.find_fault(), std::nullopt);
}

TEST(TriangulationFromTriangles, AllowsNoTrianglesAndIsolatedVertices) {
  const auto none = make({}, 3);
  ASSERT_TRUE(none);
  EXPECT_EQ(none->face_count(), 0u);
  EXPECT_TRUE(none->isolated(VertexId(2)));
  EXPECT_FALSE(none->on_hull(VertexId(2)));
  EXPECT_EQ(neighbors(*none, 2), Ids{});

  const auto gap = make({tri(0, 3, 1)}, 4);
  ASSERT_TRUE(gap);
  EXPECT_TRUE(gap->isolated(VertexId(2)));
  EXPECT_FALSE(gap->isolated(VertexId(3)));
  EXPECT_FALSE(gap->joined(VertexId(2), VertexId(0)));
  EXPECT_FALSE(gap->joined(VertexId(0), VertexId(2)));
  EXPECT_EQ(make({}, 0)->vertex_count(), 0u);
}

TEST(TriangulationFromTriangles, RefusesAnIndexOutOfRange) {
  EXPECT_FALSE(make({tri(0, 1, 3)}, 3));
  EXPECT_FALSE(make({tri(0, 1, 2), tri(2, 1, 4)}, 4));
  EXPECT_FALSE(make({{VertexId(0), VertexId(), VertexId(1)}}, 3));
  EXPECT_TRUE(make({tri(0, 1, 2)}, 3));
}

TEST(TriangulationFromTriangles, RefusesARepeatedVertex) {
  EXPECT_FALSE(make({tri(0, 0, 1)}, 3));
  EXPECT_FALSE(make({tri(0, 1, 1)}, 3));
  EXPECT_FALSE(make({tri(1, 0, 1)}, 3));
}

TEST(TriangulationFromTriangles, RefusesADirectedEdgeTwice) {
  EXPECT_FALSE(make({tri(0, 1, 2), tri(0, 1, 3)}, 4));
  EXPECT_FALSE(make({tri(0, 1, 2), tri(1, 2, 0)}, 3));                // the same triangle
  EXPECT_FALSE(make({tri(0, 1, 2), tri(1, 0, 3), tri(1, 0, 4)}, 5));  // three on an edge
  EXPECT_FALSE(make({tri(0, 1, 2), tri(0, 2, 3), tri(1, 2, 4)}, 5));  // one of them turned over
}

TEST(TriangulationFromTriangles, RefusesTwoFansAtAVertex) {
  EXPECT_FALSE(make({tri(0, 1, 2), tri(0, 3, 4)}, 5));  // a bow tie
  // A closed fan around 0 and another triangle hanging on it.
  EXPECT_FALSE(make({tri(0, 1, 2), tri(0, 2, 3), tri(0, 3, 1), tri(0, 4, 5)}, 6));
  // Two closed fans around 0.
  EXPECT_FALSE(make({tri(0, 1, 2), tri(0, 2, 3), tri(0, 3, 1), tri(0, 4, 5), tri(0, 5, 6), tri(0, 6, 4)}, 7));
}

TEST(TriangulationNavigation, NextPrevFaceAreArithmetic) {
  for (std::uint32_t i = 0; i < 9; ++i) {
    const HalfedgeId h(i);
    EXPECT_EQ(Triangulation::prev(Triangulation::next(h)), h);
    EXPECT_EQ(Triangulation::next(Triangulation::next(h)), Triangulation::prev(h));
    EXPECT_EQ(Triangulation::face(Triangulation::next(h)), FaceId(i / 3));
    EXPECT_EQ(Triangulation::halfedge(FaceId(i / 3), i % 3), h);
  }
}

TEST(TriangulationNavigation, TwinsRunTheOtherWay) {
  const Triangulation t = house();
  std::uint32_t hull = 0;
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    EXPECT_EQ(t.origin(h).index(), t.origins()[i]);
    EXPECT_EQ(t.twin(h).index(), t.twins()[i]);
    EXPECT_EQ(t.dest(h), t.origin(Triangulation::next(h)));
    EXPECT_EQ(t.apex(h), t.dest(Triangulation::next(h)));
    if (t.on_hull(h)) {
      ++hull;
      continue;
    }
    EXPECT_EQ(t.twin(t.twin(h)), h);
    EXPECT_EQ(t.origin(t.twin(h)), t.dest(h));
    EXPECT_EQ(t.dest(t.twin(h)), t.origin(h));
  }
  EXPECT_EQ(hull, 5u);
}

TEST(TriangulationNavigation, OutgoingOfAHullVertexRunsAlongTheHull) {
  const Triangulation t = house();
  EXPECT_FALSE(t.on_hull(VertexId(0)));
  EXPECT_EQ(t.origin(t.outgoing(VertexId(0))), VertexId(0));
  for (std::uint32_t v = 1; v < 6; ++v) {
    EXPECT_TRUE(t.on_hull(VertexId(v)));
    EXPECT_TRUE(t.on_hull(t.outgoing(VertexId(v))));
    EXPECT_EQ(t.origin(t.outgoing(VertexId(v))), VertexId(v));
  }
}

TEST(TriangulationNavigation, NeighborsOfAHullVertexAreCompleteAndCounterClockwise) {
  const Triangulation t = house();
  EXPECT_EQ(neighbors(t, 1), (Ids{5, 2, 0, 4}));
  EXPECT_EQ(neighbors(t, 2), (Ids{3, 0, 1, 5}));
  EXPECT_EQ(neighbors(t, 3), (Ids{4, 0, 2}));
  EXPECT_EQ(neighbors(t, 4), (Ids{1, 0, 3}));
  EXPECT_EQ(neighbors(t, 5), (Ids{2, 1}));
}

TEST(TriangulationNavigation, NeighborsOfAnInnerVertexAreEachVisitedOnce) {
  const Triangulation t = house();
  Ids around = neighbors(t, 0);
  ASSERT_EQ(around.size(), 4u);
  while (around[0] != 1) around = {around[1], around[2], around[3], around[0]};
  EXPECT_EQ(around, (Ids{1, 2, 3, 4}));
}

TEST(TriangulationNavigation, TurnsCounterClockwiseUntilTheHull) {
  const Triangulation t = house();
  HalfedgeId h = t.outgoing(VertexId(1));
  Ids met;
  for (; h.valid(); h = t.turn_ccw(h)) met.push_back(t.dest(h).index());
  EXPECT_EQ(met, (Ids{5, 2, 0}));
  h = t.outgoing(VertexId(0));
  for (int i = 0; i < 4; ++i) h = t.turn_ccw(h);
  EXPECT_EQ(h, t.outgoing(VertexId(0)));
}

TEST(TriangulationFindHalfedge, FindsEveryDirectedEdgeAndNoOther) {
  const Triangulation t = house();
  for (std::uint32_t u = 0; u < 6; ++u) {
    for (std::uint32_t v = 0; v < 6; ++v) {
      HalfedgeId expected;
      for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
        if (t.origin(HalfedgeId(i)) == VertexId(u) && t.dest(HalfedgeId(i)) == VertexId(v)) {
          expected = HalfedgeId(i);
        }
      }
      EXPECT_EQ(t.find_halfedge(VertexId(u), VertexId(v)), expected) << u << " -> " << v;
    }
  }
}

TEST(TriangulationFindHalfedge, OfAHullEdgeGoesOneWayOnly) {
  const Triangulation t = house();
  EXPECT_TRUE(t.find_halfedge(VertexId(1), VertexId(5)).valid());
  EXPECT_FALSE(t.find_halfedge(VertexId(5), VertexId(1)).valid());
  EXPECT_TRUE(t.joined(VertexId(5), VertexId(1)));
  EXPECT_TRUE(t.joined(VertexId(1), VertexId(5)));
  EXPECT_TRUE(t.joined(VertexId(0), VertexId(3)));
  EXPECT_FALSE(t.joined(VertexId(0), VertexId(5)));
  EXPECT_FALSE(t.joined(VertexId(1), VertexId(3)));
}

TEST(TriangulationFromArrays, EqualsTheOneMadeFromTriangles) {
  const Triangulation t = house();
  const Triangulation again = Triangulation::from_arrays({t.origins().begin(), t.origins().end()},
                                                         {t.twins().begin(), t.twins().end()}, 6);
  EXPECT_EQ(again, t);
  EXPECT_EQ(again.find_fault(), std::nullopt);
}

void expect_different(const Triangulation& a, const Triangulation& b) {
  EXPECT_NE(a, b);
  EXPECT_NE(Triangulation::revision_of(a), b);
  EXPECT_NE(a, Triangulation::revision_of(b));
}

TEST(TriangulationEquality, SeesOriginTwinAndBothCounts) {
  const Triangulation t = house();
  const std::vector<std::uint32_t> no_twins(t.halfedge_count(), HalfedgeId::kInvalid);
  const Triangulation others[] = {
      *make({tri(1, 2, 0), tri(2, 3, 0), tri(4, 0, 3), tri(4, 1, 0), tri(5, 2, 1)}, 6),
      *make({tri(0, 1, 2), tri(2, 3, 0), tri(4, 0, 3), tri(4, 1, 0), tri(5, 2, 1)}, 7),
      *make({tri(0, 1, 2), tri(2, 3, 0), tri(4, 0, 3), tri(4, 1, 0)}, 6),
      Triangulation::from_arrays(t.origins(), no_twins, 6),
  };
  for (const Triangulation& other : others) {
    expect_different(t, other);
    expect_different(other, t);
  }
  expect_different(*make({tri(0, 1, 2)}, 3), *make({tri(1, 2, 0)}, 3));
  EXPECT_EQ(Triangulation(), Triangulation());
}

/// Which one it is depends on the edits made, and arrays do not say it.
TEST(TriangulationEquality, DoesNotSeeWhichHalfedgeLeavesAVertex) {
  using Numbers = thalweg::detail::Array<std::uint32_t>;
  const Triangulation t = house();
  Numbers outgoing;
  for (std::uint32_t v = 0; v < 6; ++v) outgoing.push_back(t.outgoing(VertexId(v)).index());
  outgoing[0] = t.find_halfedge(VertexId(0), VertexId(2)).index();
  const Triangulation other = thalweg::detail::linked(Numbers(t.origins().begin(), t.origins().end()),
                                                      Numbers(t.twins().begin(), t.twins().end()), outgoing);
  EXPECT_EQ(other.find_fault(), std::nullopt);
  ASSERT_NE(other.outgoing(VertexId(0)), t.outgoing(VertexId(0)));
  EXPECT_EQ(other, t);
}

/// Arrays that are broken in one way each; the message names the place.
class FindFault : public ::testing::Test {
 protected:
  static constexpr std::uint32_t kNone = HalfedgeId::kInvalid;

  std::string fault(std::uint32_t vertices) const {
    return Triangulation::from_arrays(origin_, twin_, vertices).find_fault().value_or("none");
  }

  // Two triangles on the edge 1 - 2, which is half-edge 1 and half-edge 3.
  std::vector<std::uint32_t> origin_ = {0, 1, 2, 2, 1, 3};
  std::vector<std::uint32_t> twin_ = {kNone, 3, kNone, 1, kNone, kNone};
};

TEST_F(FindFault, NoneInASoundMesh) {
  EXPECT_EQ(fault(4), "none");
  EXPECT_EQ(fault(9), "none");
}

TEST_F(FindFault, ArraysOfDifferentLength) {
  twin_.push_back(kNone);
  EXPECT_EQ(fault(4), "arrays of half-edges differ in length");
}

TEST_F(FindFault, NoTwinsAtAll) {
  twin_.clear();
  EXPECT_EQ(fault(4), "arrays of half-edges differ in length");
}

TEST_F(FindFault, HalfATriangle) {
  origin_.push_back(0);
  twin_.push_back(kNone);
  EXPECT_EQ(fault(4), "arrays of half-edges differ in length");
}

TEST_F(FindFault, AnOriginOutOfRange) {
  EXPECT_EQ(fault(3), "half-edge 5 has an origin out of range");
}

TEST_F(FindFault, ARepeatedVertex) {
  origin_[5] = 1;
  EXPECT_EQ(fault(4), "face 1 repeats a vertex");
}

TEST_F(FindFault, ADirectedEdgeTwice) {
  std::swap(origin_[3], origin_[4]);  // 1 -> 2 in both
  EXPECT_EQ(fault(4), "edge 1 -> 2 occurs twice");
}

TEST_F(FindFault, ATwinThatIsMissing) {
  twin_[3] = kNone;
  EXPECT_EQ(fault(4), "edge 2 -> 1 has the wrong twin");
}

TEST_F(FindFault, ATwinWhereThereIsNone) {
  twin_[0] = 4;
  twin_[4] = 0;
  EXPECT_EQ(fault(4), "edge 0 -> 1 has the wrong twin");
}

TEST_F(FindFault, ATwinThatIsAnotherHalfedge) {
  twin_[1] = 4;
  EXPECT_EQ(fault(4), "edge 1 -> 2 has the wrong twin");
}

TEST_F(FindFault, ATwinOutOfRange) {
  twin_[1] = 77;
  EXPECT_EQ(fault(4), "edge 1 -> 2 has the wrong twin");
}

TEST_F(FindFault, TwoFansAtAVertex) {
  origin_ = {0, 1, 2, 2, 3, 4};
  twin_.assign(6, kNone);
  EXPECT_EQ(fault(5), "the faces at vertex 2 are not one fan");
}

TEST_F(FindFault, AClosedFanAndAnotherTriangleAtAVertex) {
  origin_ = {0, 1, 2, 0, 2, 3, 0, 3, 1, 0, 4, 5};
  twin_ = {8, kNone, 3, 2, kNone, 6, 5, kNone, 0, kNone, kNone, kNone};
  EXPECT_EQ(fault(6), "the faces at vertex 0 are not one fan");
}

TEST_F(FindFault, AVertexWithoutItsOutgoingHalfedge) {
  // The only way from outside to a wrong `outgoing`: names that are not distinct, which `renamed` forbids.
  Triangulation t = *make({tri(0, 1, 2)}, 4);
  EXPECT_EQ(std::move(t).renamed(Ids{0, 1, 2, 0}, 4).find_fault(), "vertex 0 has a wrong outgoing half-edge");
}

TEST_F(FindFault, AnOutgoingHalfedgeThatLeavesFacesOut) {
  // From the hull, the faces at vertex 1 are met by turning counter-clockwise; half-edge 1 is the last of
  // them.
  using thalweg::detail::Array;
  const Triangulation t = thalweg::detail::linked(Array<std::uint32_t>(origin_.begin(), origin_.end()),
                                                  Array<std::uint32_t>(twin_.begin(), twin_.end()),
                                                  Array<std::uint32_t>{0, 1, 2, 5});
  EXPECT_EQ(t.find_fault(), "vertex 1 is on the hull, but its outgoing half-edge is not");
}

TEST_F(FindFault, NamesTheFirstOfSeveral) {
  origin_[5] = 1;  // a repeated vertex comes before a wrong twin
  twin_[1] = kNone;
  EXPECT_EQ(fault(4), "face 1 repeats a vertex");
}

}  // namespace
