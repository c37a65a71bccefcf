/// find_faults: each kind of fault made on purpose, sound meshes, and random damage against a brute-force
/// check.
#include "thalweg/validate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kernel/mesh_faults.hpp"
#include "oracle/exact_predicates.hpp"
#include "oracle/terrain.hpp"
#include "support/cloud.hpp"

namespace {

using thalweg::Fault;
using thalweg::FaultKind;
using thalweg::Point2;
using Corners = std::array<std::uint32_t, 3>;

struct Mesh {
  std::vector<Point2> points;
  std::vector<Corners> triangles;
};

/// (width + 1) x (height + 1) vertices, two triangles to a cell.
Mesh grid(std::uint32_t width, std::uint32_t height) {
  Mesh mesh;
  for (std::uint32_t y = 0; y <= height; ++y) {
    for (std::uint32_t x = 0; x <= width; ++x) mesh.points.push_back({double(x), double(y)});
  }
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint32_t a = y * (width + 1) + x, b = a + 1, c = a + width + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

std::vector<Fault> faults(const Mesh& mesh) {
  return find_faults(mesh.points, mesh.triangles);
}

std::vector<FaultKind> kinds(const std::vector<Fault>& found) {
  std::vector<FaultKind> result;
  for (const Fault& fault : found) result.push_back(fault.kind);
  return result;
}

using Kinds = std::vector<FaultKind>;

TEST(FindFaults, NoneInSoundMeshes) {
  EXPECT_TRUE(faults(grid(1, 1)).empty());
  EXPECT_TRUE(faults(grid(5, 4)).empty());
  EXPECT_TRUE(faults({{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}}).empty());
  EXPECT_TRUE(faults({}).empty());

  Mesh fan{{{0, 0}}, {}};
  const auto circle = support::integer_circle(65);
  fan.points.insert(fan.points.end(), circle.begin(), circle.end());
  const auto n = static_cast<std::uint32_t>(circle.size());
  for (std::uint32_t i = 0; i < n; ++i) fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
  EXPECT_TRUE(faults(fan).empty());
}

TEST(FindFaults, NoneAtExtremeExponents) {
  for (const double unit : {std::numeric_limits<double>::denorm_min(), 1e-300, 1e300}) {
    Mesh mesh = grid(4, 4);
    for (Point2& p : mesh.points) p = {p.x * unit, p.y * unit};
    EXPECT_TRUE(faults(mesh).empty()) << unit;
  }
}

TEST(FindFaults, IndexOutOfRange) {
  Mesh mesh = grid(2, 2);
  mesh.triangles.push_back({0, 1, 99});
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), Kinds{FaultKind::index_out_of_range});
  EXPECT_EQ(found[0].count, 1u);
  EXPECT_EQ(found[0].examples, std::vector<std::string>{"triangle 8 (0, 1, 99)"});
}

TEST(FindFaults, DegenerateTriangles) {
  Mesh mesh = grid(2, 2);
  mesh.triangles.push_back({3, 4, 5});
  mesh.triangles.push_back({1, 1, 2});
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), Kinds{FaultKind::degenerate});
  EXPECT_EQ(found[0].count, 2u);
  EXPECT_EQ(found[0].examples[1], "triangle 9 (1, 1, 2)");
}

TEST(FindFaults, ClockwiseTriangleIsTheOnlyFault) {
  Mesh mesh = grid(3, 3);
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  EXPECT_EQ(kinds(faults(mesh)), Kinds{FaultKind::clockwise});
  for (Corners& t : mesh.triangles) std::swap(t[1], t[2]);
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), Kinds{FaultKind::clockwise});
  EXPECT_EQ(found[0].count, 17u);
  EXPECT_EQ(found[0].examples.size(), 5u);
}

TEST(FindFaults, DuplicateVertexOnASeam) {
  Mesh mesh = grid(2, 1);
  mesh.points.push_back(mesh.points[1]);
  mesh.points.push_back(mesh.points[4]);
  for (std::size_t i = 2; i < 4; ++i) {
    for (std::uint32_t& v : mesh.triangles[i]) v = v == 1 ? 6u : v == 4 ? 7u : v;
  }
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), Kinds{FaultKind::duplicate_vertex});
  EXPECT_EQ(found[0].count, 2u);
  EXPECT_EQ(found[0].examples[0], "vertices 1 and 6");
}

TEST(FindFaults, NegativeZeroIsZero) {
  Mesh mesh = grid(2, 2);
  mesh.points.push_back({-0.0, 0.0});
  EXPECT_EQ(kinds(faults(mesh)), (Kinds{FaultKind::duplicate_vertex, FaultKind::unused_vertex}));
}

