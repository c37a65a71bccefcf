#include "benchmark/sets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "io/format.hpp"
#include "io/fractal_surface.hpp"
#include "io/point_table.hpp"
#include "support/random.hpp"

namespace bench {
namespace {

using support::Random;
using thalweg::Point2;
using thalweg::Point3;

using Places = std::vector<Point2>;

constexpr double kTurn = 6.283185307179586;
constexpr Point2 kUtm = {500000, 5400000};

double gaussian(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.unit()));
  return radius * std::cos(kTurn * random.unit());
}

double rounded(double value, double parts) {
  return std::round(value * parts) / parts;
}

/// Calls make(i) for every site.
template <class Make>
Places places_of(std::size_t count, Make&& make) {
  Places places;
  places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) places.push_back(make(i));
  return places;
}

Places uniform(std::size_t count, Random& random) {
  return places_of(count, [&](std::size_t) {
    const double x = random.unit();
    return Point2{x, random.unit()};
  });
}

Places clustered(std::size_t count, Random& random) {
  const Places centres = uniform(100, random);
  return places_of(count, [&](std::size_t) {
    const std::uint32_t k = random.below(100);
    const double sigma = std::pow(10, -6 + k / 20.0);
    const double x = centres[k].x + sigma * gaussian(random);
    return Point2{x, centres[k].y + sigma * gaussian(random)};
  });
}

/// Columns of a square with so many cells.
std::size_t width_of(std::size_t count) {
  return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
}

Places grid(std::size_t count, Random&) {
  const std::size_t width = width_of(count);
  return places_of(count, [&](std::size_t i) {
    return Point2{static_cast<double>(i % width), static_cast<double>(i / width)};
  });
}

Places grid_shuffled(std::size_t count, Random& random) {
  Places places = grid(count, random);
  for (std::size_t i = count; i > 1; --i) {
    std::swap(places[i - 1], places[random.below(static_cast<std::uint32_t>(i))]);
  }
  return places;
}

Places lidar(std::size_t count, Random& random) {
  constexpr double kJitter = 0.8;
  Places places = grid(count, random);
  for (Point2& p : places) {
    p.x = rounded(kUtm.x + p.x + kJitter * random.unit(), 100);
    p.y = rounded(kUtm.y + p.y + kJitter * random.unit(), 100);
  }
  return places;
}

Places ring(std::size_t count, Random& random) {
  return places_of(count, [&](std::size_t) {
    const double turn = kTurn * random.unit();
    return Point2{std::cos(turn), std::sin(turn)};
  });
}

Places parabola(std::size_t count, Random& random) {
  return places_of(count, [&](std::size_t) {
    const double x = 2 * random.unit() - 1;
    return Point2{x, x * x};
  });
}

Places strip(std::size_t count, Random& random) {
  return places_of(count, [&](std::size_t) {
    const double x = 1e6 * random.unit();
    return Point2{x, random.unit()};
  });
}

using Maker = Places (*)(std::size_t, Random&);
constexpr std::array<std::pair<std::string_view, Maker>, 8> kMakers = {{{"uniform", uniform},
                                                                        {"clustered", clustered},
                                                                        {"lidar", lidar},
                                                                        {"grid", grid},
                                                                        {"grid_shuffled", grid_shuffled},
                                                                        {"ring", ring},
                                                                        {"parabola", parabola},
                                                                        {"strip", strip}}};

constexpr auto kNames = [] {
  std::array<std::string_view, kMakers.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kMakers[i].first;
  return names;
}();

/// Whether a file of that name can hold points.
bool readable(const std::string& path) {
  return static_cast<bool>(thalweg::io::format_of(path, {}, thalweg::io::Direction::read));
}

/// The files of real terrain by name.
std::map<std::string, std::string> real_files() {
  std::map<std::string, std::string> files;
  if (const char* folder = std::getenv("THALWEG_DATA"); folder != nullptr && *folder != '\0') {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (!entry.is_regular_file() || !readable(entry.path().string())) continue;
      files.emplace(entry.path().filename().string(), entry.path().string());
    }
  }
  files.insert_or_assign("jacksboro_fault.asc", THALWEG_TEST_DATA "/jacksboro_fault.asc");
  return files;
}

std::vector<Point3> read_terrain(const SetOfSites& set) {
  const auto files = real_files();
  const auto file = files.find(set.name);
  if (set.count != kAll || file == files.end()) throw std::runtime_error("no set " + set.label());
  auto table = thalweg::io::read_points(file->second);
  if (!table) throw std::runtime_error(table.error().message);
  return std::move(table->points);
}

Maker maker_of(std::string_view name) {
  for (const auto& [known, maker] : kMakers) {
    if (known == name) return maker;
  }
  return nullptr;
}

bool synthetic(const SetOfSites& set) {
  return set.count != kAll && maker_of(set.name) != nullptr;
}

/// Elevations in metres with so many parts, as surveys of whole coordinates have them; 0 = not rounded.
double parts_of_elevation(std::string_view name) {
  return name == "lidar" || name.starts_with("grid") ? 100 : 0;
}

std::vector<Point3> raised(const Places& places, double parts) {
  constexpr double kRelief = 1000, kRoughness = 0.6;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point2 low = {kInfinity, kInfinity}, high = {-kInfinity, -kInfinity};
  for (const Point2 p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double width = high.x - low.x, height = high.y - low.y;
  const double coarsest = std::max(width, height) / 2;
  const double spacing = std::sqrt(width * height / static_cast<double>(places.size()));
  const thalweg::io::FractalSurface surface(1, coarsest, std::min(spacing, coarsest), kRoughness);
  std::vector<Point3> points;
  points.reserve(places.size());
  for (const Point2 p : places) {
    const double z = kRelief * surface.height(p.x - low.x, p.y - low.y);
    points.push_back({p.x, p.y, parts == 0 ? z : rounded(z, parts)});
  }
  return points;
}

}  // namespace

std::string SetOfSites::label() const {
  return name + "/" + (count == kAll ? "all" : std::to_string(count));
}

std::span<const std::string_view> synthetic_sets() {
  return kNames;
}

std::vector<SetOfSites> all_sets(std::size_t most) {
  std::vector<SetOfSites> sets;
  for (const std::string_view name : kNames) {
    for (std::size_t count = 1000; count <= most; count *= 10) sets.push_back({std::string(name), count});
  }
  for (const auto& [name, path] : real_files()) sets.push_back({name, kAll});
  return sets;
}

Places make_places(const SetOfSites& set) {
  if (synthetic(set)) {
    Random random(7);
    return maker_of(set.name)(set.count, random);
  }
  Places places;
  for (const Point3& p : read_terrain(set)) places.push_back({p.x, p.y});
  return places;
}

std::vector<Point3> make_terrain(const SetOfSites& set) {
  if (synthetic(set)) return raised(make_places(set), parts_of_elevation(set.name));
  return read_terrain(set);
}

std::span<const Point2> places(const SetOfSites& set) {
  static std::map<std::string, Places> kept;
  const auto found = kept.find(set.label());
  return found != kept.end() ? found->second : kept.emplace(set.label(), make_places(set)).first->second;
}

std::span<const Point3> terrain(const SetOfSites& set) {
  static std::map<std::string, std::vector<Point3>> kept;
  const auto found = kept.find(set.label());
  return found != kept.end() ? found->second : kept.emplace(set.label(), make_terrain(set)).first->second;
}

}  // namespace bench
