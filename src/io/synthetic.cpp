/// The kinds of synthetic terrain: where the sites are, and how high.
#include "io/synthetic.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "io/fractal_surface.hpp"
#include "io/random.hpp"

namespace thalweg::io {
namespace {

constexpr double kSpacing = 10;   // mean distance of sites
constexpr double kRelief = 1000;  // half the largest difference of elevations that a surface can have
constexpr double kRoughness = 0.6;

/// The multiple of 1 / parts nearest to `value`: as written with so many decimals, in few bytes.
double rounded(double value, double parts) noexcept {
  return std::floor(value * parts + 0.5) / parts;
}

double side_of(std::uint64_t count) noexcept {
  return kSpacing * std::sqrt(static_cast<double>(count));
}

/// To the micrometre: two of n places, on 10^14 n of them, coincide with probability n / (2 * 10^14).
Point2 uniform_place(Random& random, double side) noexcept {
  constexpr double kParts = 1e6;
  const double x = rounded(random.unit() * side, kParts);
  return {x, rounded(random.unit() * side, kParts)};
}

FractalSurface ground(Random& random, double side, double finest) {
  return {random.next(), side / 2, std::fmin(finest, side / 2), kRoughness};
}

template <class Height>
std::vector<Point3> over_uniform_places(std::uint64_t count, Random& random, Height&& height) {
  const double side = side_of(count);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(count));
  while (points.size() < count) {
    const Point2 p = uniform_place(random, side);
    points.push_back({p.x, p.y, height(p)});
  }
  return points;
}

std::vector<Point3> fractal(std::uint64_t count, Random& random) {
  const FractalSurface surface = ground(random, side_of(count), kSpacing);
  return over_uniform_places(count, random,
                             [&](Point2 p) { return rounded(kRelief * surface.height(p.x, p.y), 1e6); });
}

/// Distance from `value` to the nearest multiple of `period`.
double distance_to_multiple(double value, double period) noexcept {
  return std::fabs(value - period * std::floor(value / period + 0.5));
}

/// Valleys along the directions (4, 3) and (12, 5), both falling with x; sides steep, floors gentle, and not
/// much wider than the sites are apart.
std::vector<Point3> ridge(std::uint64_t count, Random& random) {
  constexpr double kPeriod = 6 * kSpacing;
  const FractalSurface surface = ground(random, side_of(count), 4 * kSpacing);
  return over_uniform_places(count, random, [&](Point2 p) {
    const double one = distance_to_multiple((3 * p.x - 4 * p.y) / 5, kPeriod);
    const double other = distance_to_multiple((5 * p.x - 12 * p.y) / 13, 2 * kPeriod);
    return rounded(std::fmin(one, other) - p.x / 50 + surface.height(p.x, p.y), 1e6);
  });
}

std::vector<Point3> plateau(std::uint64_t count, Random& random) {
  constexpr double kTerraces = 12;
  const FractalSurface surface = ground(random, side_of(count), kSpacing);
  return over_uniform_places(count, random,
                             [&](Point2 p) { return 5 * std::floor(kTerraces * surface.height(p.x, p.y)); });
}

/// 32045 = 5 * 13 * 17 * 29, a product of four primes that are sums of two squares: the circle of this radius
/// has 4 * 3^4 whole points.
constexpr std::int64_t kRadius = 32045;
constexpr std::uint64_t kOnCircle = 324;

std::vector<std::pair<std::int64_t, std::int64_t>> whole_points_of_circle() {
  std::vector<std::pair<std::int64_t, std::int64_t>> points;
  std::int64_t y = kRadius;
  for (std::int64_t x = 0; x < kRadius; ++x) {
    while (x * x + y * y > kRadius * kRadius) --y;
    if (x * x + y * y != kRadius * kRadius) continue;
    // A quarter turn at a time; x = 0 begins each quarter.
    points.insert(points.end(), {{x, y}, {y, -x}, {-x, -y}, {-y, x}});
  }
  return points;
}

/// A whole place that rounds a place on the circle, at a rational angle: ((1 - t^2), 2t) / (1 + t^2).
std::pair<std::int64_t, std::int64_t> near_circle(Random& random) noexcept {
  const double t = random.unit();
  const auto radius = static_cast<double>(kRadius);
  auto x = static_cast<std::int64_t>(rounded(radius * (1 - t * t) / (1 + t * t), 1));
  auto y = static_cast<std::int64_t>(rounded(radius * 2 * t / (1 + t * t), 1));
  for (std::uint64_t turns = random.below(4); turns > 0; --turns) x = std::exchange(y, -x);
  return {x, y};
}

/// Rings are filled one after the other, each on both sides of its circle: on it, then beside it. Centres are
/// on a grid of three radii, so that rings are apart.
std::vector<Point3> ring(std::uint64_t count, Random& random) {
  const auto circle = whole_points_of_circle();
  const std::uint64_t rings = (count + 2 * kOnCircle - 1) / (2 * kOnCircle);
  const auto columns = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(rings))));
  const double spacing = 3 * static_cast<double>(kRadius);
  const FractalSurface surface(random.next(), spacing, spacing / 64, kRoughness);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(count));
  const auto add = [&](std::uint64_t r, std::pair<std::int64_t, std::int64_t> p) {
    const std::uint64_t column = r % columns, row = r / columns;
    const double x = spacing * static_cast<double>(column) + static_cast<double>(p.first);
    const double y = spacing * static_cast<double>(row) + static_cast<double>(p.second);
    points.push_back({x, y, rounded(kRelief * surface.height(x, y), 1)});
  };
  for (std::uint64_t r = 0; r < rings; ++r) {
    // Without a common factor with 324: a few points are spread over the circle, and all are met.
    constexpr std::uint64_t kStep = 109;
    for (std::uint64_t i = 0; i < kOnCircle && points.size() < count; ++i)
      add(r, circle[static_cast<std::size_t>(i * kStep % kOnCircle)]);
    std::vector<std::pair<std::int64_t, std::int64_t>> taken;
    while (taken.size() < kOnCircle && points.size() < count) {
      const auto p = near_circle(random);
      if (p.first * p.first + p.second * p.second == kRadius * kRadius) continue;
      bool fresh = true;
      for (const auto& other : taken) fresh = fresh && other != p;
      if (!fresh) continue;
      taken.push_back(p);
      add(r, p);
    }
  }
  return points;
}

