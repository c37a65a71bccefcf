/// Walking along a segment from triangle to triangle.
#include "kernel/sleeve.hpp"

#include "kernel/assert.hpp"
#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {
namespace {

/// The edge opposite p through which the ray to q leaves p's fan, p's side on its left; invalid if it passes
/// a neighbour of p.
HalfedgeId first_crossed(const Triangulation& t, std::span<const Point2> sites, VertexId p, VertexId q) {
  const Point2 at_p = sites[p.index()], at_q = sites[q.index()];
  const auto side_of = [&](VertexId v) { return orient2d_sign(at_p, sites[v.index()], at_q); };
  const HalfedgeId first = t.outgoing(p);
  int right = side_of(t.dest(first));  // the side of the ray to the right end on which q lies
  for (HalfedgeId h = first; h.valid();) {
    const HalfedgeId edge = Triangulation::next(h);
    const int left = side_of(t.dest(edge));
    if (right > 0 && left < 0) return edge;
    right = left;
    h = t.turn_ccw(h);
    if (h == first) break;
  }
  return HalfedgeId();
}

}  // namespace

bool find_sleeve(const Triangulation& t, std::span<const Point2> sites, VertexId p, VertexId q,
                 Sleeve& sleeve) {
  sleeve.faces.clear();
  sleeve.left.clear();
  sleeve.right.clear();
  HalfedgeId edge = first_crossed(t, sites, p, q);
  if (!edge.valid()) return false;
  const Point2 at_p = sites[p.index()], at_q = sites[q.index()];
  sleeve.faces.push_back(Triangulation::face(edge));
  sleeve.right.push_back(t.origin(edge));
  sleeve.left.push_back(t.dest(edge));
  while (true) {
    // The segment ends inside the hull or at it, so an edge that it crosses properly has a face behind it.
    const HalfedgeId across = t.twin(edge);
    THALWEG_ASSERT(across.valid());
    sleeve.faces.push_back(Triangulation::face(across));
    const VertexId c = t.apex(across);
    if (c == q) return true;
    const int side = orient2d_sign(at_p, at_q, sites[c.index()]);
    if (side == 0) return false;
    if (side > 0) {
      sleeve.left.push_back(c);
      edge = Triangulation::next(across);
    } else {
      sleeve.right.push_back(c);
      edge = Triangulation::prev(across);
    }
  }
}

}  // namespace thalweg::detail
