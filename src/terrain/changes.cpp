/// Measuring changes in time proportional to them.
#include "terrain/changes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "kernel/assert.hpp"
#include "kernel/parallel.hpp"
#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {

namespace {

bool is_delaunay_edge(const Surface& surface, VertexId u, VertexId v) {
  const auto neighbors = surface.graph().neighbors(u);
  return std::find(neighbors.begin(), neighbors.end(), v) != neighbors.end();
}

/// An angle by its two sides: as products of lengths, the cosine and the sine.
struct Angle {
  double dot, cross;
};

/// The angle at p.
Angle angle(Point2 p, Point2 q, Point2 r) noexcept {
  const double qx = q.x - p.x, qy = q.y - p.y, rx = r.x - p.x, ry = r.y - p.y;
  return {qx * rx + qy * ry, qx * ry - qy * rx};
}

/// Of the angle at a; NaN where rounding leaves nothing of it.
double cotangent(Point2 a, Point2 b, Point2 c) {
  const auto of = [](Angle angle) { return angle.dot / angle.cross; };
  const double plain = of(angle(a, b, c));
  if (std::isfinite(plain)) return plain;
  // Products beyond the range of doubles: brought to coordinates of size 1, the angle is the same.
  double size = 0;
  for (const double value : {a.x, a.y, b.x, b.y, c.x, c.y}) size = std::max(size, std::fabs(value));
  const int shift = -std::ilogb(size) - 1;
  const auto scaled = [shift](Point2 p) { return Point2{std::ldexp(p.x, shift), std::ldexp(p.y, shift)}; };
  return of(angle(scaled(a), scaled(b), scaled(c)));
}

/// The largest of `largest` and the cotangent of the angle at a: without a division where it is clear that
/// the quotient is not the larger. With u = 2^-53, dot < fl(least * cross) <= least cross (1 + u) and least
/// <= largest (1 - 4u)(1 + u), so dot / cross < largest, and rounding keeps <=. The bounds keep the product
/// from underflow. If `cross` overflows, the quotient of a finite `dot` is 0.
double larger_cotangent(double largest, Point2 a, Point2 b, Point2 c) {
  constexpr double kLeastCross = 0x1p-900;
  const auto [dot, cross] = angle(a, b, c);
  const double least = largest * (1 - 4 * kUnitRoundoff);
  if (largest > 0x1p-100 && cross > kLeastCross && dot < least * cross) [[likely]]
    return largest;
  return std::max(largest, cotangent(a, b, c));
}

/// The largest of `largest` and the cotangents of the triangle's angles.
double larger_cotangent(double largest, const Surface& surface, const Triangle& t) {
  const auto at = [&](std::size_t corner) { return surface.sites()[t[corner % 3].index()]; };
  for (std::size_t corner = 0; corner < 3; ++corner)
    largest = larger_cotangent(largest, at(corner), at(corner + 1), at(corner + 2));
  return largest;
}

}  // namespace

std::vector<FaceId> changed_faces(const Surface& surface, const Triangulation& triangulation) {
  std::vector<FaceId> changed;
  const auto add_if_changed = [&](FaceId f) {
    if (triangulation.corners(f) != surface.delaunay().corners(f)) changed.push_back(f);
  };
  if (triangulation.is_revision()) {
    for (const FaceId f : triangulation.revised_faces()) add_if_changed(f);
  } else {
    for (std::uint32_t i = 0; i < triangulation.face_count(); ++i) add_if_changed(FaceId(i));
  }
  return changed;
}

EdgeChanges edge_changes(const Surface& surface, const Triangulation& t, std::span<const FaceId> changed) {
  const auto at = [&](VertexId v) { return surface.sites()[v.index()]; };
  std::vector<bool> is_changed(t.face_count(), false);
  for (const FaceId f : changed) is_changed[f.index()] = true;
  EdgeChanges result;
  for (const FaceId f : changed) {
    for (std::uint32_t corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = Triangulation::halfedge(f, corner), twin = t.twin(h);
      if (!twin.valid()) continue;
      const bool both = is_changed[Triangulation::face(twin).index()];
      if (both && twin < h) continue;  // once an edge
      if (both && !is_delaunay_edge(surface, t.origin(h), t.dest(h))) ++result.changed;
      if (incircle_sign(at(t.origin(h)), at(t.dest(h)), at(t.apex(h)), at(t.apex(twin))) > 0)
        ++result.non_delaunay;
    }
  }
  return result;
}

std::vector<std::uint32_t> orders_after(const Surface& surface, const Triangulation& triangulation,
                                        std::span<const FaceId> changed, unsigned limit, unsigned threads,
                                        std::uint64_t& counts) {
  constexpr std::size_t kChunk = 1 << 12;
  std::vector<std::uint32_t> orders(triangulation.face_count(), 0);
  parallel_chunks(changed.size(), kChunk, threads, [&] {
    return [&, counter = CircleCounter(surface.graph())](std::size_t begin, std::size_t end) mutable {
      for (const FaceId f : changed.subspan(begin, end - begin)) {
        const Triangle t = triangulation.corners(f);
        orders[f.index()] = counter.count_in_circle(t[0], t[1], t[2], limit);
      }
    };
  });
  counts += changed.size();
  return orders;
}

SmallestAngles smallest_angles(const Surface& surface, const Triangulation& triangulation, unsigned threads) {
  // The cotangent falls as the angle grows, so the largest one belongs to the smallest angle.
  struct Largest {
    double before = -std::numeric_limits<double>::infinity(), after = before;
  };
  constexpr std::size_t kChunk = 1 << 14;
  const std::size_t count = triangulation.face_count();
  THALWEG_ASSERT(count == surface.delaunay().face_count());
  std::vector<Largest> largest((count + kChunk - 1) / kChunk);
  parallel_chunks(count, kChunk, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      Largest most;
      for (std::size_t i = begin; i < end; ++i) {
        const FaceId f(static_cast<std::uint32_t>(i));
        const Triangle before = surface.delaunay().corners(f), after = triangulation.corners(f);
        if (before == after) {
          // Where nothing is larger than the smaller of the two, neither grows.
          const double largest_of_face = larger_cotangent(std::min(most.before, most.after), surface, before);
          most = {std::max(most.before, largest_of_face), std::max(most.after, largest_of_face)};
        } else {
          most = {larger_cotangent(most.before, surface, before),
                  larger_cotangent(most.after, surface, after)};
        }
      }
      largest[begin / kChunk] = most;
    };
  });
  Largest most;
  for (const auto& [before, after] : largest)
    most = {std::max(most.before, before), std::max(most.after, after)};
  const auto degrees = [](double cotangent) { return std::atan2(1.0, cotangent) * (180 / std::numbers::pi); };
  return {degrees(most.before), degrees(most.after)};
}

}  // namespace thalweg::detail
