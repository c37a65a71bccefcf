/// Keys along a Morton (Z) curve: a grid of 2^16 by 2^16 cells over a box, the bits of both axes in turn.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "thalweg/point.hpp"

namespace thalweg::detail {

/// Parallel to the axes.
struct BoundingBox {
  double low_x, high_x, low_y, high_y;

  void add(Point2 p) noexcept {
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
  }
};

/// The bounding box. Requires: there are points.
inline BoundingBox box_of(std::span<const Point2> points) noexcept {
  const auto [x, y] = points.front();
  BoundingBox box{x, x, y, y};
  for (const Point2 p : points) box.add(p);
  return box;
}

/// Where a coordinate lies in a box, as an integer of 16 bits.
///
/// cell = floor((x * shrink - corner) * grow * cells_per_unit). `shrink` is 1 unless the width of the box
/// would overflow, `grow` is 1 unless its reciprocal would: both are powers of two, so the result does not
/// change under exact scaling. Every step rounds monotonically.
struct MortonGrid {
  double shrink = 1;
  double grow = 1;
  double cells_per_unit = 0;
  double x0 = 0, y0 = 0;

  static constexpr double kCells = 65536;

  explicit MortonGrid(const BoundingBox& box) {
    const auto [low_x, high_x, low_y, high_y] = box;
    const double size = std::max({std::fabs(low_x), std::fabs(high_x), std::fabs(low_y), std::fabs(high_y)});
    if (size >= 0x1p1020) shrink = 0x1p-4;
    x0 = low_x * shrink;
    y0 = low_y * shrink;
    double width = std::max(high_x * shrink - x0, high_y * shrink - y0);
    if (width < 0x1p-500) grow = 0x1p600;
    width *= grow;
    if (width > 0) cells_per_unit = kCells / width;
  }

  std::uint32_t cell(double coordinate, double corner) const noexcept {
    const double scaled = (coordinate * shrink - corner) * grow * cells_per_unit;
    constexpr double kLast = kCells - 1;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled < kLast ? scaled : kLast));
  }

  /// The bits of both cells in turn, those of x first.
  std::uint32_t key(Point2 p) const noexcept {
    const std::uint64_t bits = spread(std::uint64_t{cell(p.x, x0)} << 32 | cell(p.y, y0));
    return static_cast<std::uint32_t>(bits >> 31 | bits);
  }

  /// Of each half, bit i of 16 to bit 2i.
  static std::uint64_t spread(std::uint64_t v) noexcept {
    v = (v | v << 8) & 0x00ff00ff'00ff00ffu;
    v = (v | v << 4) & 0x0f0f0f0f'0f0f0f0fu;
    v = (v | v << 2) & 0x33333333'33333333u;
    return (v | v << 1) & 0x55555555'55555555u;
  }
};

}  // namespace thalweg::detail