std::vector<Point3> grid(std::uint64_t count, Random& random) {
  const auto columns = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const auto side = static_cast<double>(columns);
  const FractalSurface surface(random.next(), std::fmax(side / 2, 1), 1, kRoughness);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(count));
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t column = i % columns, row = i / columns;
    const auto x = static_cast<double>(column), y = static_cast<double>(row);
    // Nodes of the finest octaves must not be the cells themselves.
    const double z = kRelief * surface.height(x * 0.8125, y * 0.8125);
    points.push_back({x, y, rounded(z, 100)});
  }
  return points;
}

/// Lines 0.7 m apart, across the flight to the north-east, with a point every half metre on average. The
/// jitter is less than what would let two points meet, after rounding too.
std::vector<Point3> lidar(std::uint64_t count, Random& random) {
  constexpr double kAlong = 0.5, kLines = 0.7, kJitter = 0.15, kEast = 500000, kNorth = 4100000;
  const auto on_line = static_cast<std::uint64_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const double side = kAlong * static_cast<double>(on_line);
  const FractalSurface surface = ground(random, side, 2);
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(count));
  const auto jitter = [&] { return kJitter * (2 * random.unit() - 1); };
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t place = i % on_line, scan = i / on_line;
    const double along = kAlong * static_cast<double>(place) + jitter();
    const double line = kLines * static_cast<double>(scan) + jitter();
    const double x = (24 * along - 7 * line) / 25, y = (7 * along + 24 * line) / 25;
    const double z = 250 + side / 20 * surface.height(x, y) + jitter() / 5;
    points.push_back({rounded(kEast + x, 100), rounded(kNorth + y, 100), rounded(z, 100)});
  }
  return points;
}

constexpr std::array<std::pair<std::string_view, TerrainKind>, 6> kKinds = {
    {{"fractal", TerrainKind::fractal},
     {"ridge", TerrainKind::ridge},
     {"plateau", TerrainKind::plateau},
     {"ring", TerrainKind::ring},
     {"grid", TerrainKind::grid},
     {"lidar", TerrainKind::lidar}}};

}  // namespace

std::string_view name_of(TerrainKind kind) noexcept {
  for (const auto& [name, known] : kKinds) {
    if (known == kind) return name;
  }
  return {};
}

std::optional<TerrainKind> terrain_kind(std::string_view name) noexcept {
  for (const auto& [known, kind] : kKinds) {
    if (known == name) return kind;
  }
  return std::nullopt;
}

Result<std::vector<Point3>> synthetic_terrain(TerrainKind kind, std::uint64_t count, std::uint64_t seed) {
  if (count < 3) return Error{ErrorCode::too_few_points, "a terrain of fewer than 3 points: ask for more"};
  if (count > std::numeric_limits<std::uint32_t>::max() - 1) {
    return Error{ErrorCode::too_many_points, std::to_string(count) + " points: ask for at most 4294967294"};
  }
  Random random(seed);
  switch (kind) {
    case TerrainKind::fractal:
      return fractal(count, random);
    case TerrainKind::ridge:
      return ridge(count, random);
    case TerrainKind::plateau:
      return plateau(count, random);
    case TerrainKind::ring:
      return ring(count, random);
    case TerrainKind::grid:
      return grid(count, random);
    case TerrainKind::lidar:
      return lidar(count, random);
  }
  return Error{ErrorCode::invalid_argument, "no such kind of terrain"};
}

}  // namespace thalweg::io
