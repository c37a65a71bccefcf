/// Places by kind, elevations at random or as traps.
#include "truth/drawn_set.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

#include "support/point_sets.hpp"

namespace support {
namespace {

using oracle::Enumeration;
using oracle::Relief;
using thalweg::Point2;
using thalweg::Point3;
using Places = std::vector<Point2>;
using Elevations = std::vector<double>;

Point2 in_box(Random& random, int width, int height) {
  const double x = random.whole(0, width);
  return {x, random.whole(0, height)};
}

/// A point of a circle two times out of three, else one inside.
Point2 in_circle(Random& random, const Places& circle, int radius) {
  if (random.below(3) > 0) return circle[random.below(static_cast<std::uint32_t>(circle.size()))];
  for (;;) {
    const Point2 p{random.whole(-radius, radius), random.whole(-radius, radius)};
    if (p.x * p.x + p.y * p.y < radius * radius) return p;
  }
}

/// A point on the border of a rectangle or of its lower left half, three times out of four, else inside.
Point2 near_border(Random& random, int width, int height, bool triangle) {
  const double x = random.whole(0, width), y = random.whole(0, height);
  switch (random.below(4)) {
    case 0:
      return {x, 0};
    case 1:
      return {0, y};
    case 2:
      if (triangle) return {x, width - x};
      return random.below(2) == 0 ? Point2{x, static_cast<double>(height)}
                                  : Point2{static_cast<double>(width), y};
    default:
      return triangle && x + y > width ? Point2{width - x, width - y} : Point2{x, y};
  }
}

bool are_collinear(const Places& places) {
  const auto sites = oracle::sites_of(std::span<const Point2>(places));
  return oracle::all_collinear(sites);
}

/// Draws until there are so many distinct places, not all collinear.
template <class Draw>
Places distinct(std::uint32_t count, Draw&& draw) {
  Places places;
  while (places.size() < count || are_collinear(places)) {
    if (places.size() == count) places.pop_back();
    const Point2 p = draw();
    const bool is_new =
        std::none_of(places.begin(), places.end(), [&](Point2 q) { return p.x == q.x && p.y == q.y; });
    if (is_new) places.push_back(p);
  }
  return places;
}

Places draw_places(SetKind kind, std::uint32_t count, Random& random) {
  switch (kind) {
    case SetKind::grid5:
      return distinct(count, [&] { return in_box(random, 4, 4); });
    case SetKind::grid7:
      return distinct(count, [&] { return in_box(random, 6, 6); });
    case SetKind::flats:
      return distinct(count, [&] { return in_box(random, 30, 30); });
    case SetKind::circle: {
      constexpr std::array<int, 4> kRadii = {5, 25, 65, 325};
      const int radius = kRadii[random.below(4)];
      const Places circle = integer_circle(radius);
      return distinct(count, [&] { return in_circle(random, circle, radius); });
    }
    case SetKind::collinear_hull: {
      const bool triangle = random.below(2) == 0;
      const int width = static_cast<int>(random.whole(4, 12));
      const int height = triangle ? width : static_cast<int>(random.whole(2, 12));
      return distinct(count, [&] { return near_border(random, width, height, triangle); });
    }
    case SetKind::strip: {
      const int height = static_cast<int>(random.whole(2, 5));
      return distinct(count, [&] { return in_box(random, 1000, height); });
    }
    default:
      return distinct(count, [&] { return in_box(random, 1000, 1000); });
  }
}

/// All different, or from a few levels.
Elevations draw_elevations(std::size_t count, bool flats, Random& random) {
  Elevations z(count);
  const int levels = flats ? 4 : random.below(2) == 0 ? 1000 : static_cast<int>(random.whole(2, 30));
  for (double& height : z) height = random.whole(0, levels - 1);
  return z;
}

/// Two pairs that get in each other's way, and at which order.
struct Conflict {
  oracle::Pair p, q;
  unsigned order;
};

/// A conflict of the sites, either pair in either direction, if there is one.
std::optional<Conflict> draw_conflict(const Enumeration& all, Random& random) {
  const auto n = static_cast<std::uint32_t>(all.size());
  std::vector<oracle::Pair> pairs;
  for (std::uint32_t v = 1; v < n; ++v) {
    for (std::uint32_t u = 0; u < v; ++u) pairs.emplace_back(u, v);
  }
  // The least order of a triangulation that has both.
  std::vector<unsigned> joint(pairs.size() * pairs.size(), oracle::kNoOrder);
  std::vector<std::size_t> held;
  for (const Enumeration::Entry& t : all.all()) {
    held.clear();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if ((t.edges & oracle::edge(pairs[i].first, pairs[i].second)) != 0) held.push_back(i);
    }
    for (const std::size_t i : held) {
      for (const std::size_t j : held) {
        unsigned& least = joint[i * pairs.size() + j];
        least = std::min(least, t.order);
      }
    }
  }
  std::vector<Conflict> conflicts;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const unsigned order = std::max(joint[i * (pairs.size() + 1)], joint[j * (pairs.size() + 1)]);
      if (order == oracle::kNoOrder || all.crossing(pairs[i], pairs[j])) continue;
      if (joint[i * pairs.size() + j] > order) conflicts.push_back({pairs[i], pairs[j], order});
    }
  }
  if (conflicts.empty()) return std::nullopt;
  Conflict result = conflicts[random.below(static_cast<std::uint32_t>(conflicts.size()))];
  if (random.below(2) == 0) std::swap(result.p.first, result.p.second);
  if (random.below(2) == 0) std::swap(result.q.first, result.q.second);
  return result;
}

