/// EdgeInsertion on random triangulations: sound after every edge, constrained Delaunay on both sides by
/// brute force, and undone without a trace.
#include "kernel/edge_insertion.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "oracle/lawson.hpp"
#include "oracle/terrain.hpp"
#include "support/prepared.hpp"
#include "support/random_mesh.hpp"

namespace {

using oracle::Pair;
using oracle::Site;
using support::triangles_of;
using support::vertex;
using thalweg::FaceId;
using thalweg::Triangle;
using thalweg::Triangulation;
using thalweg::VertexId;
using thalweg::detail::EdgeInsertion;

/// Edges of `faces` before the insertion that are still edges between the new triangles or on their border,
/// and the new edge itself: what nobody sees across.
std::vector<Pair> constraints(const Triangulation& before, const EdgeInsertion& insertion) {
  std::set<Pair> old_edges, constraints;
  for (const FaceId f : insertion.faces()) {
    const Triangle t = before.corners(f);
    for (std::size_t i = 0; i < 3; ++i) {
      old_edges.insert(std::minmax(t[i].index(), t[(i + 1) % 3].index()));
    }
  }
  const std::uint32_t p = insertion.vertices()[0].index(), q = insertion.vertices()[1].index();
  constraints.insert(std::minmax(p, q));
  for (const Triangle& t : insertion.triangles()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Pair edge = std::minmax(t[i].index(), t[(i + 1) % 3].index());
      if (old_edges.count(edge) != 0) constraints.insert(edge);
    }
  }
  return {constraints.begin(), constraints.end()};
}

oracle::lawson::GridPoint grid(const Site& s) {
  return {s.x, s.y};
}

/// No vertex of the faces is strictly inside the circle of a new triangle and visible from its centre of
/// mass. All coordinates are three times those of the sites.
bool circles_hold_nothing_visible(std::span<const Site> s, const EdgeInsertion& insertion,
                                  const std::vector<Pair>& walls) {
  std::vector<Site> tripled(s.begin(), s.end());
  for (Site& p : tripled) p = {3 * p.x, 3 * p.y, p.z};
  for (const Triangle& t : insertion.triangles()) {
    const Site &a = s[t[0].index()], &b = s[t[1].index()], &c = s[t[2].index()];
    const Site centre = {a.x + b.x + c.x, a.y + b.y + c.y, 0};
    for (const VertexId v : insertion.vertices()) {
      if (oracle::in_circle(a, b, c, s[v.index()]) <= 0) continue;
      const Site& seen = tripled[v.index()];
      const bool hidden = std::any_of(walls.begin(), walls.end(), [&](const Pair& wall) {
        const Site &from = tripled[wall.first], &to = tripled[wall.second];
        return oracle::cross(centre, seen, from, to) || oracle::on_open_segment(centre, seen, from) ||
               oracle::on_open_segment(centre, seen, to);
      });
      if (!hidden) return false;
    }
  }
  return true;
}

/// Every edge between two new triangles that is no constraint is Delaunay after the symbolic perturbation: of
/// cocircular vertices the canonical diagonals.
bool is_canonical(std::span<const Site> s, const EdgeInsertion& insertion, const std::vector<Pair>& walls) {
  for (const Triangle& t : insertion.triangles()) {
    for (const Triangle& other : insertion.triangles()) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          if (t[i] != other[(j + 1) % 3] || t[(i + 1) % 3] != other[j]) continue;
          const Pair edge = std::minmax(t[i].index(), t[(i + 1) % 3].index());
          if (std::binary_search(walls.begin(), walls.end(), edge)) continue;
          if (oracle::lawson::perturbed_circle({grid(s[t[0].index()]), grid(s[t[1].index()]),
                                                grid(s[t[2].index()]), grid(s[other[(j + 2) % 3].index()])}) >
              0) {
            return false;
          }
        }
      }
    }
  }
  return true;
}

bool is_sound(std::span<const Site> s, const Triangulation& t) {
  if (t.find_fault()) return false;
  std::int64_t sum = 0;
  for (const oracle::Tri& f : triangles_of(t)) {
    const std::int64_t area = oracle::area(s[f[0]], s[f[1]], s[f[2]]);
    if (area <= 0) return false;
    sum += area;
  }
  return sum == oracle::hull_area(s);
}