TEST(FindFaults, UnusedVertices) {
  for (const Point2 extra : {Point2{0.5, 0.25}, Point2{0.5, 0.5}, Point2{0.5, 0}}) {
    Mesh mesh = grid(2, 2);
    mesh.points.push_back(extra);  // inside a triangle, inside an edge, on the hull
    const auto found = faults(mesh);
    ASSERT_EQ(kinds(found), Kinds{FaultKind::unused_vertex});
    EXPECT_EQ(found[0].examples, std::vector<std::string>{"vertex 9"});
  }
  Mesh outside = grid(2, 2);
  outside.points.push_back({5, 5});
  EXPECT_EQ(kinds(faults(outside)), (Kinds{FaultKind::unused_vertex, FaultKind::hole}));
}

TEST(FindFaults, DuplicateTriangle) {
  Mesh mesh = grid(2, 2);
  const Corners t = mesh.triangles[3];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), Kinds{FaultKind::duplicate_triangle});
  EXPECT_NE(found[0].examples[0].find("the same as triangle 3"), std::string::npos);
}

TEST(FindFaults, ThreeTrianglesOnAnEdge) {
  const Mesh mesh{{{0, 0}, {4, 0}, {2, -3}, {2, 2}, {2, 4}}, {{0, 1, 3}, {0, 1, 4}, {1, 0, 2}}};
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found).front(), FaultKind::non_manifold);
  EXPECT_EQ(found[0].examples[0], "edge 0 - 1 of 3 triangles");
  EXPECT_NE(
      std::find_if(found.begin(), found.end(), [](const Fault& f) { return f.kind == FaultKind::overlap; }),
      found.end());
}

TEST(FindFaults, BowTie) {
  const Mesh mesh{{{0, 0}, {2, 1}, {2, -1}, {-2, 1}, {-2, -1}}, {{0, 2, 1}, {0, 3, 4}}};
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), (Kinds{FaultKind::non_manifold, FaultKind::hole}));
  EXPECT_EQ(found[0].examples[0], "vertex 0 with 2 separate fans");
}

TEST(FindFaults, CrossingEdgesOverlap) {
  const Mesh mesh{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1, 2}, {1, 2, 3}}};
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), (Kinds{FaultKind::crossing, FaultKind::overlap, FaultKind::hole}));
  EXPECT_EQ(found[0].examples[0], "edges 0 - 2 and 1 - 3");
  EXPECT_EQ(found[1].examples[0], "triangle 0 (0, 1, 2) and triangle 1 (1, 2, 3)");
}

/// Every place is covered twice, and the edges with one side are those of the hull.
TEST(FindFaults, TwoTriangulationsOfOneSquare) {
  const Mesh mesh{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}}};
  EXPECT_EQ(kinds(faults(mesh)), (Kinds{FaultKind::crossing, FaultKind::overlap}));
}

/// A mesh as search_faults gets it, of triangles that are counter-clockwise.
std::vector<Fault> faults_within(const Mesh& mesh, const std::vector<thalweg::detail::Edge>& border,
                                 const std::vector<std::uint32_t>& hull_next, std::uint64_t most_steps) {
  thalweg::detail::CleanMesh clean;
  clean.points = mesh.points;
  clean.given = mesh.triangles;
  clean.corners = mesh.triangles;
  clean.border = border;
  clean.hull_next = hull_next;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) clean.names.push_back(i);
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Corners& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) pairs.insert(std::minmax(t[i], t[(i + 1) % 3]));
  }
  for (const auto& [u, v] : pairs) clean.edges.push_back({u, v});
  thalweg::detail::FaultLog log;
  search_faults(clean, log, most_steps);
  return std::move(log).take();
}

constexpr std::uint32_t kNoPlace = thalweg::detail::CleanMesh::kNoPlace;

/// A square with a triangle missing on the right, whose corner is vertex 4.
TEST(SearchFaults, NamesABorderEdgeIfTheStepsRunOut) {
  const Mesh mesh{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}}, {{0, 1, 4}, {2, 3, 4}, {3, 0, 4}}};
  const std::vector<thalweg::detail::Edge> border = {{0, 1}, {1, 4}, {4, 2}, {2, 3}, {3, 0}};
  const std::vector<std::uint32_t> hull_next = {1, 2, 3, 0, kNoPlace};
  const auto all = faults_within(mesh, border, hull_next, 10000);
  ASSERT_EQ(kinds(all), Kinds{FaultKind::hole});
  EXPECT_EQ(all[0].examples[0], "right of the edge 1 -> 4, border of 2 edges");
  const auto some = faults_within(mesh, border, hull_next, 0);
  ASSERT_EQ(kinds(some), Kinds{FaultKind::hole});
  EXPECT_EQ(some[0].examples[0], "border edge 1 -> 4 off the hull");
}

