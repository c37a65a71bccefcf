/// The cuts, the base cases, and the merge along the seam; and what seam.hpp has, since a rise that is not
/// part of the merge costs 6 % of all time.
#include "kernel/part_builder.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "kernel/predicates_inline.hpp"
#include "kernel/seam.hpp"
#include "kernel/seam_split.hpp"
#include "kernel/spatial_order.hpp"

namespace thalweg::detail {
namespace {

using Index = std::uint32_t;

bool less_along(Axis axis, Point2 a, Point2 b) noexcept {
  if (axis == Axis::x) return lexicographically_less(a, b);
  return a.y < b.y || (a.y == b.y && a.x > b.x);
}

Part single(Index site) noexcept {
  return {{}, {}, site};
}

/// Nodes of at most so many sites are sorted along x and merged in that order.
constexpr Index kLeafSites = 6;

/// A point seen from another.
struct Leg {
  double x, y, square;

  Leg(Point2 from, Point2 to) noexcept : x(to.x - from.x), y(to.y - from.y), square(x * x + y * y) {}
};

double cross(const Leg& a, const Leg& b) noexcept {
  return a.x * b.y - a.y * b.x;
}

/// Whether v is inside the circle of a, b, c, for where doubles do not tell. Never inlined, and numbers in
/// place of points: what a merge goes through all the time stays in registers.
[[gnu::noinline]] bool inside_unfiltered(const Point2* sites, Index a, Index b, Index c, Index v) noexcept {
  const int sign = incircle_unfiltered(sites[a], sites[b], sites[c], sites[v]);
  return (sign != 0 ? sign : incircle_tie(sites[a], sites[b], sites[c], sites[v])) > 0;
}

/// Removes the edge from a to a_next. The triangle behind it and the ghost on it become the ghosts of the two
/// edges that come to light:
///
///      a_next                 a_next
///      /   | \                /    \                  .
///    a''   |  ghost   =>    a''     ghost             .
///      \   | /                \    /                  .
///        a                      a
///
/// Returns the half-edge a'' -> a, the next `left`.
inline Index drop_left(const PartArrays& mesh, Index left) noexcept {
  const Index to_next = mesh.twin(left);  // a -> a_next -> a'' -> a
  const Index to_second = next_of(to_next), back = prev_of(to_next);
  const Index outer = mesh.twin(to_second);
  mesh.origins[next_of(left)] = mesh.origin(back);
  mesh.origins[to_second] = kGhost;
  mesh.link(left, outer);
  mesh.link(next_of(left), to_second);
  return back;
}

/// The mirror image of drop_left.
inline Index drop_right(const PartArrays& mesh, Index right) noexcept {
  const Index from_next = mesh.twin(right);  // b_next -> b -> b'' -> b_next
  const Index to_second = next_of(from_next), back = prev_of(from_next);
  const Index outer = mesh.twin(back);
  mesh.origins[right] = mesh.origin(back);
  mesh.origins[from_next] = kGhost;
  mesh.link(prev_of(right), back);
  mesh.link(right, outer);
  return to_second;
}

/// Where a rise ends: nowhere before the tangent, or where these would be the sides.
struct NoLast {
  static constexpr bool is_left(Index) noexcept { return false; }
  static constexpr bool is_right(Index) noexcept { return false; }
};
struct LastSides {
  Index left, right;

  bool is_left(Index h) const noexcept { return h == left; }
  bool is_right(Index h) const noexcept { return h == right; }
};

/// The merge along the seam: candidates by orientation, edges thinned out by circles.
template <class Last>
class Riser : Seam {
 public:
  Riser(const PartArrays& arrays, const Seam& seam, Last last) noexcept
      : Seam(seam), mesh_(arrays), last_(last) {}

  Seam run() noexcept;

 private:
  Point2 at(Index v) const noexcept { return mesh_.at(v); }
  Index a_next() const noexcept { return mesh_.origin(left); }
  Index b_next() const noexcept { return mesh_.dest(right); }

  /// Whether v is strictly above the base.
  bool above(const Leg& to_b, const Leg& to_v, double turn, Index v) const noexcept {
    if (std::fabs(turn) >
        kOrient2dBound * (std::fabs(to_b.x * to_v.y) + std::fabs(to_b.y * to_v.x)) + kUnderflowMargin) {
      return turn > 0;
    }
    return orient2d_unfiltered(at(a), at(b), at(v)) > 0;
  }

