/// The walk from one site through sleeves of Delaunay triangles to every site that it sees and that may be in
/// reach.
///
/// For a site p and each triangle p, a, b at it, an open cone of directions is pushed outwards through the
/// triangulation:
///
///              c                the cone between the rays p -> r and p -> l has come through the edge ab;
///            / . \              the apex c behind it is inside the cone: c is seen, and the cone parts at it
///          b - . - a            into [r, c] through the edge ac and [c, l] through cb; if c is not inside,
///          the
///           l\ . /r             whole cone goes on through one of the two edges.
///             \./
///              p                R: sites passed on the right (a, ...), L: on the left (b, ...)
///
/// The triangles passed are those that the segment from p to c crosses: its sleeve. Cones are open, so a site
/// behind another on the same line is never seen, and every other site would be met exactly once.
///
/// Useful order of a seen pair p, q. Let s in L be such that no other site of L is strictly inside the circle
/// p, q, s, and t likewise in R. Then the useful order is the larger of the orders of the triangles p, q, s
/// and q, p, t; the sleeve holds such sites, because any site that a circle through p and q could meet first
/// is joined across the segment.
///
/// Pruning. Let ab be an edge of the sleeve, D an empty circle through a and b, and C any circle through p
/// and q. The power with respect to C less that with respect to D is affine. It is <= 0 at p and q, which lie
/// on C and not inside D; if neither a nor b is strictly inside C, it is >= 0 at a and b. The segments pq and
/// ab cross, so at the crossing both signs meet: it is 0 at all four, and p, q, a, b lie on one empty circle.
/// Hence, unless all sites of the sleeve are on one empty circle (then the useful order is 0), every edge of
/// it has an end strictly inside C. The circle p, q, s has no site of L strictly inside, therefore all of R;
/// the circle q, p, t all of L. So the useful order is at least the number of distinct sites of L and of R,
/// both of which only grow along the sleeve: beyond k of either nothing is in reach. Source: the walk is
/// Gudmundsson, Hammar, van Kreveld 2002, section 3, made local; the pruning is our own.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernel/predicates_inline.hpp"
#include "thalweg/circle_count.hpp"

namespace thalweg::detail {

/// Searches from one site at a time. Holds scratch memory: one per thread.
class SleeveSearch {
 public:
  /// Requires: graph and counter outlive the search.
  SleeveSearch(const DelaunayGraph& graph, CircleCounter& counter) : graph_(&graph), counter_(&counter) {}

  /// Calls found(q, order) once for every site q with wanted(q) and a useful order of at most k with p; stops
  /// early and returns true if found returns true. In no particular order, but a function of the
  /// triangulation alone. Complexity: bounded by k, not by the number of sites; wanted sites cost two circle
  /// counts each.
  template <class Wanted, class Found>
  bool run(VertexId p, unsigned& k, Wanted&& wanted, Found&& found) {
    const Triangulation& t = graph_->delaunay();
    for (const VertexId q : graph_->neighbors(p)) {
      if (wanted(q) && found(q, 0u)) return true;
    }
    if (t.isolated(p)) return false;
    for (HalfedgeId h = t.outgoing(p), first = h; h.valid();) {
      if (run_cone(p, Triangulation::next(h), k, wanted, found)) return true;
      h = t.turn_ccw(h);
      if (h == first) break;
    }
    return false;
  }

 private:
  /// A cone about to cross `edge`, which runs from its right to its left side with p's side on its left.
  struct Cone {
    HalfedgeId edge;
    VertexId ray_right, ray_left;
    VertexId passed;  // the site that joins L or R on the way in; invalid for the first cone
    bool passed_left;
    bool cocircular;            // all sites so far lie on the empty circle of the first triangle
    std::uint32_t left, right;  // sizes of L and R before `passed`
  };