/// One triangle is covered twice, and all of its border is that of the hull.
TEST(SearchFaults, MeetsAnOverlapBeforeTheStepsRunOut) {
  const Mesh mesh{{{0, 0}, {9, 0}, {0, 9}, {2, 2}}, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const std::vector<thalweg::detail::Edge> border = {{0, 1}, {1, 2}, {2, 0}};
  const std::vector<std::uint32_t> hull_next = {1, 2, 0, kNoPlace};
  const auto all = faults_within(mesh, border, hull_next, 10000);
  ASSERT_EQ(kinds(all), Kinds{FaultKind::overlap});
  EXPECT_EQ(all[0].count, 3u);
  const auto some = faults_within(mesh, border, hull_next, 0);
  ASSERT_EQ(kinds(some), Kinds{FaultKind::overlap});
}

/// An exact test counts for more than comparing boxes: with so many steps half of the overlaps are met.
TEST(SearchFaults, StopsWhereTheStepsRunOut) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 20; ++i) {
    for (const Point2 p : {Point2{i * 1.0, 0}, Point2{i + 9.0, 1.0 + i}, Point2{i * 1.0, 9}})
      mesh.points.push_back(p);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const std::vector<std::uint32_t> hull_next(mesh.points.size(), kNoPlace);
  const auto overlaps = [&](std::uint64_t most_steps) {
    std::uint64_t count = 0;
    for (const Fault& fault : faults_within(mesh, {}, hull_next, most_steps)) {
      if (fault.kind == FaultKind::overlap) count += fault.count;
    }
    return count;
  };
  const std::uint64_t all = overlaps(1000000);
  EXPECT_GT(all, 100u);
  const std::uint64_t most = 32 * all / 2;
  EXPECT_GT(overlaps(most), all / 4);
  EXPECT_LE(overlaps(most), all / 2 + 20);
}

TEST(FindFaults, VertexInsideAnEdge) {
  // A T-junction: 4 lies on the edge 0 - 2, which the lower triangle keeps whole.
  const Mesh mesh{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 2}}, {{0, 1, 2}, {0, 4, 3}, {4, 2, 3}}};
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), (Kinds{FaultKind::non_manifold, FaultKind::crossing}));
  EXPECT_EQ(found[0].examples[0], "vertex 0 with 2 separate fans");
  EXPECT_EQ(found[1].examples[0], "vertex 4 inside edge 0 - 2");
}

/// The long side of the one parts it from the other, whose corner points at it; no side of the other does.
TEST(FindFaults, TrianglesApartDoNotOverlap) {
  const std::vector<Point2> points = {{0, 0}, {10, 0}, {0, 10}, {6, 6}, {20, 7}, {7, 20}};
  for (const Mesh& mesh : {Mesh{points, {{0, 1, 2}, {3, 4, 5}}}, Mesh{points, {{3, 4, 5}, {0, 1, 2}}}})
    EXPECT_EQ(kinds(faults(mesh)), Kinds{FaultKind::hole});
}

TEST(FindFaults, FirstVertexInsideAnEdge) {
  const Mesh mesh{{{2, 2}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 2, 3}, {1, 0, 4}, {0, 3, 4}}};
  const auto found = faults(mesh);
  ASSERT_EQ(kinds(found), (Kinds{FaultKind::non_manifold, FaultKind::crossing}));
  EXPECT_EQ(found[1].examples[0], "vertex 0 inside edge 1 - 3");
}

TEST(FindFaults, FoldedTriangleOverlaps) {
  // Vertex 4 was dragged across the edge 0 - 1: triangle 0 turned over, the others cover too much.
  Mesh mesh{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, -1}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
  const auto found = kinds(faults(mesh));
  EXPECT_NE(std::find(found.begin(), found.end(), FaultKind::clockwise), found.end());
  EXPECT_NE(std::find(found.begin(), found.end(), FaultKind::overlap), found.end());
}