/// p.first drains over p to p.second, and so q; all others are higher.
Elevations draw_trap(std::size_t count, const Conflict& conflict, Random& random) {
  Elevations z(count);
  std::iota(z.begin(), z.end(), 4.0);
  for (std::size_t i = count; i > 1; --i) {
    std::swap(z[i - 1], z[random.below(static_cast<std::uint32_t>(i))]);
  }
  std::array<double, 4> low = {0, 1, 2, 3};
  for (std::size_t i = low.size(); i > 1; --i) {
    std::swap(low[i - 1], low[random.below(static_cast<std::uint32_t>(i))]);
  }
  const std::array<std::uint32_t, 4> ends = {conflict.p.first, conflict.p.second, conflict.q.first,
                                             conflict.q.second};
  for (std::size_t i = 0; i < ends.size(); ++i) z[ends[i]] = low[i];
  if (z[ends[0]] < z[ends[1]]) std::swap(z[ends[0]], z[ends[1]]);
  if (z[ends[2]] < z[ends[3]]) std::swap(z[ends[2]], z[ends[3]]);
  for (std::uint32_t more = random.below(4); more > 1; --more) {
    z[random.below(static_cast<std::uint32_t>(count))] =
        random.whole(0, static_cast<int>(count) + 3);  // level ground now and then
  }
  return z;
}

/// The fewest pits at one order: of all triangulations of the order, or of all the edges of useful order.
std::pair<unsigned, unsigned> truth_and_relaxation(const Enumeration& all, const Relief& relief, unsigned k) {
  const oracle::EdgeSet useful = all.useful(k);
  auto truth = static_cast<unsigned>(all.size()), relaxed = truth;
  for (const Enumeration::Entry& t : all.all()) {
    relaxed = std::min(relaxed, relief.pits(t.edges & useful));
    if (t.order <= k) truth = std::min(truth, relief.pits(t.edges));
  }
  return {truth, relaxed};
}

bool is_trap(const Enumeration& all, const Relief& relief) {
  return fewest_pits_regardless(all, relief) != all.fewest_pits(relief);
}

DrawnSet drawn(SetKind kind, const Places& places, const Elevations& z,
               std::shared_ptr<const Enumeration> all) {
  DrawnSet set{kind, {}, std::move(all)};
  for (std::size_t i = 0; i < places.size(); ++i) {
    set.cloud.points.push_back({places[i].x, places[i].y, z[i]});
  }
  return set;
}

std::shared_ptr<const Enumeration> enumerate(const Places& places) {
  return std::make_shared<const Enumeration>(oracle::sites_of(std::span<const Point2>(places)));
}

