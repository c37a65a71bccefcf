/// From the places of a terrain to those of a picture: any finite doubles, y down.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "thalweg/point.hpp"

namespace thalweg::io {

/// Fits the points into a square of side `size`, keeping their shape. Differences are taken of halves: those
/// of the doubles themselves may be beyond all doubles.
class MapFrame {
 public:
  MapFrame(std::span<const Point3> points, double size) : size_(size) {
    if (points.empty()) return;
    low_ = high_ = points[0];
    for (const Point3& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
    }
    half_ = std::max(0.5 * high_.x - 0.5 * low_.x, 0.5 * high_.y - 0.5 * low_.y);
  }

  Point2 place(const Point3& p) const {
    return {fraction(p.x, low_.x) * size_, fraction(high_.y, p.y) * size_};
  }
  double width() const { return fraction(high_.x, low_.x) * size_; }
  double height() const { return fraction(high_.y, low_.y) * size_; }
  /// Where z lies between the lowest and the highest, in [0, 1]; in the middle if all are one.
  double level(double z) const {
    const double range = 0.5 * high_.z - 0.5 * low_.z;
    return range > 0 ? (0.5 * z - 0.5 * low_.z) / range : 0.5;
  }
  /// What one unit of the picture is long in the terrain; infinite beyond all doubles.
  double units() const { return 2 * (half_ / size_); }
  const Point3& low() const { return low_; }
  const Point3& high() const { return high_; }

 private:
  double fraction(double value, double low) const {
    return half_ > 0 ? (0.5 * value - 0.5 * low) / half_ : 0.5;
  }

  Point3 low_, high_;
  double half_ = 0;
  double size_;
};

/// The largest of 1, 2, 5 times a power of ten that is not above `most`. Requires: most > 0, finite.
inline double round_length(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= most) return factor * power;
  }
  return power;
}

}  // namespace thalweg::io
