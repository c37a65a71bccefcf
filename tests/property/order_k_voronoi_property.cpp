/// The order-k Voronoi diagram against diagrams found by testing every circle, on degenerate sets; location
/// against sorting all sites; counting against the graph search.
#include "thalweg/order_k_voronoi.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "kernel/centre_distance.hpp"
#include "oracle/exact_predicates.hpp"
#include "oracle/voronoi.hpp"
#include "support/cloud.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/predicates.hpp"
#include "thalweg/voronoi_counter.hpp"

namespace {

using thalweg::CellId;
using thalweg::OrderKVoronoi;
using thalweg::Point2;
using thalweg::VertexId;
using thalweg::VoronoiHalfedgeId;
using thalweg::VoronoiVertexId;

OrderKVoronoi diagram_of(std::span<const Point2> points, unsigned k, unsigned threads = 1) {
  auto result = thalweg::order_k_voronoi(points, k, {.threads = threads});
  RC_ASSERT(static_cast<bool>(result));
  return std::move(*result);
}

oracle::SiteSet sites_of(const OrderKVoronoi& diagram, CellId c) {
  oracle::SiteSet result;
  for (const VertexId v : diagram.sites(c)) result.push_back(v.index());
  return result;
}

oracle::Voronoi named(const OrderKVoronoi& diagram) {
  oracle::Voronoi result;
  for (std::uint32_t c = 0; c < diagram.cell_count(); ++c) result.cells.insert(sites_of(diagram, CellId(c)));
  for (std::uint32_t v = 0; v < diagram.vertex_count(); ++v) {
    if (diagram.at_infinity(VoronoiVertexId(v))) continue;
    const auto [a, b, c] = diagram.circle(VoronoiVertexId(v));
    result.vertices.insert(oracle::with({}, {a.index(), b.index(), c.index()}));
  }
  for (std::uint32_t h = 0; h < diagram.halfedge_count(); ++h) {
    const VoronoiHalfedgeId halfedge(h);
    if (diagram.at_infinity(halfedge)) continue;
    result.edges.insert(std::minmax(sites_of(diagram, diagram.face(halfedge)),
                                    sites_of(diagram, diagram.face(diagram.twin(halfedge)))));
  }
  return result;
}

/// Every law of the structure that needs no coordinates.
void check_structure(const OrderKVoronoi& diagram) {
  std::size_t around_cells = 0;
  for (std::uint32_t c = 0; c < diagram.cell_count(); ++c) {
    const auto sites = diagram.sites(CellId(c));
    RC_ASSERT(std::adjacent_find(sites.begin(), sites.end(), std::greater_equal<>()) == sites.end());
    diagram.for_each_halfedge(CellId(c), [&](VoronoiHalfedgeId h) {
      ++around_cells;
      RC_ASSERT(diagram.face(h) == CellId(c));
    });
  }
  std::size_t in_cells = 0;
  for (std::uint32_t i = 0; i < diagram.halfedge_count(); ++i) {
    const VoronoiHalfedgeId h(i);
    in_cells += diagram.face(h).valid();
    RC_ASSERT(diagram.twin(diagram.twin(h)) == h);
    RC_ASSERT(diagram.next(diagram.prev(h)) == h && diagram.prev(diagram.next(h)) == h);
    RC_ASSERT(diagram.origin(diagram.next(h)) == diagram.dest(h));
    RC_ASSERT(diagram.gain(h) == diagram.loss(diagram.twin(h)));
    RC_ASSERT(diagram.gain(h).valid() != diagram.at_infinity(h));
    if (diagram.at_infinity(h)) {
      RC_ASSERT(diagram.face(h).valid() != diagram.face(diagram.twin(h)).valid());
      RC_ASSERT(diagram.at_infinity(diagram.origin(h)) && diagram.at_infinity(diagram.dest(h)));
      continue;
    }
    // Neighbours differ by exactly one site, and it is that of the labels.
    oracle::SiteSet here = sites_of(diagram, diagram.face(h));
    RC_ASSERT(std::erase(here, diagram.loss(h).index()) == 1u);
    RC_ASSERT(oracle::with(here, {diagram.gain(h).index()}) ==
              sites_of(diagram, diagram.face(diagram.twin(h))));
  }
  RC_ASSERT(in_cells == around_cells);
  // Euler, with the outside as one more face; a diagram without any vertex is one cell.
  const std::size_t v = diagram.vertex_count(), e = diagram.halfedge_count() / 2;
  if (v > 0) RC_ASSERT(v + diagram.cell_count() + 1 == e + 2);
}

unsigned any_order(std::size_t sites) {
  const auto most = static_cast<unsigned>(sites);
  return std::min(most, *rc::gen::oneOf(rc::gen::inRange(1u, 6u), rc::gen::inRange(1u, most + 1)));
}

Point2 any_place(const support::Cloud& cloud) {
  const auto site = [&] { return cloud.places()[*rc::gen::inRange<std::size_t>(0, cloud.size())]; };
  const Point2 a = site(), b = site(), c = site();
  const double far = *rc::gen::element(1.0, 1e3, 1e300);
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return a;
    case 1:
      return {(a.x + b.x) / 2, (a.y + b.y) / 2};  // on a bisector
    case 2:
      return {(a.x + b.x) / 2 + (a.y - b.y) * 0.25, (a.y + b.y) / 2 - (a.x - b.x) * 0.25};
    case 3:
      return {(a.x + b.x + c.x) / 3, std::nextafter((a.y + b.y) / 2, 1e9)};
    default:
      return {(a.x - b.x + 0.5) * far, (a.y - c.y) * far};
  }
}