/// Sites with a conflict, if a few attempts find some, and elevations that make it matter.
DrawnSet draw_with_conflict(Random& random) {
  constexpr std::uint32_t kPlaceKinds = 7;
  for (int attempt = 0;; ++attempt) {
    const std::uint32_t count = 7 + random.below(5);
    const Places places = draw_places(static_cast<SetKind>(random.below(kPlaceKinds)), count, random);
    const auto all = enumerate(places);
    const auto conflict = draw_conflict(*all, random);
    if (!conflict && attempt < 5) continue;
    Elevations z = draw_elevations(count, false, random);
    for (int draw = 0; conflict && draw < 6; ++draw) {
      z = draw_trap(count, *conflict, random);
      const auto [truth, relaxed] = truth_and_relaxation(*all, Relief(z), conflict->order);
      if (relaxed < truth) break;
    }
    return drawn(SetKind::conflict, places, z, all);
  }
}

/// Traps of a search of 36,000 sets, one to three of each kind of places.
std::span<const std::vector<Point3>> known_traps() {
  static const std::vector<Point3> kTraps[] = {
      {{365, 783, 10},
       {777, 105, 9},
       {590, 664, 13},
       {550, 35, 1},
       {837, 136, 2},
       {135, 544, 12},
       {425, 200, 8},
       {727, 812, 7},
       {194, 875, 0},
       {318, 94, 11}},
      {{697, 24, 12},
       {56, 132, 2},
       {143, 992, 8},
       {832, 871, 6},
       {241, 65, 6},
       {895, 932, 0},
       {16, 871, 5},
       {8, 444, 4},
       {15, 310, 9},
       {5, 708, 8}},
      {{0, 1, 13},
       {4, 4, 1},
       {3, 2, 8},
       {1, 4, 7},
       {3, 1, 10},
       {4, 3, 6},
       {0, 0, 4},
       {3, 4, 13},
       {0, 3, 3},
       {2, 4, 11}},
      {{5, 5, 6}, {0, 6, 3}, {0, 5, 4}, {5, 1, 0}, {4, 6, 12}, {3, 1, 5}, {5, 6, 10}, {1, 2, 1}, {0, 4, 1}},
      {{4, 2, 9},
       {1, 6, 3},
       {4, 5, 13},
       {0, 0, 7},
       {6, 0, 1},
       {6, 2, 10},
       {4, 0, 6},
       {3, 6, 0},
       {2, 6, 4},
       {5, 4, 8}},
      {{2, 3, 6},
       {1, 5, 9},
       {5, 1, 10},
       {0, 0, 0},
       {5, 2, 8},
       {3, 4, 14},
       {3, 0, 4},
       {1, 2, 11},
       {6, 3, 0},
       {5, 4, 12},
       {4, 5, 1}},
      {{16, 3, 2},
       {24, 21, 7},
       {25, 18, 6},
       {12, 25, 4},
       {10, 7, 11},
       {5, 22, 9},
       {13, 4, 13},
       {6, 26, 0},
       {28, 8, 1},
       {4, 10, 5}},
      {{2, 12, 7},
       {1, 25, 1},
       {15, 20, 8},
       {16, 20, 14},
       {4, 13, 12},
       {25, 25, 4},
       {2, 18, 5},
       {27, 12, 0},
       {15, 3, 3},
       {21, 5, 10},
       {4, 24, 13}},
      {{63, -16, 2},
       {59, -17, 11},
       {-25, 60, 6},
       {-63, -16, 1},
       {1, -52, 12},
       {-13, -20, 10},
       {39, 52, 8},
       {-60, -1, 5},
       {-52, 39, 3}},
      {{48, -38, 11},
       {-25, -60, 6},
       {-62, 15, 1},
       {-60, -25, 4},
       {-56, 16, 10},
       {-19, 46, 9},
       {26, 1, 13},
       {60, -25, 0},
       {25, -60, 3},
       {63, 16, 2}},
      {{-56, 33, 13},
       {-9, -24, 10},
       {-56, -33, 1},
       {16, 63, 0},
       {0, -65, 14},
       {48, 22, 3},
       {-7, -40, 4},
       {26, 56, 11},
       {-33, 56, 9},
       {9, -31, 7},
       {0, 65, 6}},
      {{0, 0, 3},
       {6, 1, 2},
       {1, 4, 4},
       {7, 0, 11},
       {2, 0, 10},
       {3, 0, 8},
       {0, 2, 7},
       {1, 0, 5},
       {4, 3, 6},
       {3, 4, 4}},
      {{5, 9, 8},
       {4, 11, 0},
       {3, 11, 6},
       {2, 10, 9},
       {5, 7, 11},
       {0, 0, 1},
       {1, 0, 9},
       {5, 5, 12},
       {0, 8, 7},
       {2, 0, 0}},
      {{3, 6, 12},
       {0, 4, 9},
       {3, 4, 4},
       {4, 0, 2},
       {0, 5, 14},
       {2, 0, 6},
       {1, 0, 3},
       {2, 4, 7},
       {4, 2, 8},
       {0, 6, 1},
       {0, 3, 11}},
  };
  return kTraps;
}

