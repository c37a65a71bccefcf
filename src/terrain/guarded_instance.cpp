/// Corollary 2: the hard instance in general position, for a bounded order.
///
/// Every pair of ends that are not partners has one shield h, moved a little off the segment, to the left of
/// a -> b (a the end of the smaller number). C(h) is the circle through a, h, b. Guards, k + 1 a shield, lie
/// in C(h) far to the right; k = |P| + |H|, M = P and H together. U is at least the diameter of M and the
/// radius of the circle through any three sites of M but the (a, h, b). What is checked here, exactly or with
/// room to spare:
///
///   (1) ends that are not partners: the k + 1 guards of their shield h are strictly inside C(h);
///   (2) h is strictly left of ab, and strictly inside triangle a, b, s for every other site s left of ab;
///   (3) every end right of ab is strictly inside C(h);
///   (4) guards are at least 4 U from every site of M; no three sites of M are collinear.
///
/// Claim. Among the triangulations of order <= k of all sites, a set of segments of S occurs as edges if and
/// only if no two of it cross, and no edge joins ends that are not partners. The pits then follow as in
/// hard_instances.cpp: guards are, like shields, of elevation 3.
///
/// No edge ab for a, b not partners: as h is left of it, it would have a triangle a, b, s on its left. That
/// holds h inside by (2) unless s = h, and then its circle is C(h) with k + 1 sites inside by (1).
///
/// Every set of non-crossing segments: take the Delaunay triangulation constrained to them, which exists by
/// (4). Let t be a triangle of it and C its circle. If C holds no guard, at most |M| = k sites are inside.
/// Suppose C holds a guard g. As t is constrained Delaunay, no site inside C is seen from t; so segments of S
/// that cross C hide g. Were an end z of such a segment e inside C, then walking on e from a point that t
/// sees towards z, either z is seen or another segment comes to hide e; it does so with an end that is seen,
/// in the convex hull of t and the part of e walked, so inside C: a contradiction. So t is cut off from g by
/// a segment e with both ends not inside C, a chord of C of length at most U. C reaches from the chord,
/// within U of M, to g, at least 3 U from it: its radius is at least 1.5 U and the smaller of its parts at
/// the chord is less than 0.1 U high. So g is in the larger part, t in the smaller, which holds no guards,
/// and t has its corners in M. By the definition of U then t = (a, h, b) and C = C(h). Seen from t, g is
/// across ab, so e has points right of ab and at least one end there; by (3) that end is inside C: a
/// contradiction.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "terrain/shields.hpp"
#include "thalweg/hard_instances.hpp"
#include "thalweg/predicates.hpp"

namespace thalweg {
namespace {

using detail::Shield;
using detail::ShieldPlan;

constexpr double kMostCoordinate = 0x1p53;

/// A pair of ends with its shield, as indices of sites; h is left of a -> b.
struct Guarded {
  std::uint32_t a;
  std::uint32_t b;
  std::uint32_t h;
  Point2 way;  ///< from a to where the shield is before it is moved off the segment; rounded
};

/// The sites of M, ends first.
struct Core {
  std::vector<Point2> sites;
  std::vector<Guarded> guarded;
  std::uint32_t ends = 0;