RC_GTEST_PROP(OrderKVoronoi, IsTheDiagramOfAllCircles, ()) {
  const auto cloud = *support::clouds(11);
  const unsigned k = std::min(any_order(cloud.size()), cloud.size() - 1);
  const OrderKVoronoi diagram = diagram_of(cloud.places(), k);
  check_structure(diagram);
  const oracle::Voronoi expected = oracle::voronoi(oracle::sites_of(cloud.points), k), found = named(diagram);
  RC_ASSERT(found.cells == expected.cells);
  RC_ASSERT(found.vertices == expected.vertices);
  RC_ASSERT(found.edges == expected.edges);
  RC_ASSERT(found.cells.size() == diagram.cell_count());
  std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& [one, other] : expected.edges) {
    oracle::SiteSet swapped;
    std::set_symmetric_difference(one.begin(), one.end(), other.begin(), other.end(),
                                  std::back_inserter(swapped));
    pairs.emplace(swapped[0], swapped[1]);
  }
  std::set<std::pair<std::uint32_t, std::uint32_t>> crossed;
  for (const auto& [u, v] : diagram.delaunay_edges()) crossed.emplace(u.index(), v.index());
  RC_ASSERT(crossed == pairs);
}

RC_GTEST_PROP(OrderKVoronoi, LocatesAsSortingDoes, ()) {
  const auto cloud = *support::clouds(60);
  const unsigned k = any_order(cloud.size());
  const OrderKVoronoi diagram = diagram_of(cloud.places(), k);
  check_structure(diagram);
  for (int i = 0; i < 12; ++i) {
    const Point2 q = any_place(cloud);
    oracle::SiteSet found;
    for (const VertexId v : diagram.nearest(q)) found.push_back(v.index());
    RC_ASSERT(found == oracle::k_nearest(cloud.places(), q, k));
  }
}

RC_GTEST_PROP(OrderKVoronoi, DoesNotDependOnRowsThreadsOrScale, (std::uint64_t seed)) {
  const auto cloud = *support::clouds(50);
  const unsigned k = any_order(cloud.size());
  const OrderKVoronoi diagram = diagram_of(cloud.places(), k);
  const auto order = support::permutation(cloud.size(), seed);
  std::set<oracle::SiteSet> cells;
  for (oracle::SiteSet set : named(diagram).cells) {
    for (std::uint32_t& site : set) site = order[site];
    std::sort(set.begin(), set.end());
    cells.insert(set);
  }
  RC_ASSERT(named(diagram_of(support::permuted(cloud, order).places(), k)).cells == cells);
  RC_ASSERT(named(diagram_of(support::scaled(cloud, 900).places(), k, 2)).edges == named(diagram).edges);
  RC_ASSERT(named(diagram_of(support::scaled(cloud, -1060).places(), k, 3)).edges == named(diagram).edges);
}