/// Moves all sites a little or one of them more, perhaps adds one, perhaps changes some elevations.
std::vector<Point3> disturbed(std::vector<Point3> points, Random& random) {
  const auto any = [&] { return random.below(static_cast<std::uint32_t>(points.size())); };
  const bool finely = random.below(2) == 0;
  constexpr double kScale = 8;
  for (Point3& p : points) {
    if (finely) p = {kScale * p.x + random.whole(-2, 2), kScale * p.y + random.whole(-2, 2), p.z};
  }
  if (!finely) {
    Point3& p = points[any()];
    p = {p.x + random.whole(-1, 1), p.y + random.whole(-1, 1), p.z};
  }
  if (points.size() < oracle::kMostEnumerated && random.below(2) == 0) {
    const Point3 p = points[any()], q = points[any()];
    points.push_back({p.x, q.y, random.whole(0, 14)});
  }
  if (random.below(2) == 0) std::swap(points[any()].z, points[any()].z);
  if (random.below(4) == 0) points[any()].z = points[any()].z;
  return points;
}

DrawnSet draw_known_trap(Random& random) {
  const auto traps = known_traps();
  const std::vector<Point3>& trap = traps[random.below(static_cast<std::uint32_t>(traps.size()))];
  for (int attempt = 0;; ++attempt) {
    const Cloud cloud = make_cloud(attempt < 8 ? disturbed(trap, random) : trap);
    DrawnSet set = drawn(SetKind::trap, cloud.places(), cloud.elevations(), enumerate(cloud.places()));
    if (attempt == 8 || is_trap(*set.enumeration, Relief(cloud.elevations()))) return set;
  }
}

}  // namespace

const char* set_kind_name(SetKind kind) noexcept {
  constexpr std::array<const char*, kSetKinds> kNames = {
      "general", "grid5", "grid7", "flats", "circle", "collinear_hull", "strip", "conflict", "trap"};
  return kNames[static_cast<std::size_t>(kind)];
}

DrawnSet draw_set(std::uint64_t seed, std::uint64_t index) {
  Random random(Random(seed).next() + index);
  const auto kind = static_cast<SetKind>(index % kSetKinds);
  if (kind == SetKind::conflict) return draw_with_conflict(random);
  if (kind == SetKind::trap) return draw_known_trap(random);
  const std::uint32_t count = 5 + random.below(oracle::kMostEnumerated - 4);
  const Places places = draw_places(kind, count, random);
  const Elevations z = draw_elevations(count, kind == SetKind::flats, random);
  return drawn(kind, places, z, enumerate(places));
}

std::string printed(const Cloud& cloud) {
  std::ostringstream out;
  showValue(cloud, out);
  return out.str();
}

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

std::vector<unsigned> fewest_pits_regardless(const Enumeration& all, const Relief& relief) {
  std::vector<unsigned> result;
  for (unsigned k = 0; k <= all.most_order(); ++k) {
    result.push_back(truth_and_relaxation(all, relief, k).second);
  }
  return result;
}

}  // namespace support
