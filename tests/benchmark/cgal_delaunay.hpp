/// CGAL's Delaunay triangulation, kept out of the other translation units: its headers take long and warn.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "thalweg/point.hpp"

namespace peers {

/// Points as CGAL holds them, so that conversion is not part of what is measured.
class CgalPoints {
 public:
  explicit CgalPoints(std::span<const thalweg::Point2> points);

  /// Triangulates with exact predicates, spatial sort included.
  std::size_t face_count() const;

 private:
  struct Points;
  std::shared_ptr<const Points> points_;
};

}  // namespace peers
