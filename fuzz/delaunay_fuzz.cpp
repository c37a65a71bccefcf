/// Delaunay triangulations of hostile points: the right error or a sound, empty-circle, canonical
/// triangulation.
#include <algorithm>
#include <array>
#include <cmath>

#include "fuzz_input.hpp"
#include "support/ordered_sites.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"

namespace {

using thalweg::ErrorCode;
using thalweg::FaceId;
using thalweg::HalfedgeId;
using thalweg::Point2;
using thalweg::Triangulation;
using thalweg::VertexId;

using Corners = std::array<std::array<double, 2>, 3>;

/// -0.0 equals 0.0 as a coordinate; added to +0.0 it becomes it, so that the two sort as one.
std::array<double, 2> key(Point2 p) {
  return {p.x + 0.0, p.y + 0.0};
}

std::vector<Point2> distinct(std::vector<Point2> points) {
  const auto less = [](Point2 a, Point2 b) { return key(a) < key(b); };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

/// The error that `delaunay` owes us, found the slow way; -1 for none.
int expected_error(const std::vector<Point2>& points) {
  for (const Point2 p : points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return static_cast<int>(ErrorCode::not_finite);
  }
  const std::vector<Point2> sites = distinct(points);
  if (sites.size() < 3) return static_cast<int>(ErrorCode::too_few_points);
  const auto off_line = [&](Point2 p) { return thalweg::orient2d(sites[0], sites[1], p) != 0; };
  if (std::none_of(sites.begin(), sites.end(), off_line)) return static_cast<int>(ErrorCode::all_collinear);
  return -1;
}

/// The triangles by coordinates, each from its least corner, sorted: what must not depend on the order of
/// rows.
std::vector<Corners> triangles_of(const Triangulation& mesh, const std::vector<Point2>& points) {
  std::vector<Corners> triangles;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    Corners corners;
    for (std::uint32_t i = 0; i < 3; ++i) {
      corners[i] = key(points[mesh.origin(Triangulation::halfedge(FaceId(f), i)).index()]);
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void check_vertices(const Triangulation& mesh, const std::vector<Point2>& points) {
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const auto first = std::find(points.begin(), points.end(), points[v]);
    const bool is_site = first == points.begin() + v;
    fuzz::check(mesh.isolated(VertexId(v)) != is_site, "the first of equal points is a vertex, no other",
                points);
  }
}

void check_faces(const Triangulation& mesh, const std::vector<Point2>& points) {
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const auto [a, b, c] = mesh.corners(FaceId(f));
    const Point2 pa = points[a.index()], pb = points[b.index()], pc = points[c.index()];
    fuzz::check(thalweg::orient2d(pa, pb, pc) > 0, "faces are counter-clockwise", points);
    for (const Point2 p : points) {
      fuzz::check(thalweg::incircle(pa, pb, pc, p) <= 0, "no site inside a circumcircle", points);
    }
  }
}

void check_hull(const Triangulation& mesh, const std::vector<Point2>& points) {
  const auto point = [&](VertexId v) { return points[v.index()]; };
  std::size_t hull_edges = 0;
  for (std::uint32_t i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!mesh.on_hull(h)) continue;
    ++hull_edges;
    const Point2 a = point(mesh.origin(h)), b = point(mesh.dest(h));
    for (const Point2 p : points) {
      fuzz::check(thalweg::orient2d(a, b, p) >= 0, "no site beyond a hull edge", points);
    }
  }
  const std::size_t sites = distinct(points).size();
  fuzz::check(mesh.face_count() + 2 + hull_edges == 2 * sites, "Euler: the convex hull is covered once",
              points);
}

/// The sites built in pieces, and every merge in pieces that can be: the same arrays.
void check_sharing(const std::vector<Point2>& points) {
  const support::OrderedSites ordered(points);
  fuzz::check(words_of(ordered, {}) == words_of(ordered, support::shared_everywhere(2)),
              "the arrays do not depend on how the work is shared", points);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::vector<Point2> points = fuzz::take_points(input, 40);
  const auto mesh = thalweg::delaunay(points);
  const int error = mesh ? -1 : static_cast<int>(mesh.error().code);
  fuzz::check(error == expected_error(points), "the error is the right one", points);
  if (!mesh) return 0;
  fuzz::check(!mesh->find_fault(), "the triangulation is sound", points);
  check_vertices(*mesh, points);
  check_faces(*mesh, points);
  check_hull(*mesh, points);

  const std::vector<Point2> reversed(points.rbegin(), points.rend());
  const auto again = thalweg::delaunay(reversed);
  fuzz::check(again && triangles_of(*again, reversed) == triangles_of(*mesh, points),
              "the triangles do not depend on the order of the rows", points);
  if (points.size() % 4 == 0) check_sharing(points);  // threads are slow to start
  return 0;
}
