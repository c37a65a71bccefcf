/// Thinned meshes cover what the whole ones did.
#include "terrain/thin_out.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "support/cloud.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"
#include "thalweg/validate.hpp"

namespace {

using namespace thalweg;
using detail::ThinTriangle;

std::vector<ThinTriangle> triangles_of(const Triangulation& mesh) {
  std::vector<ThinTriangle> triangles;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const Triangle t = mesh.corners(FaceId(f));
    triangles.push_back({t[0].index(), t[1].index(), t[2].index()});
  }
  return triangles;
}

RC_GTEST_PROP(ThinOut, CoversTheSameRegionWithFewerVertices, ()) {
  const support::Cloud cloud = *support::clouds(60);
  const std::vector<Point2> places = cloud.places();
  const Triangulation mesh = delaunay(places).value();
  const std::vector<ThinTriangle> whole = triangles_of(mesh);
  std::vector<std::uint8_t> keep;
  for (std::uint32_t v = 0; v < cloud.size(); ++v)
    keep.push_back(*rc::gen::element<std::uint8_t>(0, 0, 0, 1));
  const auto most = *rc::gen::inRange<std::size_t>(0, whole.size() + 2);
  const std::vector<ThinTriangle> thin = detail::thin_out(places, whole, keep, most);
  RC_ASSERT(thin.size() <= whole.size());

  // What is left is a triangulation of the vertices that are left, which covers their hull, and the hull is
  // whole.
  std::vector<std::uint32_t> number(cloud.size(), 0);
  std::set<std::uint32_t> left;
  for (const ThinTriangle& t : thin) left.insert(t.begin(), t.end());
  std::vector<Point2> remaining;
  for (const std::uint32_t v : left) {
    number[v] = static_cast<std::uint32_t>(remaining.size());
    remaining.push_back(places[v]);
  }
  std::vector<std::array<std::uint32_t, 3>> renamed;
  for (const ThinTriangle& t : thin) renamed.push_back({number[t[0]], number[t[1]], number[t[2]]});
  RC_ASSERT(find_faults(remaining, renamed).empty());
  for (std::uint32_t v = 0; v < cloud.size(); ++v) {
    if (keep[v] != 0 || mesh.on_hull(VertexId(v))) RC_ASSERT(left.count(v) == 1);
  }

  // Triangles of kept vertices alone are untouched.
  const std::set<ThinTriangle> now(thin.begin(), thin.end());
  for (const ThinTriangle& t : whole) {
    if (keep[t[0]] + keep[t[1]] + keep[t[2]] == 3) RC_ASSERT(now.count(t) == 1);
  }
}

TEST(ThinOut, ReachesWhatIsAskedFor) {
  std::vector<Point2> places;
  for (int x = 0; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) places.push_back({x + 0.1 * (y % 3), y + 0.1 * (x % 3)});
  }
  const std::vector<std::uint8_t> keep(places.size(), 0);
  const auto whole = triangles_of(delaunay(places).value());
  EXPECT_LE(detail::thin_out(places, whole, keep, 500).size(), 500u);
  EXPECT_EQ(detail::thin_out(places, whole, keep, whole.size()), whole);
}

}  // namespace
