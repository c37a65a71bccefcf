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

/// At most `limit` points in one of two domains, chosen by the first byte, or from the rows of a text.
/// Even: two bytes a point, on a 16 x 16 grid with 16 elevations: duplicates, collinear runs, cocircular
/// sites and flats all the time. Odd: 24 bytes a point, raw doubles: every exponent, denormals, NaN.
inline std::vector<thalweg::Point3> take_terrain(Input& input, std::size_t limit) {
  std::vector<thalweg::Point3> points;
  if (input.is_text()) {
    input.line();
    while (!input.empty() && points.size() < limit) points.push_back(parse_row(input.line()));
    return points;
  }
  const bool raw = input.byte() % 2 == 1;
  while (!input.empty() && points.size() < limit) {
    if (raw) {
      const double x = input.number(), y = input.number();
      points.push_back({x, y, input.number()});
    } else {
      const std::uint8_t cell = input.byte();
      points.push_back({static_cast<double>(cell % 16), static_cast<double>(cell / 16),
                        static_cast<double>(input.byte() % 16)});
    }
  }
  return points;
}

/// The same without elevations: a byte a point on the grid, 16 bytes as raw doubles.
inline std::vector<thalweg::Point2> take_points(Input& input, std::size_t limit) {
  std::vector<thalweg::Point2> points;
  if (input.is_text()) {
    for (const thalweg::Point3& p : take_terrain(input, limit)) points.push_back({p.x, p.y});
    return points;
  }
  const bool raw = input.byte() % 2 == 1;
  while (!input.empty() && points.size() < limit) {
    if (raw) {
      const double x = input.number();
      points.push_back({x, input.number()});
    } else {
      const std::uint8_t cell = input.byte();
      points.push_back({static_cast<double>(cell % 16), static_cast<double>(cell / 16)});
    }
  }
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
