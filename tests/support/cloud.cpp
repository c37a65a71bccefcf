/// Generators of degenerate point sets.
#include "support/cloud.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace support {
namespace {

using thalweg::Point2;
using thalweg::Point3;

/// Integers of [low, high], whatever the size parameter.
rc::Gen<int> integers(int low, int high) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high + 1));
}

Point2 whole(int x, int y) {
  return {static_cast<double>(x), static_cast<double>(y)};
}

rc::Gen<Point2> in_box(int width, int height) {
  return rc::gen::map(rc::gen::tuple(integers(0, width), integers(0, height)),
                      [](const std::tuple<int, int>& p) { return whole(std::get<0>(p), std::get<1>(p)); });
}

/// Points of the circle about the origin, moved by up to `miss` units.
rc::Gen<Point2> near_circle(int radius, int miss) {
  static std::map<int, std::vector<Point2>> circles;  // finding them takes longer than a test case
  std::vector<Point2>& circle = circles[radius];
  if (circle.empty()) circle = integer_circle(radius);
  return rc::gen::map(rc::gen::tuple(integers(0, static_cast<int>(circle.size()) - 1), integers(-miss, miss),
                                     integers(-miss, miss)),
                      [&circle](const std::tuple<int, int, int>& p) {
                        const Point2 c = circle[static_cast<std::size_t>(std::get<0>(p))];
                        return Point2{c.x + std::get<1>(p), c.y + std::get<2>(p)};
                      });
}

/// Points of the line (2 t, t).
rc::Gen<Point2> on_line(int length) {
  return rc::gen::map(integers(0, length), [](int t) { return whole(2 * t, t); });
}

/// Points of a long line, moved by up to one unit: triangles and circles as flat as integers make them.
rc::Gen<Point2> near_line(int length) {
  return rc::gen::map(rc::gen::tuple(integers(0, length), integers(-1, 1), integers(-1, 1)),
                      [](const std::tuple<int, int, int>& p) {
                        const int t = std::get<0>(p);
                        return whole(8191 * t + std::get<1>(p), 4095 * t + std::get<2>(p));
                      });
}

rc::Gen<Cloud> cloud_of(int most, rc::Gen<Point2> place, int highest) {
  auto point = rc::gen::map(rc::gen::tuple(std::move(place), integers(0, highest)),
                            [](const std::tuple<Point2, int>& p) {
                              const Point2 q = std::get<0>(p);
                              return Point3{q.x, q.y, static_cast<double>(std::get<1>(p))};
                            });
  return rc::gen::map(rc::gen::resize(most, rc::gen::container<std::vector<Point3>>(std::move(point))),
                      make_cloud);
}

bool turns(const Point3& a, const Point3& b, const Point3& c) {
  return (b.x - a.x) * (c.y - a.y) != (b.y - a.y) * (c.x - a.x);
}

}  // namespace

std::vector<Point2> Cloud::places() const {
  std::vector<Point2> result;
  for (const Point3& p : points) result.push_back({p.x, p.y});
  return result;
}

std::vector<double> Cloud::elevations() const {
  std::vector<double> result;
  for (const Point3& p : points) result.push_back(p.z);
  return result;
}

void showValue(const Cloud& cloud, std::ostream& out) {
  const auto number = [](double value) {
    char text[64];
    const bool small = value == std::floor(value) && std::fabs(value) < 1e15;
    std::snprintf(text, sizeof text, small ? "%.0f" : "%a", value);
    return std::string(text);
  };
  out << "const std::vector<thalweg::Point3> points = {";
  const char* separator = "";
  for (const Point3& p : cloud.points) {
    out << separator << "{" << number(p.x) << ", " << number(p.y) << ", " << number(p.z) << "}";
    separator = ", ";
  }
  out << "};";
}

Cloud make_cloud(std::vector<Point3> points) {
  Cloud result;
  std::set<std::pair<double, double>> seen;
  const auto add = [&](Point3 p) {
    if (seen.emplace(p.x, p.y).second) result.points.push_back(p);
  };
  for (const Point3& p : points) add(p);
  const auto collinear = [&] {
    const auto& s = result.points;
    return std::none_of(s.begin(), s.end(), [&](const Point3& p) { return turns(s[0], s[1], p); });
  };
  for (const Point3& p : {Point3{0, 0, 1}, Point3{1, 0, 0}, Point3{0, 1, 2}}) {
    if (result.points.size() < 3 || collinear()) add(p);
  }
  return result;
}

rc::Gen<Cloud> clouds(int most) {
  return rc::gen::oneOf(
      cloud_of(most, in_box(1000, 1000), 1000), cloud_of(most, in_box(6, 6), 30),
      cloud_of(most, in_box(4, 4), 3), cloud_of(most, in_box(40, 2), 6), cloud_of(most, in_box(30, 30), 3),
      cloud_of(most, near_circle(25, 0), 12), cloud_of(most, near_circle(32045, 1), 20),
      cloud_of(most, near_line(20), 9),
      cloud_of(most, rc::gen::oneOf(near_circle(65, 0), near_circle(65, 1), in_box(40, 40)), 5),
      cloud_of(most, rc::gen::oneOf(near_circle(25, 0), near_circle(5, 0), in_box(3, 3)), 40),
      cloud_of(most, rc::gen::oneOf(on_line(10), in_box(20, 10)), 8),
      cloud_of(most,
               rc::gen::oneOf(on_line(6), rc::gen::map(on_line(6),
                                                       [](Point2 p) {
                                                         return Point2{p.x, p.y + 3};
                                                       })),
               4));
}

std::vector<Point2> integer_circle(int radius) {
  std::vector<Point2> result;
  for (int x = -radius; x <= radius; ++x) {
    const int rest = radius * radius - x * x;
    const int y = static_cast<int>(std::lround(std::sqrt(static_cast<double>(rest))));
    if (y * y != rest) continue;
    result.push_back(whole(x, y));
    if (y != 0) result.push_back(whole(x, -y));
  }
  std::sort(result.begin(), result.end(), [](Point2 a, Point2 b) {
    const bool lower_a = a.y < 0, lower_b = b.y < 0;
    if (lower_a != lower_b) return lower_b;
    return lower_a ? a.x < b.x : a.x > b.x;
  });
  return result;
}

Cloud scaled(const Cloud& cloud, int exponent) {
  Cloud result = cloud;
  for (Point3& p : result.points) {
    p.x = std::ldexp(p.x, exponent);
    p.y = std::ldexp(p.y, exponent);
  }
  return result;
}

std::vector<std::uint32_t> permutation(std::uint32_t size, std::uint64_t seed) {
  std::vector<std::uint32_t> order(size);
  std::iota(order.begin(), order.end(), 0u);
  for (std::uint32_t i = size; i > 1; --i) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    std::swap(order[i - 1], order[(seed >> 33) % i]);
  }
  return order;
}

Cloud permuted(const Cloud& cloud, std::span<const std::uint32_t> order) {
  Cloud result = cloud;
  for (std::size_t i = 0; i < order.size(); ++i) result.points[order[i]] = cloud.points[i];
  return result;
}

}  // namespace support