std::vector<VertexId> sorted(std::span<const VertexId> vertices) {
  std::vector<VertexId> result(vertices.begin(), vertices.end());
  std::sort(result.begin(), result.end());
  return result;
}

/// Plans random pairs one after another, checks each plan, and carries it out.
void insert_random_pairs(const support::Cloud& cloud, int flips, int pairs) {
  const auto sites = cloud.places();
  const auto s = oracle::sites_of(std::span<const thalweg::Point2>(sites));
  Triangulation t = support::random_triangulation(s, flips);
  EdgeInsertion insertion;
  int inserted = 0, dangling = 0;
  for (int i = 0; i < pairs; ++i) {
    const std::uint32_t p = support::random_index(cloud.size()), q = support::random_index(cloud.size());
    if (p == q) continue;
    const Triangulation before = t;
    const bool possible = !t.joined(vertex(p), vertex(q)) && oracle::is_open_pair(s, p, q);
    RC_ASSERT(insertion.plan(t, sites, vertex(p), vertex(q)) == possible);
    RC_ASSERT(t == before);
    if (!possible) continue;
    ++inserted;

    const std::vector<Pair> walls = constraints(before, insertion);
    RC_ASSERT(insertion.triangles().size() == insertion.faces().size());
    RC_ASSERT(circles_hold_nothing_visible(s, insertion, walls));
    RC_ASSERT(is_canonical(s, insertion, walls));
    const auto passed = sorted(insertion.vertices());
    if (std::adjacent_find(passed.begin(), passed.end()) != passed.end()) ++dangling;

    insertion.apply(t);
    RC_ASSERT(is_sound(s, t));
    RC_ASSERT(t.joined(vertex(p), vertex(q)));
    const Triangulation after = t;
    insertion.undo(t);
    RC_ASSERT(triangles_of(t) == triangles_of(before));
    RC_ASSERT(std::ranges::equal(t.twins(), before.twins()));
    RC_ASSERT(!t.find_fault());
    insertion.apply(t);
    RC_ASSERT(triangles_of(t) == triangles_of(after));
  }
  RC_CLASSIFY(inserted > 0);
  RC_CLASSIFY(inserted > 5);
  RC_CLASSIFY(dangling > 0);
}

RC_GTEST_PROP(EdgeInsertionLaws, SoundOnAnyTriangulation, ()) {
  insert_random_pairs(*support::clouds(25), 40, 15);
}

RC_GTEST_PROP(EdgeInsertionLaws, SoundOnFullGrids, ()) {
  const auto width = support::random_index(6) + 2, height = support::random_index(4) + 2;
  support::Cloud cloud;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) cloud.points.push_back({double(x), double(y), 0});
  }
  insert_random_pairs(cloud, 60, 10);
}

/// On a Delaunay triangulation, inserting an edge and nothing else gives the constrained Delaunay
/// triangulation of all sites: every edge but the new one stays locally Delaunay.
RC_GTEST_PROP(EdgeInsertionLaws, DelaunayBesideTheEdge, ()) {
  const support::Prepared prepared(*support::clouds(30));
  const std::uint32_t p = support::random_index(prepared.size()), q = support::random_index(prepared.size());
  EdgeInsertion insertion;
  RC_PRE(p != q);
  RC_PRE(insertion.plan(prepared.delaunay, prepared.places, vertex(p), vertex(q)));
  Triangulation t = prepared.delaunay;
  insertion.apply(t);
  const auto at = [&](VertexId v) { return grid(prepared.sites[v.index()]); };
  for (std::uint32_t i = 0; i < t.halfedge_count(); ++i) {
    const thalweg::HalfedgeId h(i);
    if (t.on_hull(h)) continue;
    const bool new_edge = std::minmax(t.origin(h), t.dest(h)) == std::minmax(vertex(p), vertex(q));
    const int inside = oracle::lawson::perturbed_circle(
        {at(t.origin(h)), at(t.dest(h)), at(t.apex(h)), at(t.apex(t.twin(h)))});
    RC_ASSERT(new_edge || inside < 0);
  }
}

}  // namespace