RC_GTEST_PROP(OrderKVoronoi, OfSitesOnALineIsStrips, ()) {
  const auto places = *rc::gen::container<std::set<int>>(rc::gen::inRange(-40, 41));
  RC_PRE(!places.empty());
  const Point2 step = *rc::gen::element(Point2{1, 0}, Point2{0, 1}, Point2{2, -1}, Point2{0.5, 3});
  std::vector<Point2> points;
  for (const int t : places) points.push_back({t * step.x, t * step.y});
  const auto n = static_cast<unsigned>(points.size());
  const unsigned k = any_order(n);
  const OrderKVoronoi diagram = diagram_of(points, k);
  check_structure(diagram);
  RC_ASSERT(diagram.cell_count() == n - k + 1);
  for (int t = -90; t <= 90; t += 7) {
    const Point2 q{t * step.x / 2 + step.y, t * step.y / 2 - step.x};
    oracle::SiteSet found;
    for (const VertexId v : diagram.nearest(q)) found.push_back(v.index());
    RC_ASSERT(found == oracle::k_nearest(points, q, k));
  }
}

RC_GTEST_PROP(VoronoiCounter, CountsAsTheGraphSearch, ()) {
  const auto cloud = *support::clouds(60);
  const std::vector<Point2> places = cloud.places();
  const unsigned k = any_order(cloud.size());
  const OrderKVoronoi diagram = diagram_of(places, k);
  const auto delaunay = thalweg::delaunay(places);
  const thalweg::DelaunayGraph graph(places, *delaunay);
  thalweg::CircleCounter crawl(graph);
  thalweg::VoronoiCounter voronoi(diagram);
  const auto vertex = [&] { return *rc::gen::inRange(0u, cloud.size()); };
  for (int i = 0; i < 30; ++i) {
    VertexId u(vertex()), v(vertex()), w(vertex());
    const int turn = thalweg::orient2d(places[u.index()], places[v.index()], places[w.index()]);
    if (turn == 0) continue;
    if (turn < 0) std::swap(u, v);
    const unsigned limit = *rc::gen::inRange(0u, k);
    RC_ASSERT(voronoi.count_in_circle(u, v, w, limit) == crawl.count_in_circle(u, v, w, limit));
  }
}

/// |centre p|^2 - |centre q|^2 times twice the area, in GMP's integers, with the centre eliminated by hand:
/// the circle is x^2 + y^2 + g x + h y + f = 0.
int compare_by_circle(Point2 a, Point2 b, Point2 c, Point2 p, Point2 q) {
  const int unit = oracle::common_exponent({a, b, c, p, q});
  const auto vector = [unit](Point2 to) { return oracle::exact_vector({0, 0}, to, unit); };
  const oracle::ExactVector va = vector(a), vb = vector(b), vc = vector(c), vp = vector(p), vq = vector(q);
  const mpz_class b2 = oracle::squared(vb) - oracle::squared(va),
                  c2 = oracle::squared(vc) - oracle::squared(va);
  const mpz_class bx = vb.x - va.x, by = vb.y - va.y, cx = vc.x - va.x, cy = vc.y - va.y;
  const mpz_class area = bx * cy - by * cx;
  const mpz_class g = by * c2 - cy * b2, h = cx * b2 - bx * c2;  // times the area
  return sgn(
      mpz_class(area * (oracle::squared(vp) - oracle::squared(vq)) + g * (vp.x - vq.x) + h * (vp.y - vq.y)));
}

RC_GTEST_PROP(CircleCentre, ComparesAsTheEquationOfTheCircle, ()) {
  const auto cloud = *support::clouds(30);
  const int exponent = *rc::gen::element(0, 0, 30, -1060, 1000);
  std::vector<Point2> places = support::scaled(cloud, exponent).places();
  if (*rc::gen::arbitrary<bool>()) {
    Point2& moved = places[*rc::gen::inRange<std::size_t>(0, places.size())];
    moved = {std::nextafter(moved.x, 1e308), moved.y};
  }
  const auto place = [&] { return places[*rc::gen::inRange<std::size_t>(0, places.size())]; };
  Point2 a = place(), b = place();
  const Point2 c = place(), p = place(), q = place();
  const int turn = oracle::orient2d(a, b, c);
  RC_PRE(turn != 0);
  if (turn < 0) std::swap(a, b);
  const int expected = compare_by_circle(a, b, c, p, q);
  const thalweg::detail::CircleCentre centre(a, b, c);
  RC_ASSERT(centre.compare(p, q) == expected);
  RC_ASSERT(centre.filter(p, q).value_or(expected) == expected);
  RC_ASSERT(thalweg::detail::compare_centre_distance_words(a, b, c, p, q).value_or(expected) == expected);
  RC_ASSERT(thalweg::detail::compare_centre_distance_exact(a, b, c, p, q) == expected);
}

}  // namespace
