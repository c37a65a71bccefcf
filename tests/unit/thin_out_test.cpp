/// Thinned meshes cover what the whole ones did.
#include "terrain/thin_out.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <span>
#include <vector>

#include "oracle/plane.hpp"
#include "support/cloud.hpp"
#include "support/random.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"
#include "thalweg/validate.hpp"

namespace {

using namespace thalweg;
using detail::ThinTriangle;

std::vector<ThinTriangle> all_triangles(const Triangulation& mesh) {
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
  const std::vector<ThinTriangle> whole = all_triangles(mesh);
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
  const auto whole = all_triangles(delaunay(places).value());
  const std::size_t left = detail::thin_out(places, whole, keep, 500).size();
  EXPECT_LE(left, 500u);
  EXPECT_GE(left, 499u);  // a vertex takes two triangles with it
  EXPECT_EQ(detail::thin_out(places, whole, keep, whole.size()), whole);
}

/// A vertex at the origin and others around it, in order, each seen from the origin.
std::vector<Point2> random_star(std::size_t neighbors, support::Random& random) {
  std::vector<Point2> star;
  const auto before = [](Point2 a, Point2 b) {
    const bool a_below = a.y < 0 || (a.y == 0 && a.x < 0), b_below = b.y < 0 || (b.y == 0 && b.x < 0);
    return a_below != b_below ? b_below : orient2d({0, 0}, a, b) > 0;
  };
  for (bool closed = false; !closed;) {
    star.clear();
    const double far = random.below(2) == 0 ? 12 : 300;
    for (std::size_t i = 0; i < neighbors; ++i)
      star.push_back({random.whole(-300, 300), random.whole(-12, 12) * far / 12});
    std::sort(star.begin(), star.end(), before);
    closed = true;
    for (std::size_t i = 0; i < neighbors; ++i)
      closed = closed && orient2d({0, 0}, star[i], star[(i + 1) % neighbors]) > 0;
  }
  star.insert(star.begin(), Point2{0, 0});
  return star;
}

/// The star of a vertex of at most twelve neighbours is always filled, by triangles over these; if they are
/// in convex position, by their Delaunay triangles.
TEST(ThinOut, FillsAnyStar) {
  support::Random random(1);
  int convex = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::size_t n = 3 + static_cast<std::size_t>(i % 11);
    const std::vector<Point2> star = random_star(n, random);
    std::vector<ThinTriangle> whole;
    for (std::uint32_t v = 1; v <= n; ++v) whole.push_back({0, v, v == n ? 1 : v + 1});
    for (ThinTriangle& t : whole) std::rotate(t.begin(), t.begin() + random.below(3), t.end());
    std::rotate(whole.begin(), whole.begin() + random.below(static_cast<std::uint32_t>(n)), whole.end());
    const auto thin = detail::thin_out(star, whole, std::vector<std::uint8_t>(n + 1, 0), 1);
    if (n == 13) {
      ASSERT_EQ(thin, whole);
      continue;
    }
    const std::span<const Point2> ring = std::span(star).subspan(1);
    const auto flat = [&](std::size_t v, std::size_t w) {
      return std::any_of(ring.begin(), ring.end(), [&](Point2 p) {
        return p != ring[v] && p != ring[w] && orient2d(ring[v], ring[w], p) == 0;
      });
    };
    bool general = true, is_convex = true;
    for (std::size_t v = 0; v < n; ++v) {
      for (std::size_t w = 0; w < v; ++w) general = general && !flat(v, w);
      is_convex = is_convex && orient2d(ring[v], ring[(v + 1) % n], ring[(v + 2) % n]) > 0;
    }
    if (thin == whole) {
      ASSERT_FALSE(general);
      continue;
    }
    ASSERT_EQ(thin.size(), n - 2);
    const auto s = oracle::sites_of(std::span<const Point2>(star));
    std::int64_t area = 0;
    for (const ThinTriangle& t : whole) area += oracle::area(s[t[0]], s[t[1]], s[t[2]]);
    for (std::size_t a = 0; a < thin.size(); ++a) {
      area -= oracle::area(s[thin[a][0]], s[thin[a][1]], s[thin[a][2]]);
      ASSERT_GT(oracle::turn(s[thin[a][0]], s[thin[a][1]], s[thin[a][2]]), 0);
      for (std::size_t b = 0; b < a; ++b) ASSERT_FALSE(oracle::share_area(s, thin[a], thin[b]));
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_TRUE(oracle::is_open_pair(std::span(s).subspan(1), thin[a][c] - 1, thin[a][(c + 1) % 3] - 1));
      }
      for (std::size_t v = 1; is_convex && v <= n; ++v)
        ASSERT_LE(oracle::in_circle(s[thin[a][0]], s[thin[a][1]], s[thin[a][2]], s[v]), 0);
    }
    ASSERT_EQ(area, 0);
    convex += is_convex && n > 4 ? 1 : 0;
  }
  EXPECT_GT(convex, 20);
}

}  // namespace
