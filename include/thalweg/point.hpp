/// Points as the caller gives them. Any finite doubles are legal coordinates; nothing is ever rounded or
/// moved.
#pragma once

namespace thalweg {

/// A place in the plane. Units: the caller's, the same on both axes (metres, not degrees).
struct Point2 {
  double x = 0;
  double y = 0;
  friend bool operator==(const Point2&, const Point2&) = default;
};

/// A place in the plane with its elevation. Units of z are free: only comparisons of z are ever made.
struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;
  friend bool operator==(const Point3&, const Point3&) = default;
};

}  // namespace thalweg
