/// CGAL as a peer to be compared with.
#include "benchmark/cgal_delaunay.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <utility>
#include <vector>

namespace peers {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct CgalPoints::Points {
  std::vector<Kernel::Point_2> all;
};

CgalPoints::CgalPoints(std::span<const thalweg::Point2> points) {
  Points copies;
  copies.all.reserve(points.size());
  for (const thalweg::Point2& p : points) copies.all.emplace_back(p.x, p.y);
  points_ = std::make_shared<const Points>(std::move(copies));
}

std::size_t CgalPoints::face_count() const {
  const CGAL::Delaunay_triangulation_2<Kernel> triangulation(points_->all.begin(), points_->all.end());
  return triangulation.number_of_faces();
}

}  // namespace peers
