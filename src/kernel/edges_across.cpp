/// The search for edges across: samples, circles that shrink, exact tests.
#include "kernel/edges_across.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "kernel/spatial_order.hpp"
#include "thalweg/predicates.hpp"

namespace thalweg::detail {
namespace {

using Index = std::uint32_t;

/// So many sites are tried, and so many are places from which the nearest site is looked for.
constexpr Index kTries = 32, kPlaces = 512;

/// How far from twice its number a half-edge of a site is looked for.
constexpr Index kSlotsEachWay = 64;

/// How often a circle is made smaller before another one is tried.
constexpr int kShrinkings = 64;

struct Vector {
  double x, y;
};

Vector from_to(Point2 a, Point2 b) noexcept {
  return {b.x - a.x, b.y - a.y};
}

double dot(Vector a, Vector b) noexcept {
  return a.x * b.x + a.y * b.y;
}

double distance(Point2 a, Point2 b) noexcept {
  return dot(from_to(a, b), from_to(a, b));
}

/// From the common corner of two sides of a triangle to its circumcentre.
Vector to_circumcentre(Vector u, Vector v) noexcept {
  const double twice = 2 * (u.x * v.y - u.y * v.x), uu = dot(u, u), vv = dot(v, v);
  return {(v.y * uu - u.y * vv) / twice, (u.x * vv - v.x * uu) / twice};
}

/// Whether the first of two edges across that do not cross is below the second.
bool is_below(const PartArrays& mesh, const EdgeAcross& e, const EdgeAcross& f) noexcept {
  const Point2 a = mesh.at(e.left), b = mesh.at(e.right), c = mesh.at(f.left), d = mesh.at(f.right);
  const int c_side = orient2d(a, b, c), d_side = orient2d(a, b, d);
  // If the ends of one are on both sides of the other's line, those of the other are on one side of its own.
  if (c_side * d_side < 0) return orient2d(c, d, a) < 0 || orient2d(c, d, b) < 0;
  return c_side > 0 || d_side > 0;
}

class Search {
 public:
  Search(const PartArrays& mesh, const TwoParts& parts)
      : mesh_(mesh), parts_(parts), steps_left_(kTries * kPlaces + std::uint64_t{parts.hi} - parts.lo) {}

  std::vector<EdgeAcross> run();

 private:
  /// The half-edges of some sites of each part, which leave them.
  using Samples = std::vector<Index>;

  std::array<Samples, 2> samples(Index count) const;

  Point2 at(Index v) const noexcept { return mesh_.at(v); }
  Point2 origin_of(Index h) const noexcept { return at(mesh_.origin(h)); }

  /// Calls visit(g) for every half-edge g that leaves the origin of h, in order, until it returns true or too
  /// much has been done in all. Returns whether it did.
  template <class Visit>
  bool any_around(Index h, Visit&& visit) {
    Index g = h;
    do {
      if (steps_left_ == 0) return false;
      --steps_left_;
      if (visit(g)) return true;
      g = mesh_.around(g);
    } while (g != h);
    return false;
  }

  bool on_hull(Index h) {
    return any_around(h, [&](Index g) { return mesh_.dest(g) == kGhost; });
  }
  Index across(Index p, const Samples& places);
  Vector outward(Index g) const noexcept;
  Index first_inside(Point2 p, Vector to_centre, const Samples& places);
  Index first_beyond(Point2 p, Vector direction, const Samples& places) const noexcept;
  Index shrunk(Point2 p, Vector direction, Index q, const Samples& places);
  Index nearest(Point2 z, const Samples& places);
  bool certain(Index p, Index q);