  /// Whether v is inside the circle of a, b, c.
  bool inside(const Leg& to_b, const Leg& to_c, double turn, const Leg& to_v, Index c,
              Index v) const noexcept {
    const double det = to_b.square * cross(to_c, to_v) + to_c.square * cross(to_v, to_b) + to_v.square * turn;
    const double size = to_b.square + to_c.square + to_v.square;
    if (std::fabs(det) > kIncircleBound * (size * size) + kUnderflowMargin) return det < 0;
    return inside_unfiltered(mesh_.sites, a, b, c, v);
  }

  template <class Next, class Drop>
  void thin_out(const Leg& to_b, Leg& to_next, double& turn, const Index& side, Next next,
                Drop drop) const noexcept;
  void go_left(Index to) noexcept { left = last_.is_left(to) ? kGhost : to; }
  void go_right(Index to) noexcept { right = last_.is_right(to) ? kGhost : to; }
  void take_left() noexcept;
  void take_right() noexcept;

  PartArrays mesh_;
  Last last_;
};

/// The ghost on a, a_next becomes the triangle a, b, a_next, and b, a_next the base.
template <class Last>
void Riser<Last>::take_left() noexcept {
  const Index up = prev_of(left);
  const Index beyond = mesh_.twin(up);
  mesh_.origins[up] = b;
  mesh_.link(next_of(left), below);
  a = mesh_.origin(left);
  below = up;
  go_left(prev_of(beyond));
}

/// The ghost on b, b_next becomes the triangle a, b, b_next, and a, b_next the base.
template <class Last>
void Riser<Last>::take_right() noexcept {
  const Index up = next_of(right);
  const Index down = prev_of(right);
  const Index beyond = mesh_.twin(up);
  mesh_.origins[down] = a;
  mesh_.link(down, below);
  b = mesh_.origin(up);
  below = up;
  go_right(next_of(beyond));
}

/// Drops the edges of one side for as long as what is behind the next site, `next`, is inside the circle of
/// the base and `next`. `to_next` is that site seen from a, `turn` where it is as seen from the base; both go
/// along.
template <class Last>
template <class Next, class Drop>
void Riser<Last>::thin_out(const Leg& to_b, Leg& to_next, double& turn, const Index& side, Next next,
                           Drop drop) const noexcept {
  for (;;) {
    const Index v = mesh_.apex(mesh_.twin(side));
    if (v == kGhost) return;
    const Leg to_v(at(a), at(v));
    if (!inside(to_b, to_next, turn, to_v, next(), v)) return;
    drop();
    to_next = to_v;
    turn = cross(to_b, to_next);
  }
}

/// Everything is measured from a: `to_b` and so on are differences of coordinates, and their products serve
/// several tests, and the next base too if it also begins at a.
template <class Last>
Seam Riser<Last>::run() noexcept {
  go_left(left);
  go_right(right);
  Leg to_b(at(a), at(b));
  Leg to_c = left != kGhost ? Leg(at(a), at(a_next())) : to_b;
  for (;;) {
    bool left_open = false, right_open = false;
    double turn_c = 0, turn_d = 0;
    if (left != kGhost) {
      turn_c = cross(to_b, to_c);
      left_open = above(to_b, to_c, turn_c, a_next());
    }
    if (left_open)
      thin_out(
          to_b, to_c, turn_c, left, [this] { return a_next(); }, [this] { left = drop_left(mesh_, left); });
    Leg to_d = to_b;
    if (right != kGhost) {
      to_d = Leg(at(a), at(b_next()));
      turn_d = cross(to_b, to_d);
      right_open = above(to_b, to_d, turn_d, b_next());
    }
    if (right_open)
      thin_out(
          to_b, to_d, turn_d, right, [this] { return b_next(); },
          [this] { right = drop_right(mesh_, right); });
    if (!left_open && !right_open) return *this;
    if (!left_open || (right_open && inside(to_b, to_c, turn_c, to_d, a_next(), b_next()))) {
      take_right();
      to_b = to_d;
    } else {
      take_left();
      to_b = Leg(at(a), at(b));
      if (left != kGhost) to_c = Leg(at(a), at(a_next()));
    }
  }
}

class Builder : PartArrays {
 public:
  explicit Builder(const PartArrays& arrays) noexcept : PartArrays(arrays) {}

  /// build_part, at some level of keys: those of all sites have level 0, those of a crowded cell one more.
  Part build(Index lo, Index hi, const Index* keys, int level) const;
  /// merge_parts.
  Part merge(const Part& left, const Part& right, Axis axis, Index slot, SeamSplit* split = nullptr) const;

 private:
  Part build_crowded(Index lo, Index hi, int level) const;
  Part build_lexicographic(Index lo, Index hi) const;
  Part build_leaf(Index lo, Index hi) const;
  Part build_sorted(const Index* ids, Index count, Index slot) const;

  Part pair(Index p, Index q, Index slot) const;
  Part triple(Index p, Index q, Index r, Index slot) const;

