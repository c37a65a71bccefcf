/// Points as the caller gives them. Any finite doubles are legal coordinates; nothing is ever rounded or
/// moved.
#pragma once

namespace thalweg {

/// A place in the plane. Units: the caller's, the same on both axes (metres, not degrees).
struct Point2 {
  double x = 0;  ///< to the right
  double y = 0;  ///< upwards, so that counter-clockwise means what it says
  /// Whether both coordinates are equal: 0.0 and -0.0 are, NaN is equal to nothing.
  friend bool operator==(const Point2&, const Point2&) = default;
};

/// A place in the plane with its elevation. Units of z are free: only comparisons of z are ever made.
struct Point3 {
  double x = 0;  ///< as of Point2
  double y = 0;  ///< as of Point2
  double z = 0;  ///< elevation, upwards
  /// Whether all three are equal.
  friend bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace thalweg