  const PartArrays& mesh_;
  TwoParts parts_;
  std::uint64_t steps_left_;
};

/// A half-edge that leaves the site of the other part nearest to z: from the nearest place, goes from
/// neighbour to neighbour for as long as they are nearer.
Index Search::nearest(Point2 z, const Samples& places) {
  const auto nearer = [&](Index g, Index h) { return distance(origin_of(g), z) < distance(origin_of(h), z); };
  Index best = *std::min_element(places.begin(), places.end(), nearer);
  for (Index h = kGhost; best != h;) {
    h = best;
    double least = distance(origin_of(h), z);
    any_around(h, [&](Index g) {
      const Index v = mesh_.dest(g);
      if (v == kGhost) return false;
      if (const double d = distance(at(v), z); d < least) {
        least = d;
        best = mesh_.twin(g);
      }
      return false;
    });
  }
  return best;
}

/// Of the other part a half-edge that leaves a site inside a circle through p, or kGhost.
Index Search::first_inside(Point2 p, Vector to_centre, const Samples& places) {
  const Point2 centre = {p.x + to_centre.x, p.y + to_centre.y};
  const Index q = nearest(centre, places);
  return distance(origin_of(q), centre) < dot(to_centre, to_centre) ? q : kGhost;
}

/// The nearest place in the other part in a half-plane whose border goes through p, or kGhost.
Index Search::first_beyond(Point2 p, Vector direction, const Samples& places) const noexcept {
  Index best = kGhost;
  for (const Index h : places) {
    if (!(dot(direction, from_to(p, origin_of(h))) > 0)) continue;
    if (best == kGhost || distance(origin_of(h), p) < distance(origin_of(best), p)) best = h;
  }
  return best;
}

/// Moves the centre of a circle through p towards p until it holds nothing of the other part: onto it comes
/// q, and then whatever is nearest. Returns a half-edge of what is on it in the end, or kGhost.
Index Search::shrunk(Point2 p, Vector direction, Index q, const Samples& places) {
  for (int i = 0; i < kShrinkings; ++i) {
    const Vector to_q = from_to(p, origin_of(q));
    const double t = dot(to_q, to_q) / (2 * dot(direction, to_q));
    if (!(t > 0)) return kGhost;
    const Index next = nearest({p.x + t * direction.x, p.y + t * direction.y}, places);
    if (mesh_.origin(next) == mesh_.origin(q)) return q;
    q = next;
  }
  return kGhost;
}

/// Whether the edge between the origins of two half-edges, one of each part, is in every Delaunay
/// triangulation of all sites. Exact.
bool Search::certain(Index p, Index q) {
  const Point2 a = origin_of(p), b = origin_of(q);
  // Of the neighbours on each side, the one whose circle with a and b holds no other of them.
  std::optional<Point2> left, right;
  bool blocked = false;
  for (const Index h : {p, q}) {
    blocked |= any_around(h, [&](Index g) {
      if (mesh_.dest(g) == kGhost) return false;
      const Point2 v = at(mesh_.dest(g));
      const int side = orient2d(a, b, v);
      if (side == 0) return lexicographically_less(a, v) == lexicographically_less(v, b);  // between them
      if (side > 0 && (!left || incircle(a, b, *left, v) > 0)) left = v;
      if (side < 0 && (!right || incircle(b, a, *right, v) > 0)) right = v;
      return false;
    });
  }
  if (blocked || steps_left_ == 0) return false;
  return !left || !right || incircle(a, b, *left, *right) < 0;
}

/// Out of the hull, from the origin of g, whose face is a ghost's.
Vector Search::outward(Index g) const noexcept {
  const bool follows_ghost = mesh_.dest(g) == kGhost;
  const Vector along = from_to(origin_of(g), at(follows_ghost ? mesh_.apex(g) : mesh_.dest(g)));
  return follows_ghost ? Vector{along.y, -along.x} : Vector{-along.y, along.x};
}

/// A half-edge that leaves the other end of an edge across, from a site of the hull; kGhost if none is found.
Index Search::across(Index p, const Samples& places) {
  Index found = kGhost;
  any_around(p, [&](Index g) {
    const Point2 at_p = origin_of(g);
    const Index u = mesh_.dest(g), v = mesh_.apex(g);
    const bool of_ghost = u == kGhost || v == kGhost;  // the largest circle here is a half-plane
    const Vector direction =
        of_ghost ? outward(g) : to_circumcentre(from_to(at_p, at(u)), from_to(at_p, at(v)));
    Index q = of_ghost ? first_beyond(at_p, direction, places) : first_inside(at_p, direction, places);
    if (q != kGhost) q = shrunk(at_p, direction, q, places);
    if (q == kGhost || !on_hull(q) || !certain(p, q)) return false;
    found = q;
    return true;
  });
  return found;
}

/// Half-edges that leave `count` evenly spaced sites, of the left part and of the right one.
std::array<Search::Samples, 2> Search::samples(Index count) const {
  std::array<Samples, 2> result;
  for (Index i = 0; i < count; ++i) {
    const std::uint64_t sites = parts_.hi - parts_.lo;
    const auto site = static_cast<Index>(parts_.lo + sites * (2 * i + 1) / (2 * count));
    const Index h = halfedge_near(mesh_, parts_, site);
    if (h != kGhost) result[parts_.in_left(site) ? 0 : 1].push_back(h);
  }
  return result;
}

std::vector<EdgeAcross> Search::run() {
  std::array<Samples, 2> tries = samples(kTries);
  for (Samples& of_part : tries) std::erase_if(of_part, [this](Index h) { return !on_hull(h); });
  std::vector<EdgeAcross> edges;
  if (tries[0].empty() && tries[1].empty()) return edges;
  const std::array<Samples, 2> places = samples(kPlaces);
  if (places[0].empty() || places[1].empty()) return edges;
  for (const std::size_t side : {0u, 1u}) {
    for (const Index h : tries[side]) {
      const Index other = across(h, places[1 - side]);
      if (other == kGhost) continue;
      edges.push_back({mesh_.origin(h), mesh_.origin(other)});
      if (side == 1) std::swap(edges.back().left, edges.back().right);
    }
  }
  std::sort(edges.begin(), edges.end(),
            [this](const EdgeAcross& e, const EdgeAcross& f) { return is_below(mesh_, e, f); });
  const auto same = [](const EdgeAcross& e, const EdgeAcross& f) {
    return e.left == f.left && e.right == f.right;
  };
  edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
  return edges;
}

}  // namespace

std::vector<EdgeAcross> edges_across(const PartArrays& mesh, const TwoParts& parts) {
  return Search(mesh, parts).run();
}

Index halfedge_near(const PartArrays& mesh, const TwoParts& parts, Index site) noexcept {
  const Index lo = parts.in_left(site) ? parts.lo : parts.mid;
  const Index hi = parts.in_left(site) ? parts.mid : parts.hi;
  const auto in_slot = [&](Index slot) {
    if (slot - 2 * lo >= 2 * (hi - lo) - 2) return kGhost;  // also slots before 2 lo
    for (Index h = 4 * slot; h < 4 * slot + 3; ++h) {
      if (mesh.origin(h) == site) return h;
    }
    return kGhost;
  };
  for (Index away = 0; away <= kSlotsEachWay; ++away) {
    for (const Index slot : {2 * site + away, 2 * site - away}) {
      if (const Index h = in_slot(slot); h != kGhost) return h;
    }
  }
  return kGhost;
}

}  // namespace thalweg::detail