  struct Extreme {
    Index site, ghost;
  };
  std::array<Extreme, 4> outermost_sites(const Part& left, const Part& right, Axis axis) const noexcept;
};

Part Builder::build(Index lo, Index hi, const Index* keys, int level) const {
  const Index count = hi - lo;
  if (count <= kLeafSites) return build_leaf(lo, hi);
  if (keys[0] == keys[count - 1]) return build_crowded(lo, hi, level);
  const Cut cut = cut_of({keys, count});
  const Part left = build(lo, lo + cut.low, keys, level);
  const Part right = build(lo + cut.low, hi, keys + cut.low, level);
  return merge(left, right, cut.axis, slot_at(lo + cut.low));
}

/// Sites in one cell.
Part Builder::build_crowded(Index lo, Index hi, int level) const {
  if (hi - lo <= kCellSites || level + 1 == kKeyLevels) return build_lexicographic(lo, hi);
  std::vector<Index> keys(hi - lo);
  morton_keys(std::span(sites + lo, hi - lo), keys);
  return build(lo, hi, keys.data(), level + 1);
}

Part Builder::build_lexicographic(Index lo, Index hi) const {
  if (hi - lo <= kLeafSites) return build_leaf(lo, hi);
  const Index mid = lo + (hi - lo) / 2;
  const Part left = build_lexicographic(lo, mid);
  const Part right = build_lexicographic(mid, hi);
  return merge(left, right, Axis::x, slot_at(mid));
}

Part Builder::build_leaf(Index lo, Index hi) const {
  std::array<Index, kLeafSites> ids;
  for (Index i = lo; i < hi; ++i) {
    Index k = i - lo;
    for (; k > 0 && lexicographically_less(at(i), at(ids[k - 1])); --k) ids[k] = ids[k - 1];
    ids[k] = i;
  }
  return build_sorted(ids.data(), hi - lo, 2 * lo);
}

Part Builder::build_sorted(const Index* ids, Index count, Index slot) const {
  if (count == 1) return single(ids[0]);
  if (count == 2) return pair(ids[0], ids[1], slot);
  if (count == 3) return triple(ids[0], ids[1], ids[2], slot);
  const Index half = count / 2;
  const Part left = build_sorted(ids, half, slot);
  const Part right = build_sorted(ids + half, count - half, slot + 2 * half);
  return merge(left, right, Axis::x, slot + 2 * half - 2);
}

/// An edge: two ghosts back to back.
Part Builder::pair(Index p, Index q, Index slot) const {
  const Index below = 4 * slot, above = below + 4;
  set_corners(slot, q, p, kGhost);
  set_corners(slot + 1, p, q, kGhost);
  link(below, above);
  link(below + 1, above + 2);
  link(below + 2, above + 1);
  const Extremes along_y =
      less_along(Axis::y, at(p), at(q)) ? Extremes{below, above} : Extremes{above, below};
  return {{below, above}, along_y};
}

/// Three sites in lexicographic order: a triangle with three ghosts, or two edges in a row with four.
Part Builder::triple(Index p, Index q, Index r, Index slot) const {
  const int turn = orient2d_sign(at(p), at(q), at(r));
  if (turn == 0) return merge(single(p), pair(q, r, slot + 2), Axis::x, slot);
  const Index a = turn > 0 ? q : r, b = turn > 0 ? r : q;
  const Index face = 4 * slot, pa = face + 4, ab = face + 8, bp = face + 12;
  set_corners(slot, p, a, b);
  set_corners(slot + 1, a, p, kGhost);
  set_corners(slot + 2, b, a, kGhost);
  set_corners(slot + 3, p, b, kGhost);
  link(face, pa);
  link(face + 1, ab);
  link(face + 2, bp);
  link(pa + 1, bp + 2);
  link(ab + 1, pa + 2);
  link(bp + 1, ab + 2);
  // The ghosts behind p, q and r, which leave no doubt along x.
  const Index behind_q = turn > 0 ? ab : bp, behind_r = turn > 0 ? bp : ab;
  const bool p_q = less_along(Axis::y, at(p), at(q)), q_r = less_along(Axis::y, at(q), at(r)),
             p_r = less_along(Axis::y, at(p), at(r));
  const Index low = p_q && p_r ? pa : q_r ? behind_q : behind_r;
  const Index high = !p_q && !p_r ? pa : q_r ? behind_r : behind_q;
  return {{pa, behind_r}, {low, high}};
}

/// The least and the greatest site of two parts along x, then along y, while the parts are still apart; the
/// left one precedes the right one along the axis.
std::array<Builder::Extreme, 4> Builder::outermost_sites(const Part& left, const Part& right,
                                                         Axis axis) const noexcept {
  const auto extreme = [this](const Part& part, Axis along, Index Extremes::*end) {
    const Index ghost = part.along(along).*end;
    return part.is_single() ? Extreme{part.single, kGhost} : Extreme{dest(ghost), ghost};
  };
  std::array<Extreme, 4> result;
  std::size_t i = 0;
  for (const Axis along : {Axis::x, Axis::y}) {
    Extreme low = extreme(left, along, &Extremes::low), high = extreme(right, along, &Extremes::high);
    if (along != axis) {
      const Extreme other_low = extreme(right, along, &Extremes::low);
      const Extreme other_high = extreme(left, along, &Extremes::high);
      if (less_along(along, at(other_low.site), at(low.site))) low = other_low;
      if (less_along(along, at(high.site), at(other_high.site))) high = other_high;
    }
    result[i++] = low;
    result[i++] = high;
  }
  return result;
}

Part Builder::merge(const Part& left, const Part& right, Axis axis, Index slot, SeamSplit* split) const {
  const bool left_single = left.is_single(), right_single = right.is_single();
  // The lower common tangent, from the two extremes that face each other: `in` enters a, `out` leaves b.
  Index in = left_single ? kGhost : hull_prev(left.along(axis).high);
  Index out = right_single ? kGhost : right.along(axis).low;
  Index a = left_single ? left.single : origin(in);
  Index b = right_single ? right.single : dest(out);
  for (bool moved = true; moved;) {
    moved = false;
    while (!left_single && orient2d_sign(at(a), at(b), at(dest(in))) < 0) {
      a = dest(in);
      in = hull_prev(in);
      moved = true;
    }
    while (!right_single && orient2d_sign(at(a), at(b), at(origin(out))) < 0) {
      b = origin(out);
      out = hull_next(out);
      moved = true;
    }
  }
  const Index bottom = 4 * slot, top = bottom + 4;
  const std::array<Extreme, 4> outermost = outermost_sites(left, right, axis);
  if (split != nullptr) split->open();

  const Index first_left = left_single ? kGhost : hull_next(in);
  const Index first_right = right_single ? kGhost : hull_prev(out);
  Seam seam{a, b, first_left, first_right, bottom};
  set_corners(slot, b, a, kGhost);  // b -> a -> ghost
  const Index a_out = left_single ? top + 2 : prev_of(in);
  const Index b_in = right_single ? top + 1 : next_of(out);
  link(bottom + 1, a_out);
  link(bottom + 2, b_in);

  seam = split == nullptr ? Riser(*this, seam, NoLast()).run() : split->rise(seam);

  set_corners(slot + 1, seam.a, seam.b, kGhost);  // a -> b -> ghost
  link(top, seam.below);
  if (!right_single) link(top + 1, prev_of(seam.right));
  if (!left_single) link(top + 2, next_of(seam.left));
  // The hull edges that leave these sites are the old ones, but at the ends of the tangents.
  const auto ghost_of = [&](const Extreme& extreme) {
    return extreme.site == a ? bottom : extreme.site == seam.b ? top : extreme.ghost;
  };
  return {{ghost_of(outermost[0]), ghost_of(outermost[1])}, {ghost_of(outermost[2]), ghost_of(outermost[3])}};
}

}  // namespace

Cut cut_of(std::span<const Index> keys) noexcept {
  const Index bit = std::bit_floor(keys.front() ^ keys.back());
  const auto high =
      std::partition_point(keys.begin(), keys.end(), [bit](Index key) { return (key & bit) == 0; });
  return {(bit & 0xaaaaaaaau) != 0 ? Axis::x : Axis::y, static_cast<Index>(high - keys.begin())};
}

Part build_part(const PartArrays& arrays, Index lo, Index hi, const Index* keys) {
  return Builder(arrays).build(lo, hi, keys, 0);
}

Part merge_parts(const PartArrays& arrays, const Part& left, const Part& right, Axis axis, Index slot,
                 SeamSplit* split) {
  return Builder(arrays).merge(left, right, axis, slot, split);
}

Seam risen_to(const PartArrays& mesh, const Seam& seam, Index last_left, Index last_right) noexcept {
  return Riser(mesh, seam, LastSides{last_left, last_right}).run();
}

void open_left(const PartArrays& mesh, Index left) noexcept {
  const Index lower = mesh.twin(next_of(left));
  mesh.link(next_of(drop_left(mesh, left)), lower);
}

void open_right(const PartArrays& mesh, Index right) noexcept {
  const Index lower = mesh.twin(prev_of(right));
  mesh.link(prev_of(drop_right(mesh, right)), lower);
}

}  // namespace thalweg::detail