  template <class Wanted, class Found>
  bool run_cone(VertexId p, HalfedgeId edge, unsigned& k, Wanted&& wanted, Found&& found) {
    const Triangulation& t = graph_->delaunay();
    const VertexId a = t.origin(edge), b = t.dest(edge);
    const Point2 at_p = graph_->point(p), at_a = graph_->point(a), at_b = graph_->point(b);
    left_.assign(1, b);
    right_.assign(1, a);
    stack_.clear();
    stack_.push_back({edge, a, b, VertexId(), false, true, 1, 1});
    while (!stack_.empty()) {
      const Cone cone = stack_.back();
      stack_.pop_back();
      left_.resize(cone.left);
      right_.resize(cone.right);
      if (cone.passed.valid()) add_distinct(cone.passed_left ? left_ : right_, cone.passed);
      if (!cone.cocircular && std::max(left_.size(), right_.size()) > k) continue;

      const HalfedgeId across = t.twin(cone.edge);
      if (!across.valid()) continue;
      const VertexId c = t.apex(across);
      const Point2 at_c = graph_->point(c);
      const bool cocircular = cone.cocircular && incircle_sign(at_p, at_a, at_b, at_c) == 0;
      if (!cocircular && std::max(left_.size(), right_.size()) > k) continue;

      const auto nl = static_cast<std::uint32_t>(left_.size()),
                 nr = static_cast<std::uint32_t>(right_.size());
      const HalfedgeId right_edge = Triangulation::next(across), left_edge = Triangulation::prev(across);
      const bool right_of_left = orient2d_sign(at_p, graph_->point(cone.ray_left), at_c) < 0;
      const bool left_of_right = orient2d_sign(at_p, graph_->point(cone.ray_right), at_c) > 0;
      if (right_of_left && left_of_right) {
        if (wanted(c)) {
          const unsigned order = cocircular ? 0 : order_with(p, c, k);
          if (order <= k && found(c, order)) return true;
        }
        stack_.push_back({right_edge, cone.ray_right, c, c, true, cocircular, nl, nr});
        stack_.push_back({left_edge, c, cone.ray_left, c, false, cocircular, nl, nr});
      } else if (left_of_right) {
        stack_.push_back({right_edge, cone.ray_right, cone.ray_left, c, true, cocircular, nl, nr});
      } else {
        stack_.push_back({left_edge, cone.ray_right, cone.ray_left, c, false, cocircular, nl, nr});
      }
    }
    return false;
  }

  /// A sleeve can pass the same site twice on one side; only distinct ones count.
  static void add_distinct(std::vector<VertexId>& side, VertexId v) {
    if (std::find(side.begin(), side.end(), v) == side.end()) side.push_back(v);
  }

  unsigned order_with(VertexId p, VertexId q, unsigned k) {
    return pair_order(*graph_, *counter_, p, q, left_, right_, k);
  }

 public:
  /// The useful order of p, q, or k + 1 if more, from the sites of their sleeve left and right of p -> q.
  /// Requires: both sides not empty.
  static unsigned pair_order(const DelaunayGraph& graph, CircleCounter& counter, VertexId p, VertexId q,
                             const std::vector<VertexId>& left, const std::vector<VertexId>& right,
                             unsigned k) {
    const Point2 at_p = graph.point(p), at_q = graph.point(q);
    VertexId s = left[0];
    for (std::size_t i = 1; i < left.size(); ++i) {
      if (incircle_sign(at_p, at_q, graph.point(s), graph.point(left[i])) > 0) s = left[i];
    }
    const unsigned order_left = counter.count_in_circle(p, q, s, k);
    if (order_left > k) return k + 1;
    VertexId t = right[0];
    for (std::size_t i = 1; i < right.size(); ++i) {
      if (incircle_sign(at_q, at_p, graph.point(t), graph.point(right[i])) > 0) t = right[i];
    }
    return std::max(order_left, counter.count_in_circle(q, p, t, k));
  }

 private:
  const DelaunayGraph* graph_;
  CircleCounter* counter_;
  std::vector<VertexId> left_, right_;
  std::vector<Cone> stack_;
};

}  // namespace thalweg::detail
