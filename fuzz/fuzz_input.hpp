/// What every fuzz target needs: points out of raw bytes, and a check that prints them as C++ before it
/// aborts.
///
/// Bytes that begin with # are text, as the files of tests/corpus are: numbers are taken from the characters
/// of the first line, points from the rows after it. So those files are seeds of every target.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "thalweg/point.hpp"

namespace fuzz {

/// Takes numbers off the front of the bytes; zeros when they have run out.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : rest_(data, size), text_(size > 0 && data[0] == '#') {}

  bool empty() const { return rest_.empty(); }
  bool is_text() const { return text_; }

  std::uint8_t byte() {
    if (rest_.empty()) return 0;
    const std::uint8_t value = rest_.front();
    rest_ = rest_.subspan(1);
    return value;
  }

  /// Any double at all, NaN and infinities included; little-endian, so that a corpus means the same
  /// everywhere.
  double number() {
    std::uint64_t bits = 0;
    for (int shift = 0; shift < 64; shift += 8) bits |= std::uint64_t{byte()} << shift;
    return std::bit_cast<double>(bits);
  }

  /// Text only: all characters up to the end of the line, which goes too.
  std::string line() {
    std::string result;
    while (!rest_.empty()) {
      const char c = static_cast<char>(byte());
      if (c == '\n') break;
      result += c;
    }
    return result;
  }

 private:
  std::span<const std::uint8_t> rest_;
  bool text_;
};

/// Numbers of a row of text; NaN for each that is missing.
inline thalweg::Point3 parse_row(const std::string& row) {
  thalweg::Point3 p;
  const char* at = row.c_str();
  for (double* value : {&p.x, &p.y, &p.z}) {
    char* end = nullptr;
    *value = std::strtod(at, &end);
    if (end == at) *value = std::numeric_limits<double>::quiet_NaN();
    at = end;
  }
  return p;
}

/// Which points an input holds, and how many at most: its first byte says.
///
///     grid     a byte a place, on a 16 x 16 grid: duplicates, collinear runs, cocircular sites all the time
///     nudged   one more byte, which moves the place by 0..3 units in the last place each way; beside 0 that
///              means by the least denormals
///     wide     two bytes a coordinate, whole numbers: general position
///     raw      eight bytes a coordinate, any double: every exponent, denormals, NaN
///
/// Most mistakes show with 3..12 points, and those are quick; 0 and 1 alone allow as many as the target
/// takes.
class Domain {
 public:
  Domain(std::uint8_t choice, std::size_t most)
      : kind_(kKinds[choice % 16]),
        limit_(choice < 2 ? most
                          : std::min<std::size_t>(most, 3 + choice / 16 % (kind_ == Kind::raw ? 4 : 10))) {}

  std::size_t limit() const { return limit_; }

  thalweg::Point2 place(Input& input) const {
    if (kind_ == Kind::grid || kind_ == Kind::nudged) {
      const std::uint8_t cell = input.byte(), steps = kind_ == Kind::nudged ? input.byte() : std::uint8_t{0};
      return {nudged(cell % 16, steps % 4), nudged(cell / 16, steps / 4 % 4)};
    }
    const double x = coordinate(input);
    return {x, coordinate(input)};
  }

  double elevation(Input& input) const {
    return kind_ == Kind::raw ? input.number() : static_cast<double>(input.byte() % 16);
  }

 private:
  enum class Kind { grid, nudged, wide, raw };
  // Raw doubles are rare, because slow: hardly a sign of theirs is found but by the longest integers.
  static constexpr Kind kKinds[16] = {
      Kind::grid, Kind::raw,    Kind::grid, Kind::wide,   Kind::grid, Kind::wide, Kind::grid,   Kind::wide,
      Kind::grid, Kind::nudged, Kind::grid, Kind::nudged, Kind::grid, Kind::wide, Kind::nudged, Kind::nudged};

  double coordinate(Input& input) const {
    if (kind_ == Kind::raw) return input.number();
    const int high = input.byte();
    return 256 * high + input.byte() - 32768;
  }

  /// The value a few units in its last place further.
  static double nudged(double value, int steps) {
    for (; steps > 0; --steps) value = std::nextafter(value, 16);
    return value;
  }

  Kind kind_;
  std::size_t limit_;
};

/// At most `most` points with elevations, as the first byte says or from the rows of a text. But for raw
/// doubles there are 16 elevations: flats.
inline std::vector<thalweg::Point3> take_terrain(Input& input, std::size_t most) {
  std::vector<thalweg::Point3> points;
  if (input.is_text()) {
    input.line();
    while (!input.empty() && points.size() < most) points.push_back(parse_row(input.line()));
    return points;
  }
  const Domain domain(input.byte(), most);
  while (!input.empty() && points.size() < domain.limit()) {
    const thalweg::Point2 p = domain.place(input);
    points.push_back({p.x, p.y, domain.elevation(input)});
  }
  return points;
}

/// The same without elevations.
inline std::vector<thalweg::Point2> take_points(Input& input, std::size_t most) {
  std::vector<thalweg::Point2> points;
  if (input.is_text()) {
    for (const thalweg::Point3& p : take_terrain(input, most)) points.push_back({p.x, p.y});
    return points;
  }
  const Domain domain(input.byte(), most);
  while (!input.empty() && points.size() < domain.limit()) points.push_back(domain.place(input));
  return points;
}

inline bool all_finite(std::span<const thalweg::Point2> points) {
  return std::all_of(points.begin(), points.end(),
                     [](thalweg::Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}

/// Aborts, with the points as C++ source for a regression test, unless `holds`.
inline void check(bool holds, const char* law, std::span<const thalweg::Point2> points) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\nconst std::vector<Point2> sites = {", law);
  for (const thalweg::Point2 p : points) std::fprintf(stderr, "{%a, %a}, ", p.x, p.y);
  std::fprintf(stderr, "};\n");
  std::abort();
}

}  // namespace fuzz