TEST(FindFaults, HolesInsideAndAtTheHull) {
  Mesh inside = grid(5, 5);
  inside.triangles.erase(inside.triangles.begin() + 24);
  auto found = faults(inside);
  ASSERT_EQ(kinds(found), Kinds{FaultKind::hole});
  EXPECT_EQ(found[0].count, 1u);
  EXPECT_NE(found[0].examples[0].find("border of 3 edges"), std::string::npos);

  Mesh notch = grid(5, 5);
  notch.triangles.erase(notch.triangles.begin());
  found = faults(notch);
  ASSERT_EQ(kinds(found), Kinds{FaultKind::hole});
  EXPECT_NE(found[0].examples[0].find("border of 2 edges"), std::string::npos);
}

TEST(FindFaults, NoTriangles) {
  const auto found = faults({{{0, 0}, {1, 0}, {0, 1}}, {}});
  ASSERT_EQ(kinds(found), Kinds{FaultKind::unused_vertex});
  EXPECT_EQ(found[0].count, 3u);
}

TEST(FindFaults, NamesAreDistinct) {
  std::vector<std::string> names;
  for (int k = 0; k <= static_cast<int>(FaultKind::hole); ++k) {
    names.push_back(thalweg::fault_name(static_cast<FaultKind>(k)));
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

TEST(FindFaults, LargeBrokenMeshesTakeSeconds) {
  Mesh mesh = grid(220, 220);
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 7) {
    std::swap(mesh.triangles[i][0], mesh.triangles[(i * 7919) % mesh.triangles.size()][1]);
  }
  const auto found = kinds(faults(mesh));
  EXPECT_NE(std::find(found.begin(), found.end(), FaultKind::overlap), found.end());
}

/// One random change to a sound mesh.
void damage(Mesh& mesh) {
  const auto pick = [](std::size_t size) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::size_t>(0, size));
  };
  Corners& t = mesh.triangles[pick(mesh.triangles.size())];
  switch (pick(7)) {
    case 0:
      t = mesh.triangles.back(), mesh.triangles.pop_back();
      break;
    case 1:
      t[pick(3)] = static_cast<std::uint32_t>(pick(mesh.points.size()));
      break;
    case 2:
      mesh.points[t[pick(3)]] = {static_cast<double>(pick(12)) - 3, static_cast<double>(pick(12)) - 3};
      break;
    case 3:
      mesh.triangles.push_back(Corners(t));
      break;
    case 4:
      std::swap(t[0], t[1]);
      break;
    case 5:
      std::swap(t[pick(3)], mesh.triangles[pick(mesh.triangles.size())][pick(3)]);
      break;
    default: {  // a flip, allowed or not
      for (Corners& other : mesh.triangles) {
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j) {
            if (t[i] != other[(j + 1) % 3] || t[(i + 1) % 3] != other[j]) continue;
            const std::uint32_t a = t[i], b = t[(i + 1) % 3], c = t[(i + 2) % 3], d = other[(j + 2) % 3];
            t = {d, c, a};
            other = {c, d, b};
            return;
          }
        }
      }
    }
  }
}

RC_GTEST_PROP(FindFaultsLaws, EmptyIfAndOnlyIfATriangulation, ()) {
  const auto cloud = *support::clouds(14);
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
  Mesh mesh{cloud.places(), oracle::any_triangulation(sites)};
  RC_ASSERT(faults(mesh).empty());

  const int changes = *rc::gen::inRange(1, 4);
  for (int i = 0; i < changes && !mesh.triangles.empty(); ++i) damage(mesh);
  RC_LOG() << ::testing::PrintToString(mesh.triangles);
  const auto moved = oracle::sites_of(std::span<const Point2>(mesh.points));
  const bool sound = oracle::is_triangulation(moved, mesh.triangles);
  RC_CLASSIFY(sound);
  RC_ASSERT(faults(mesh).empty() == sound);
}

