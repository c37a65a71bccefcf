/// The polygons beside an edge that is to be inserted, in any triangulation of hostile points: their
/// triangles turn left, fill them exactly, and are constrained Delaunay, the canonical ones where sites are
/// cocircular. The first two bytes say which flips lead away from Delaunay, and which edges are tried.
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "kernel/polygon.hpp"
#include "kernel/sleeve.hpp"
#include "mesh.hpp"
#include "oracle/exact_predicates.hpp"
#include "support/random.hpp"

namespace {

using thalweg::HalfedgeId;
using thalweg::Point2;
using thalweg::Triangle;
using thalweg::Triangulation;
using thalweg::VertexId;

using Sites = std::vector<Point2>;
using Edge = std::pair<VertexId, VertexId>;

/// One side of a sleeve: the base runs along `from`, `to`; the chain from the one to the other on its left.
struct Polygon {
  VertexId from, to;
  std::vector<VertexId> chain;

  /// Its edges, the polygon on their left.
  std::vector<Edge> border() const {
    std::vector<Edge> edges = {{from, to}};
    VertexId last = to;
    for (auto v = chain.rbegin(); v != chain.rend(); ++v) edges.emplace_back(std::exchange(last, *v), *v);
    edges.emplace_back(last, from);
    return edges;
  }
};

/// incircle, and for whole coordinates that the oracle can lift the decision where it is 0.
int canonical_incircle(const Sites& sites, Edge edge, VertexId left, VertexId right) {
  const Point2 a = sites[edge.first.index()], b = sites[edge.second.index()], c = sites[left.index()],
               d = sites[right.index()];
  const int sign = thalweg::incircle(a, b, c, d);
  const auto small = [](double x) { return x == std::floor(x) && x >= 0 && x <= 32; };
  if (sign != 0 ||
      !std::ranges::all_of(std::array{a, b, c, d}, [&](Point2 p) { return small(p.x) && small(p.y); }))
    return sign;
  return oracle::incircle_lifted(a, b, c, d);
}

/// Which vertex lies left of each directed edge of the triangles; an edge twice is a finding.
std::map<Edge, VertexId> left_of_edges(const Sites& sites, const std::vector<Triangle>& triangles) {
  std::map<Edge, VertexId> left;
  for (const auto& [a, b, c] : triangles) {
    fuzz::check(thalweg::orient2d(sites[a.index()], sites[b.index()], sites[c.index()]) > 0,
                "triangles turn left", sites);
    for (const auto& [edge, apex] : {std::pair{Edge{a, b}, c}, {Edge{b, c}, a}, {Edge{c, a}, b}}) {
      fuzz::check(left.emplace(edge, apex).second, "one triangle on a side of an edge", sites);
    }
  }
  return left;
}

void check_polygon(const Sites& sites, const Polygon& polygon) {
  std::vector<Triangle> triangles;
  thalweg::detail::triangulate_polygon(sites, polygon.from, polygon.to, polygon.chain, triangles);
  fuzz::check(triangles.size() == polygon.chain.size(), "a triangle a vertex", sites);
  const std::map<Edge, VertexId> left = left_of_edges(sites, triangles);
  const std::vector<Edge> border = polygon.border();
  for (const Edge& edge : border) fuzz::check(left.contains(edge), "the polygon is filled", sites);
  for (const auto& [edge, apex] : left) {
    if (std::find(border.begin(), border.end(), edge) != border.end()) continue;
    const auto other = left.find({edge.second, edge.first});
    fuzz::check(other != left.end(), "nothing beyond the polygon", sites);
    fuzz::check(canonical_incircle(sites, edge, apex, other->second) <= 0,
                "inner edges are Delaunay, by the canonical choice", sites);
  }
}

/// Both sides of the sleeve from p to q, if there is one.
void check_edge(const Triangulation& t, const Sites& sites, VertexId p, VertexId q) {
  thalweg::detail::Sleeve sleeve;
  if (p == q || t.joined(p, q)) return;
  const bool open = std::ranges::none_of(
      sites, [&](Point2 r) { return support::lies_between(sites[p.index()], sites[q.index()], r); });
  fuzz::check(thalweg::detail::find_sleeve(t, sites, p, q, sleeve) == open,
              "a sleeve unless a site is in the way", sites);
  if (!open) return;
  fuzz::check(sleeve.faces.size() == sleeve.left.size() + sleeve.right.size(), "a face a vertex", sites);
  check_polygon(sites, {p, q, sleeve.left});
  check_polygon(sites, {q, p, {sleeve.right.rbegin(), sleeve.right.rend()}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::uint64_t first = input.byte();
  support::Random random(256 * first + input.byte());
  const Sites sites = fuzz::distinct_sites(fuzz::take_points(input, 32));
  const auto delaunay = thalweg::delaunay(sites);
  if (!delaunay) return 0;
  Triangulation t = *delaunay;
  for (std::uint64_t flips = first % 16; flips > 0; --flips) {
    const HalfedgeId h(random.below(t.halfedge_count()));
    if (fuzz::flippable(t, sites, h)) t.flip(h);
  }
  for (int edges = 0; edges < 4; ++edges) {
    const VertexId p(random.below(t.vertex_count())), q(random.below(t.vertex_count()));
    check_edge(t, sites, p, q);
  }
  return 0;
}
