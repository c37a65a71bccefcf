/// How far a site can be joined at order k, and which sites that leaves: a search need not look beyond.
///
/// A site q is in reach of p if some circle through both has at most k sites strictly inside; a pair of
/// useful order at most k has. Put p at the origin and invert: w' = w / |w|^2. The circle through p with
/// radius R and its centre in the direction of the unit vector x holds w iff |w|^2 < 2 R w . x, that is w' .
/// x > 1 / (2 R), and passes through q iff q' . x = 1 / (2 R). So q is in reach iff in some direction x with
/// q' . x > 0 at most k sites w have w' . x > q' . x.
///
/// Bounds. Directions are divided into sectors. If x lies in the sector from d to e, x = a d + b e with a, b
/// >= 0 and a + b >= 1, so that w' . x is at least the lesser of w' . d and w' . e, if that is positive: the
/// (k + 1)-th largest of these lesser values, over some of the sites, is a level that more than k sites come
/// up to everywhere in the sector. And q' . x is at most |q'| times the cosine of the least angle between
/// that sector and q's own. If it stays below the level in each sector, q is out of reach; so there is one
/// bound on |q'|, that is on the distance of q, for each sector.
///
/// Search. The sites in reach, with p, are connected in the Delaunay graph. Let C be a circle through p and q
/// with at most k sites inside. If there are any, they are connected, and joined to p and to q
/// (circle_count.cpp); and each of them is in reach, by the circle through it that touches C at p from
/// within. If there are none, the sites on C are a convex polygon whose sides are edges, and all of them are
/// in reach. So a search along edges from p that goes on from every site not ruled out by the bounds meets
/// them all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/predicates_inline.hpp"
#include "thalweg/circle_count.hpp"

namespace thalweg::detail {

/// The way from one site to another.
struct Way {
  double x, y;
  double square;    // of its length
  unsigned sector;  // of its direction, 0..15 counter-clockwise
};

inline Way way_between(Point2 from, Point2 to) noexcept {
  // The sector within a quadrant, then mirrored: rounding may move a way across a border by some 2^-52, which
  // the slack of the bounds allows for.
  constexpr double kTangent = 0.41421356237309503;  // of 22.5 degrees
  const double x = to.x - from.x, y = to.y - from.y, along = std::fabs(x), up = std::fabs(y);
  const unsigned within =
      (up > kTangent * along ? 1u : 0u) + (up > along ? 1u : 0u) + (kTangent * up > along ? 1u : 0u);
  return {x, y, x * x + y * y, within ^ (x < 0 ? 7u : 0u) ^ (y < 0 ? 15u : 0u)};
}

/// The reach of one site p. Holds scratch memory: one per thread.
class Reach {
 public:
  /// Finds the bounds for p from some sites near it. Complexity: O(k) and the degrees of these sites.
  void measure(const DelaunayGraph& graph, VertexId p, unsigned k);

  /// Finds what may be in reach by the search; false if that is not bounded, or by too little: at the rim of
  /// all sites, and where distances are very uneven. Requires: measured. Complexity: O(k) sites.
  bool collect(const DelaunayGraph& graph);

  /// What `collect` found, without the neighbours of p: every other site in reach, perhaps some more.
  std::span<const VertexId> sites() const noexcept { return reached_; }

  /// Whether the site at the end of q is proved to be out of reach.
  bool is_beyond(const Way& q) const noexcept {
    const double nearness = nearness_[q.sector];
    return q.square * (nearness * nearness) > 1;
  }

  /// Whether all beyond the edge ab in the open cone between two rays that cross it is proved to be out of
  /// reach; all given by their ways from p, `along` is the one from a to b.
  bool is_beyond(const Way& a, const Way& b, const Way& along, const Way& right,
                 const Way& left) const noexcept {
    // A ray r meets ab at the distance |r| (a x b) / (r x ab). What is beyond is further away than the nearer
    // of the two points times the cosine of half the angle between them.
    const unsigned gap = (left.sector - right.sector) % kSectors;
    if (gap > 1) return false;
    const double nearness = gap == 0 ? kCosHalfSector * nearness_[right.sector]
                                     : kCosSector * std::min(nearness_[right.sector], nearness_[left.sector]);
    const double area = (a.x * b.y - a.y * b.x) - kBound * (std::fabs(a.x * b.y) + std::fabs(a.y * b.x));
    const double scaled = area * nearness, square = scaled * scaled;
    const double at_right = most_across(right, along), at_left = most_across(left, along);
    return (scaled > kLeastLength) & (square * right.square > at_right * at_right) &
           (square * left.square > at_left * at_left);
  }

 private:
  static constexpr std::size_t kSectors = 16;

  // A cross product of ways, each coordinate rounded, is wrong by 5 u of its terms, u = 2^-53; what the
  // margin of `most_across` does to it is on the safe side, and keeps underflow out. All other roundings, and
  // those of sectors, are within the slack that the bounds have.
  static constexpr double kBound = 16 * kUnitRoundoff;
  static constexpr double kLeastLength = 0x1p-400;
  static constexpr double kSlack = 1 - 0x1p-20;
  static constexpr double kCosHalfSector = 0.98078528040323043, kCosSector = 0.92387953251128674;

  static double most_across(const Way& ray, const Way& along) noexcept {
    const double left = ray.x * along.y, right = ray.y * along.x;
    return (left - right) + kBound * (std::fabs(left) + std::fabs(right)) + kLeastLength;
  }

  void start(VertexId p, std::size_t near);
  bool expand(const DelaunayGraph& graph, VertexId v, std::size_t most);
  void meet(VertexId v);
  void invert(const DelaunayGraph& graph);
  float level(std::size_t sector, unsigned k);

  Point2 at_p_{};
  std::size_t degree_ = 0;       // of p
  std::size_t expanded_ = 0;     // so many of the sites met have had all their neighbours met
  std::vector<VertexId> met_;    // p, then others, nearest by edges first
  std::vector<VertexId> table_;  // the same, hashed; a power of two, never more than half full
  std::vector<VertexId> reached_;
  std::array<double, kSectors> nearness_{};  // the inverse of the distance up to which a sector is in reach

  /// Inverted sites, in units of about the distance of a neighbour; padded with zeros to whole blocks.
  std::vector<float> x_, y_, bound_, value_;
  double scale_ = 0;
};

}  // namespace thalweg::detail