/// What is reported is there: crossings, overlaps and holes against the definition.
RC_GTEST_PROP(FindFaultsLaws, GeometricFaultsAreReal, ()) {
  const auto cloud = *support::clouds(10);
  const auto sites = oracle::sites_of(std::span<const thalweg::Point3>(cloud.points));
  Mesh mesh{cloud.places(), oracle::any_triangulation(sites)};
  const int changes = *rc::gen::inRange(1, 4);
  for (int i = 0; i < changes && !mesh.triangles.empty(); ++i) damage(mesh);
  const auto moved = oracle::sites_of(std::span<const Point2>(mesh.points));
  const auto found = kinds(faults(mesh));
  const auto has = [&](FaultKind kind) { return std::find(found.begin(), found.end(), kind) != found.end(); };

  std::vector<oracle::Tri> sound;
  for (Corners t : mesh.triangles) {
    const auto area = oracle::area(moved[t[0]], moved[t[1]], moved[t[2]]);
    if (area < 0) std::swap(t[1], t[2]);
    if (area != 0) sound.push_back(oracle::rotated(t));
  }
  std::sort(sound.begin(), sound.end());
  sound.erase(std::unique(sound.begin(), sound.end()), sound.end());
  bool overlap = false;
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    sum += oracle::area(moved[sound[i][0]], moved[sound[i][1]], moved[sound[i][2]]);
    for (std::size_t j = 0; j < i; ++j) overlap = overlap || oracle::share_area(moved, sound[i], sound[j]);
  }
  RC_ASSERT(has(FaultKind::overlap) == overlap);
  if (!overlap && !sound.empty()) RC_ASSERT(has(FaultKind::hole) == (sum < oracle::hull_area(moved)));

  bool crossing = false;
  const auto edges = oracle::edges_of(sound);
  for (const auto& [a, b] : edges) {
    for (const auto& [c, d] : edges) {
      crossing = crossing || oracle::cross(moved[a], moved[b], moved[c], moved[d]) ||
                 oracle::on_open_segment(moved[a], moved[b], moved[c]) ||
                 oracle::on_open_segment(moved[a], moved[b], moved[d]);
    }
  }
  RC_ASSERT(has(FaultKind::crossing) == crossing);
}

/// Whether a triangle covers the places a little to the right of a -> b next to `at`, one of the two; for
/// coordinates of few digits.
bool covered_on_the_right(const Mesh& mesh, Point2 a, Point2 b, Point2 at) {
  const Point2 way{b.x - a.x, b.y - a.y};
  const double along = at == a ? 1e-3 : -1e-3, aside = 1e-6;
  const Point2 p{at.x + along * way.x + aside * way.y, at.y + along * way.y - aside * way.x};
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Corners& t) {
    const Point2 u = mesh.points[t[0]], v = mesh.points[t[1]], w = mesh.points[t[2]];
    return oracle::orient2d(u, v, p) > 0 && oracle::orient2d(v, w, p) > 0 && oracle::orient2d(w, u, p) > 0;
  });
}

/// Holes among triangles that lie over each other: next to edges of more triangles on one side than on the
/// other.
RC_GTEST_PROP(FindFaultsLaws, HolesBesideOverlapsAreReal, ()) {
  const auto pick = [](std::uint32_t size) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::uint32_t>(0, size));
  };
  Mesh mesh = grid(2, 2);
  for (std::uint32_t count = pick(6); count > 0; --count) {
    mesh.triangles.erase(mesh.triangles.begin() + pick(static_cast<std::uint32_t>(mesh.triangles.size())));
  }
  for (std::uint32_t count = 1 + pick(8); count > 0;) {
    const Corners t = {pick(9), pick(9), pick(9)};
    if (oracle::orient2d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) <= 0) continue;
    mesh.triangles.push_back(oracle::rotated(t));
    --count;
  }
  for (Corners& t : mesh.triangles) t = oracle::rotated(t);
  std::sort(mesh.triangles.begin(), mesh.triangles.end());
  mesh.triangles.erase(std::unique(mesh.triangles.begin(), mesh.triangles.end()), mesh.triangles.end());
  RC_LOG() << ::testing::PrintToString(mesh.triangles);

  std::map<std::pair<std::uint32_t, std::uint32_t>, int> more;  // triangles on the left than on the right
  for (const Corners& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++more[{t[i], t[(i + 1) % 3]}], --more[{t[(i + 1) % 3], t[i]}];
  }
  std::size_t open = 0;
  for (const auto& [edge, count] : more) {
    const Point2 a = mesh.points[edge.first], b = mesh.points[edge.second];
    const bool on_hull = std::none_of(mesh.points.begin(), mesh.points.end(),
                                      [&](Point2 p) { return oracle::orient2d(a, b, p) < 0; });
    if (count <= 0 || on_hull) continue;
    open += !covered_on_the_right(mesh, a, b, a) || !covered_on_the_right(mesh, a, b, b);
  }
  RC_CLASSIFY(open > 0);

  std::size_t reported = 0;
  for (const Fault& fault : faults(mesh)) {
    if (fault.kind != FaultKind::hole) continue;
    RC_PRE(fault.count == fault.examples.size());
    for (const std::string& text : fault.examples) {
      reported += std::stoul(text.substr(text.find("border of ") + 10));
    }
  }
  RC_ASSERT(reported == open);
}

}  // namespace