  bool watched(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    if (k < ends || j >= ends) return false;
    const Guarded& g = guarded[k - ends];
    return g.a == i && g.b == j;
  }
};

double squared_distance(Point2 a, Point2 b) noexcept {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// The square of the radius of the circle through three sites or, by rounding, somewhat more; infinite if
/// they are collinear, or so nearly that doubles do not tell.
double squared_radius(Point2 a, Point2 b, Point2 c) noexcept {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double area = std::fabs(left - right) - 0x1p-50 * (std::fabs(left) + std::fabs(right));
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  return 1.001 * squared_distance(a, b) * squared_distance(b, c) * squared_distance(c, a) / (4 * area * area);
}

/// U: the diameter, or the largest radius if that is more. Infinite if three sites are collinear that have no
/// guards.
double reach_of(const Core& core) {
  const auto n = static_cast<std::uint32_t>(core.sites.size());
  double square = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = i + 1; j < n; ++j) {
      square = std::max(square, 1.001 * squared_distance(core.sites[i], core.sites[j]));
      for (std::uint32_t k = j + 1; k < n; ++k) {
        if (core.watched(i, j, k)) continue;
        square = std::max(square, squared_radius(core.sites[i], core.sites[j], core.sites[k]));
      }
    }
  }
  return std::sqrt(square);
}

/// The ends with one shield a pair, still on its segment but for rounding. The plan's shields are at a
/// fraction 1/m of their segments; these are at different fractions between 1/2m and 1/m, for which its laws
/// hold too: with one fraction for all, the shields of symmetric segments are collinear. Each trial deals the
/// fractions out anew.
Core core_of(const ShieldPlan& plan, std::uint32_t trial) {
  Core core;
  core.ends = static_cast<std::uint32_t>(plan.ends.size());
  for (const LatticePoint p : plan.ends) {
    core.sites.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  }
  const auto count = static_cast<double>(plan.shields.size());
  std::uint32_t dealt = 0;
  for (const Shield& shield : plan.shields) {
    dealt += 2 * trial + 1;
    if (shield.from > shield.to) continue;
    const double part = static_cast<double>(dealt % plan.shields.size()) / count;
    const double fraction = 1 / (static_cast<double>(plan.scale) * (1 + part));
    const Point2 a = core.sites[shield.from], b = core.sites[shield.to];
    const Point2 way = {(b.x - a.x) * fraction, (b.y - a.y) * fraction};
    core.guarded.push_back({shield.from, shield.to, static_cast<std::uint32_t>(core.sites.size()), way});
    core.sites.push_back({a.x + way.x, a.y + way.y});
  }
  return core;
}

/// How far a shield must be off its segment for C(h) to have the given radius: |ah| |hb| / (2 radius).
double offset_for(const Core& core, const Guarded& g, double radius) {
  return std::sqrt(squared_distance(core.sites[g.a], core.sites[g.h]) *
                   squared_distance(core.sites[g.h], core.sites[g.b])) /
         (2 * radius);
}

/// `core` enlarged by a power of two so that the radius is met closely on whole coordinates, and its shields
/// moved off. `enlarged` becomes that power.
Core displaced(const Core& core, double radius, double& enlarged) {
  double least = radius;
  for (const Guarded& g : core.guarded) least = std::min(least, offset_for(core, g, radius));
  constexpr double kLeastOffset = 8;
  enlarged = 1;
  while (least * enlarged < kLeastOffset && enlarged < kMostCoordinate) enlarged *= 2;
  Core result = core;
  for (Point2& p : result.sites) p = {p.x * enlarged, p.y * enlarged};
  for (const Guarded& g : core.guarded) {
    const double turned = offset_for(core, g, radius) / std::sqrt(g.way.x * g.way.x + g.way.y * g.way.y);
    const Point2 a = result.sites[g.a];
    result.sites[g.h] = {a.x + std::round((g.way.x - g.way.y * turned) * enlarged),
                         a.y + std::round((g.way.y + g.way.x * turned) * enlarged)};
  }
  return result;
}

/// (2) for one site.
bool lets_pass(const Core& core, Point2 site) {
  return std::ranges::all_of(core.guarded, [&](const Guarded& g) {
    const Point2 a = core.sites[g.a], b = core.sites[g.b], h = core.sites[g.h];
    if (site == h || orient2d(a, b, site) <= 0) return true;
    return orient2d(b, site, h) > 0 && orient2d(site, a, h) > 0;
  });
}

/// (2) for the sites of M, and (3).
bool core_is_sound(const Core& core) {
  for (const Guarded& g : core.guarded) {
    const Point2 a = core.sites[g.a], b = core.sites[g.b], h = core.sites[g.h];
    if (orient2d(a, b, h) <= 0) return false;
    for (std::uint32_t e = 0; e < core.ends; ++e) {
      if (orient2d(a, b, core.sites[e]) < 0 && incircle(a, b, h, core.sites[e]) <= 0) return false;
    }
  }
  return std::ranges::all_of(core.sites, [&](Point2 p) { return lets_pass(core, p); });
}

struct ByPlace {
  bool operator()(Point2 a, Point2 b) const noexcept { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};
using Places = std::set<Point2, ByPlace>;

/// Guards from `first` on, along a parabola so that no three are collinear and no four cocircular, if (1),
/// (2) and (4) hold for all of them.
std::optional<std::vector<Point2>> guards_at(const Core& core, const Guarded& g, Point2 first,
                                             std::uint32_t count, double reach, const Places& taken) {
  std::vector<Point2> guards;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point2 p = {first.x + i, first.y + double{1} * i * i};
    if (std::fabs(p.x) > kMostCoordinate || std::fabs(p.y) > kMostCoordinate) return std::nullopt;
    if (incircle(core.sites[g.a], core.sites[g.b], core.sites[g.h], p) <= 0) return std::nullopt;
    if (taken.contains(p) || !lets_pass(core, p)) return std::nullopt;
    const bool clear = std::ranges::all_of(
        core.sites, [&](Point2 s) { return squared_distance(s, p) >= 4.01 * 4.01 * reach * reach; });
    if (!clear) return std::nullopt;
    guards.push_back(p);
  }
  return guards;
}

/// Guards for every pair; nothing if they find no place. They are looked for 5.2 U right of the middle of the
/// pair, and beside that place.
std::optional<std::vector<Point2>> all_guards(const Core& core, double reach) {
  const auto count = static_cast<std::uint32_t>(core.sites.size() + 1);
  Places taken;
  std::vector<Point2> all;
  for (const Guarded& g : core.guarded) {
    const Point2 a = core.sites[g.a], b = core.sites[g.b];
    const double length = std::sqrt(squared_distance(a, b));
    const Point2 along = {(b.x - a.x) / length, (b.y - a.y) / length};
    std::optional<std::vector<Point2>> guards;
    for (const double aside : {0.0, 0.5, -0.5, 1.0, -1.0, 2.0, -2.0, 3.0, -3.0, 4.0, -4.0}) {
      const double out = 5.2 * reach;
      const Point2 first = {std::round((a.x + b.x) / 2 + out * along.y + aside * reach * along.x),
                            std::round((a.y + b.y) / 2 - out * along.x + aside * reach * along.y)};
      guards = guards_at(core, g, first, count, reach, taken);
      if (guards) break;
    }
    if (!guards) return std::nullopt;
    taken.insert(guards->begin(), guards->end());
    all.insert(all.end(), guards->begin(), guards->end());
  }
  return all;
}

/// Three collinear ends: the segments to blame.
std::optional<Error> fault_of_position(const ShieldPlan& plan) {
  const auto& e = plan.ends;
  for (std::uint32_t i = 0; i < e.size(); ++i) {
    for (std::uint32_t j = i + 1; j < e.size(); ++j) {
      for (std::uint32_t k = j + 1; k < e.size(); ++k) {
        if ((e[j].x - e[i].x) * (e[k].y - e[i].y) != (e[j].y - e[i].y) * (e[k].x - e[i].x)) continue;
        return Error{ErrorCode::invalid_argument,
                     "ends of " + detail::segment_name(i / 2) + ", " + detail::segment_name(j / 2) + " and " +
                         detail::segment_name(k / 2) +
                         " are collinear: move one, Corollary 2 needs general position",
                     {i / 2, j / 2, k / 2}};
      }
    }
  }
  return std::nullopt;
}

HardInstance assemble(const Core& core, std::span<const Point2> guards, double scale) {
  HardInstance instance;
  instance.segments = core.ends / 2;
  instance.shields = static_cast<std::uint32_t>(core.guarded.size());
  instance.guards = static_cast<std::uint32_t>(guards.size());
  instance.order = static_cast<unsigned>(core.sites.size());
  instance.scale = static_cast<std::int64_t>(scale);
  for (std::uint32_t i = 0; i < core.sites.size(); ++i) {
    const double z = i >= core.ends ? 3 : i % 2 == 0 ? 1 : 2;
    instance.points.push_back({core.sites[i].x, core.sites[i].y, z});
  }
  for (const Point2 g : guards) instance.points.push_back({g.x, g.y, 3});
  return instance;
}

/// The instance with circles C(h) of that radius, if everything holds then.
std::optional<HardInstance> attempt(const Core& base, double radius) {
  double enlarged = 1;
  const Core core = displaced(base, radius, enlarged);
  const bool whole = std::ranges::all_of(core.sites, [](Point2 p) {
    return std::fabs(p.x) <= kMostCoordinate && std::fabs(p.y) <= kMostCoordinate;
  });
  if (!whole || !core_is_sound(core)) return std::nullopt;
  const double reach = reach_of(core);
  if (!(reach < kMostCoordinate)) return std::nullopt;
  const std::optional<std::vector<Point2>> guards = all_guards(core, reach);
  if (!guards) return std::nullopt;
  return assemble(core, *guards, enlarged);
}

}  // namespace

