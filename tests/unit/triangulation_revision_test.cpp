/// Revisions: triangulations that share with another what edits have not changed.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "support/prepared.hpp"
#include "support/random_mesh.hpp"
#include "thalweg/triangulation.hpp"

namespace {

using thalweg::FaceId;
using thalweg::HalfedgeId;
using thalweg::Triangle;
using thalweg::Triangulation;

std::vector<oracle::Site> sites_of(const support::Cloud& cloud) {
  return oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
}

/// The two faces at h, and the same with the other diagonal: what `flip` does, said to `replace`.
void replace_diagonal(Triangulation& t, HalfedgeId h) {
  const HalfedgeId twin = t.twin(h);
  const auto a = t.origin(h), b = t.dest(h), c = t.apex(h), d = t.apex(twin);
  const std::vector<FaceId> olds = {Triangulation::face(h), Triangulation::face(twin)};
  t.replace(olds, std::vector<Triangle>{{d, c, a}, {c, d, b}});
}

bool same_outgoing(const Triangulation& a, const Triangulation& b) {
  for (std::uint32_t v = 0; v < a.vertex_count(); ++v) {
    if (a.outgoing(support::vertex(v)) != b.outgoing(support::vertex(v))) return false;
  }
  return true;
}

TEST(TriangulationRevision, OfNothingIsNothing) {
  const Triangulation none;
  const Triangulation revision = Triangulation::revision_of(none);
  EXPECT_EQ(revision.face_count(), 0u);
  EXPECT_TRUE(revision.revised_faces().empty());
  EXPECT_EQ(revision, none);
}

TEST(TriangulationRevision, UnchangedIsEqualAndHasNoRevisedFaces) {
  const auto sites = sites_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 2, 0}, {3, 2, 0}}});
  const Triangulation base = support::triangulation_of(sites);
  const Triangulation revision = Triangulation::revision_of(base);
  EXPECT_TRUE(revision.is_revision());
  EXPECT_FALSE(base.is_revision());
  EXPECT_EQ(revision, base);
  EXPECT_EQ(revision.find_fault(), std::nullopt);
  EXPECT_TRUE(revision.revised_faces().empty());
}

RC_GTEST_PROP(TriangulationRevisionLaws, EditsAreThoseOfACopyAndTheBaseStays, ()) {
  const auto cloud = *support::clouds(40);
  const auto sites = sites_of(cloud);
  Triangulation base = support::triangulation_of(sites);
  const Triangulation untouched = base;
  Triangulation copy = base, revision = Triangulation::revision_of(base);
  for (int i = 0; i < 20; ++i) {
    const HalfedgeId h(support::random_index(base.halfedge_count()));
    if (!support::flippable(sites, copy, h)) continue;
    if (i % 3 == 0) {
      replace_diagonal(copy, h);
      replace_diagonal(revision, h);
    } else {
      RC_ASSERT(copy.flip(h) == revision.flip(h));
    }
    RC_ASSERT(revision == copy);
    RC_ASSERT(copy == revision);
    RC_ASSERT(same_outgoing(copy, revision));
  }
  RC_ASSERT(revision.find_fault() == std::nullopt);
  RC_ASSERT(base == untouched);
  RC_ASSERT(std::ranges::equal(base.twins(), untouched.twins()));

  const std::vector<FaceId> revised = revision.revised_faces();
  RC_ASSERT(std::is_sorted(revised.begin(), revised.end()));
  RC_ASSERT(std::adjacent_find(revised.begin(), revised.end()) == revised.end());
  for (std::uint32_t f = 0; f < base.face_count(); ++f) {
    const bool differs = revision.corners(FaceId(f)) != base.corners(FaceId(f));
    RC_ASSERT(!differs || std::binary_search(revised.begin(), revised.end(), FaceId(f)));
  }

  // A copy of a revision is a revision of its own.
  Triangulation other = revision;
  support::flip_somewhere(sites, other);
  RC_ASSERT(revision == copy);

  base.take(std::move(revision));
  RC_ASSERT(!base.is_revision());
  RC_ASSERT(base == copy);
  RC_ASSERT(same_outgoing(base, copy));
  RC_ASSERT(std::ranges::equal(base.origins(), copy.origins()));
}

}  // namespace
