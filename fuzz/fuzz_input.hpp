/// What every fuzz target needs: points out of raw bytes, and a check that prints them as C++ before it
/// aborts.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <vector>

#include "thalweg/point.hpp"

namespace fuzz {

/// Takes numbers off the front of the bytes; zeros when they have run out.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

  bool empty() const { return rest_.empty(); }

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

 private:
  std::span<const std::uint8_t> rest_;
};

/// At most `limit` points in one of two domains, chosen by the first byte.
/// Even: a byte a point, on a 16 x 16 grid: duplicates, collinear runs and cocircular sites all the time.
/// Odd: 16 bytes a point, raw doubles: every exponent, denormals, NaN.
inline std::vector<thalweg::Point2> take_points(Input& input, std::size_t limit) {
  const bool raw = input.byte() % 2 == 1;
  std::vector<thalweg::Point2> points;
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

/// Aborts, with the points as C++ source for a regression test, unless `holds`.
inline void check(bool holds, const char* law, std::span<const thalweg::Point2> points) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\nconst std::vector<Point2> sites = {", law);
  for (const thalweg::Point2 p : points) std::fprintf(stderr, "{%a, %a}, ", p.x, p.y);
  std::fprintf(stderr, "};\n");
  std::abort();
}

}  // namespace fuzz