Result<HardInstance> corollary2_instance(std::span<const LatticeSegment> segments) {
  const std::uint64_t n = segments.size();
  if (n > kMostCorollary2Segments && n <= kMostTheorem1Segments) {
    const std::uint64_t core = 2 * n * n;
    return Error{ErrorCode::invalid_argument, std::to_string(n) + " segments would need " +
                                                  std::to_string(core + 2 * n * (n - 1) * (core + 1)) +
                                                  " points: give at most " +
                                                  std::to_string(kMostCorollary2Segments)};
  }
  const Result<ShieldPlan> plan = detail::plan_shields(segments, kMostCorollary2Segments);
  if (!plan) return plan.error();
  if (auto fault = fault_of_position(*plan)) return *fault;
  // With some fractions shields are collinear by chance, and C(h) must be large enough for (1), (2) and (3).
  constexpr std::uint32_t kTrials = 8;
  for (std::uint32_t trial = 0; trial < kTrials; ++trial) {
    const Core core = core_of(*plan, trial);
    const double reach = reach_of(core);
    for (double times = 7; times * reach < kMostCoordinate; times *= 2) {
      if (auto instance = attempt(core, times * reach)) return *std::move(instance);
    }
  }
  return Error{ErrorCode::invalid_argument,
               "the points for these segments do not fit into whole numbers below 2^53: give smaller "
               "coordinates, or ends further from collinear"};
}

}  // namespace thalweg
