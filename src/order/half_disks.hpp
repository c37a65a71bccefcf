/// A bound on useful orders from the sites near one end of a pair: it spares a search most of its walk at
/// large orders.
///
/// Let D be the disk with diameter pq. Any circle through p and q contains one of the two open halves of D:
/// the one on the other side of pq than its centre, or both. If the left half holds a site, the circle p, q,
/// s of sleeve_search.hpp, which has no site on the left strictly inside, cannot contain it; so it contains
/// the right half, and the useful order is at least the number of sites there. Likewise with sides exchanged.
///
/// A site w is in D iff (w - p) . (w - q) < 0, which is linear in q. Let q be any point of the open cone at p
/// between two rays and beyond the edge ab, which crosses the cone. If w is in the disks of pa and pb, it is
/// in the disk of px for every x on ab; and q = p + t (x - p) for one of them and some t > 1, while at p
/// itself the form is positive: so w is in D. Then w - p makes an angle of less than a right one with the way
/// from p to any x on ab, so also with either ray, and if it lies to the left of the left ray, it is to the
/// left of pq.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/predicates_inline.hpp"
#include "thalweg/circle_count.hpp"

namespace thalweg::detail {

/// The sites near one site p. Holds scratch memory: one per thread.
class HalfDisks {
 public:
  /// Below this order a walk is over before the sites near p have paid for being gathered: nothing was gained
  /// at 16, 1.6 times the speed at 20, 2.2 times at 32.
  static constexpr unsigned kLeastOrder = 18;

  /// Gathers sites around p, nearest by edges first: enough for orders up to k. Complexity: O(k).
  void gather(const DelaunayGraph& graph, VertexId p, unsigned k) {
    const std::size_t wanted = 8 * std::size_t{k} + 24;
    met_.assign(std::bit_ceil(4 * wanted), VertexId());
    sites_.assign(1, p);
    meet(p);
    for (std::size_t head = 0; head < sites_.size() && sites_.size() <= wanted; ++head) {
      for (const VertexId v : graph.neighbors(sites_[head])) {
        if (sites_.size() <= wanted && meet(v)) sites_.push_back(v);
      }
    }
    const Point2 at_p = graph.point(p);
    near_.clear();
    for (std::size_t i = 1; i < sites_.size(); ++i) {
      const Point2 at = graph.point(sites_[i]);
      const double x = at.x - at_p.x, y = at.y - at_p.y;
      const double square = x * x + y * y;
      near_.x.push_back(x);
      near_.y.push_back(y);
      near_.square.push_back(square + kBound * square);
      near_.size.push_back(kBound * std::max(std::fabs(x), std::fabs(y)));
    }
  }

  /// Whether the useful order of p and any site beyond ab in the open cone is proved to be above k; all four
  /// are given by the way to them from p. With a, b and both rays the way to a site q it is the bound for p,
  /// q alone. False proves nothing: rounding is never in favour of true.
  template <class Leg>
  bool exceed(unsigned k, const Leg& a, const Leg& b, const Leg& right, const Leg& left) const noexcept {
    constexpr std::size_t kBlock = 32;
    const double size_a = size_of(a), size_b = size_of(b), size_left = size_of(left),
                 size_right = size_of(right);
    unsigned on_left = 0, on_right = 0;
    for (std::size_t begin = 0; begin < near_.x.size(); begin += kBlock) {
      const std::size_t end = std::min(begin + kBlock, near_.x.size());
      for (std::size_t i = begin; i < end; ++i) {
        const double x = near_.x[i], y = near_.y[i], size = near_.size[i];
        const double edge = near_.square[i] + kUnderflowMargin;
        const bool in_both =
            (x * a.x + y * a.y > edge + size * size_a) & (x * b.x + y * b.y > edge + size * size_b);
        on_left += (in_both & (left.x * y - left.y * x > size * size_left + kUnderflowMargin)) ? 1 : 0;
        on_right += (in_both & (x * right.y - y * right.x > size * size_right + kUnderflowMargin)) ? 1 : 0;
      }
      if ((on_left > 0 && on_right > k) || (on_right > 0 && on_left > k)) return true;
    }
    return false;
  }

 private:
  // Let w be a site near p and v another point, both by their ways from p. Each of |w|^2, w . v and w x v is
  // a sum of two products, its terms add up to no more than |w|^2, and to m |v|_1 with m the larger
  // coordinate of w. A term is a product of two rounded differences, and takes part in at most three sums: 2
  // + 1 + 3 roundings of u = 2^-53. The bound itself is low by at most as much. 16 u covers both and what is
  // of higher order. A product that underflows is lost in kUnderflowMargin; overflow makes a side infinite or
  // NaN: where it is the bound, or both, the answer is no; where it is w . v alone, every term of it is right
  // up to its factor 1 + 3 u, and so is its sign.
  static constexpr double kBound = 16 * kUnitRoundoff;
  static_assert(kBound >= 12 * kUnitRoundoff * (1 + 64 * kUnitRoundoff) + 64 * kUnitRoundoff * kUnitRoundoff);

  template <class Leg>
  static double size_of(const Leg& leg) noexcept {
    return std::fabs(leg.x) + std::fabs(leg.y);
  }

  /// Enters v into the table of sites met; returns whether it is new. The table is never more than half full.
  bool meet(VertexId v) {
    const std::size_t mask = met_.size() - 1;
    std::size_t place = (v.index() * std::size_t{0x9e3779b9u} >> 7) & mask;
    for (; met_[place].valid(); place = (place + 1) & mask) {
      if (met_[place] == v) return false;
    }
    met_[place] = v;
    return true;
  }

  std::vector<VertexId> sites_, met_;

  /// Columns, so that a compiler can take several sites at a time.
  struct Near {
    std::vector<double> x, y;
    std::vector<double> square;  // x^2 + y^2, and its share of the bound
    std::vector<double> size;    // the larger of |x| and |y|, times kBound

    void clear() { x.clear(), y.clear(), square.clear(), size.clear(); }
  } near_;
};

}  // namespace thalweg::detail
