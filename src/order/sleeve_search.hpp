/// The search from one site for all that it can be joined to at order k.
///
/// Mostly the sites in reach are collected along edges (reach.hpp), and each that is wanted is asked for by
/// its own sleeve. Where that is not bounded a walk through sleeves of Delaunay triangles comes to every site
/// that p sees and that may be in reach. For a site p and each triangle p, a, b at it, an open cone of
/// directions is pushed outwards through the triangulation:
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
#include <span>
#include <vector>

#include "kernel/predicates_inline.hpp"
#include "kernel/sleeve.hpp"
#include "order/distinct_sites.hpp"
#include "order/reach.hpp"
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
    for (const VertexId q : graph_->neighbors(p)) {
      if (wanted(q) && found(q, 0u)) return true;
    }
    reach_.measure(*graph_, p, k);
    if (!reach_.collect(*graph_)) return walk(p, k, wanted, found);
    for (const VertexId q : reach_.sites()) {
      if (!wanted(q)) continue;
      const unsigned order = order_across(p, q, k);
      if (order <= k && found(q, order)) return true;
    }
    return false;
  }

  /// The same for all but the neighbours of p, by the walk. Requires: p measured by `reach` at order k or
  /// more.
  template <class Wanted, class Found>
  bool walk(VertexId p, unsigned& k, Wanted&& wanted, Found&& found) {
    const Triangulation& t = graph_->delaunay();
    if (t.isolated(p)) return false;
    for (HalfedgeId h = t.outgoing(p), first = h; h.valid();) {
      if (walk_cone(p, Triangulation::next(h), k, wanted, found)) return true;
      h = t.turn_ccw(h);
      if (h == first) break;
    }
    return false;
  }

  /// How far p, of the last search, can be joined: for `walk`.
  Reach& reach() noexcept { return reach_; }

 private:
  /// A ray out of p, by the site it runs through and the way to it.
  struct Ray {
    VertexId site;
    Way way;
  };

  /// An open cone about to cross `edge`, which runs from its right to its left side with p's side on its
  /// left.
  struct Cone {
    HalfedgeId edge;
    Ray right, left;
    bool cocircular;  // all sites so far lie on the empty circle of the first triangle
  };

  /// A cone that is left for later, with the site that joins L or R on the way into it.
  struct Branch {
    Cone cone;
    VertexId passed;
    std::uint32_t left, right;  // sizes of L and R before `passed` joins R
  };

  template <class Wanted, class Found>
  bool walk_cone(VertexId p, HalfedgeId edge, unsigned& k, Wanted&& wanted, Found&& found) {
    const Triangulation& t = graph_->delaunay();
    const VertexId a = t.origin(edge), b = t.dest(edge);
    at_p_ = graph_->point(p);
    left_.restart(b);
    right_.restart(a);
    branches_.clear();
    Cone cone{edge, ray_to(a), ray_to(b), true};
    for (;;) {
      if (!is_beyond(cone) && advance(cone, k)) {
        const VertexId c = apex_.site;
        const bool is_inside = right_of_left_ && left_of_right_;
        if (is_inside && !reach_.is_beyond(apex_.way) && wanted(c)) {
          const unsigned order = cone.cocircular ? 0 : order_with(p, c, k);
          if (order <= k && found(c, order)) return true;
        }
        const HalfedgeId across = cone.edge;
        // Past c on its right, through the edge that c ends on the left; or on its left.
        const bool goes_right = left_of_right_ && admits(left_, c, cone.cocircular, k);
        const bool goes_left = (is_inside || !left_of_right_) && admits(right_, c, cone.cocircular, k);
        if (goes_right) {
          if (goes_left) {
            branches_.push_back({{Triangulation::prev(across), apex_, cone.left, cone.cocircular},
                                 c,
                                 static_cast<std::uint32_t>(left_.size()),
                                 static_cast<std::uint32_t>(right_.size())});
          }
          cone.edge = Triangulation::next(across);
          if (is_inside) cone.left = apex_;
          left_.add(c);
          continue;
        }
        if (goes_left) {
          cone.edge = Triangulation::prev(across);
          if (is_inside) cone.right = apex_;
          right_.add(c);
          continue;
        }
      }
      if (branches_.empty()) return false;
      const Branch& branch = branches_.back();
      cone = branch.cone;
      left_.shrink(branch.left);
      right_.shrink(branch.right);
      right_.add(branch.passed);
      branches_.pop_back();
    }
  }

  /// Steps over the edge of the cone, to the half-edge behind it. Sets the apex there, and on which side of
  /// the two rays it lies; returns false if nothing is in reach there.
  bool advance(Cone& cone, unsigned k) {
    const Triangulation& t = graph_->delaunay();
    const HalfedgeId across = t.twin(cone.edge);
    if (!across.valid()) return false;
    apex_ = ray_to(t.apex(across));
    if (cone.cocircular) {
      // A triangle p, a, b of an empty circle: all corners of it are as good as a and b.
      cone.cocircular = incircle_sign(at_p_, graph_->point(right_[0]), graph_->point(left_[0]),
                                      graph_->point(apex_.site)) == 0;
      if (!cone.cocircular && std::max(left_.size(), right_.size()) > k) return false;
    }
    cone.edge = across;
    right_of_left_ = turn(cone.left, apex_) < 0;
    left_of_right_ = turn(cone.right, apex_) > 0;
    return true;
  }

  /// Whether all that the cone may still come to is out of reach.
  bool is_beyond(const Cone& cone) const {
    const Triangulation& t = graph_->delaunay();
    const Point2 a = graph_->point(t.origin(cone.edge)), b = graph_->point(t.dest(cone.edge));
    return reach_.is_beyond(way_between(at_p_, a), way_between(at_p_, b), way_between(a, b), cone.right.way,
                            cone.left.way);
  }

  Ray ray_to(VertexId v) const { return {v, way_between(at_p_, graph_->point(v))}; }

  /// The side of the ray `from` on which the site of `to` lies: orient2d_sign of p and the two sites.
  int turn(const Ray& from, const Ray& to) const {
    const double left = from.way.x * to.way.y, right = from.way.y * to.way.x;
    const double bound = kOrient2dBound * (std::fabs(left) + std::fabs(right)) + kUnderflowMargin;
    if (std::fabs(left - right) > bound) return left > right ? 1 : -1;
    return orient2d_unfiltered(graph_->point(from.site), graph_->point(to.site), at_p_);
  }

  /// Whether a sleeve that passes c on this side may lead to a pair of order <= k. It can pass the same site
  /// twice on one side; only distinct ones count.
  static bool admits(const DistinctSites& side, VertexId c, bool cocircular, unsigned k) {
    return cocircular || side.size() < k || (side.size() == k && side.contains(c));
  }

  /// The useful order of p and q, which are not joined, or k + 1 if more, by the sleeve between them.
  unsigned order_across(VertexId p, VertexId q, unsigned k) {
    if (!find_sleeve(graph_->delaunay(), graph_->sites(), p, q, sleeve_)) return k + 1;
    left_.restart(sleeve_.left[0]);
    right_.restart(sleeve_.right[0]);
    if (is_cocircular(*graph_, p, q, sleeve_)) return 0;
    for (const VertexId v : sleeve_.left) left_.add(v);
    for (const VertexId v : sleeve_.right) right_.add(v);
    return std::max(left_.size(), right_.size()) > k ? k + 1 : order_with(p, q, k);
  }

  unsigned order_with(VertexId p, VertexId q, unsigned k) {
    return pair_order(*graph_, *counter_, p, q, left_, right_, k);
  }

 public:
  /// Whether p, q and their whole sleeve are on one circle, which is then empty: the one case in which no
  /// edge across pq has an end strictly inside. It is the circle of the first triangle; and if q is on it,
  /// all triangles between have their corners there, because on an empty circle the convex hull of all sites
  /// is cut into triangles of these.
  static bool is_cocircular(const DelaunayGraph& graph, VertexId p, VertexId q, const Sleeve& sleeve) {
    return incircle_sign(graph.point(p), graph.point(sleeve.right[0]), graph.point(sleeve.left[0]),
                         graph.point(q)) == 0;
  }

  /// The useful order of p, q, or k + 1 if more, from the sites of their sleeve left and right of p -> q.
  /// Requires: both sides not empty; p, q and they are not all on one empty circle.
  static unsigned pair_order(const DelaunayGraph& graph, CircleCounter& counter, VertexId p, VertexId q,
                             std::span<const VertexId> left, std::span<const VertexId> right, unsigned k) {
    const Point2 at_p = graph.point(p), at_q = graph.point(q);
    VertexId s = left[0];
    for (std::size_t i = 1; i < left.size(); ++i) {
      if (incircle_sign(at_p, at_q, graph.point(s), graph.point(left[i])) > 0) s = left[i];
    }
    const unsigned order_left = counter.count_in_circle(p, q, s, k, right);
    if (order_left > k) return k + 1;
    VertexId t = right[0];
    for (std::size_t i = 1; i < right.size(); ++i) {
      if (incircle_sign(at_q, at_p, graph.point(t), graph.point(right[i])) > 0) t = right[i];
    }
    return std::max(order_left, counter.count_in_circle(q, p, t, k, left));
  }

 private:
  const DelaunayGraph* graph_;
  CircleCounter* counter_;
  Point2 at_p_{};
  Ray apex_{};
  bool right_of_left_ = false, left_of_right_ = false;
  Reach reach_;
  Sleeve sleeve_;
  DistinctSites left_, right_;
  std::vector<Branch> branches_;
};

}  // namespace thalweg::detail
