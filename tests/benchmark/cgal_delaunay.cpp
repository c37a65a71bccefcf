/// CGAL as a peer to be compared with.
#include "benchmark/cgal_delaunay.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace peers {

std::size_t cgal_face_count(std::span<const thalweg::Point2> points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> copies;
  copies.reserve(points.size());
  for (const thalweg::Point2& p : points) copies.emplace_back(p.x, p.y);
  const CGAL::Delaunay_triangulation_2<Kernel> triangulation(copies.begin(), copies.end());
  return triangulation.number_of_faces();
}

}  // namespace peers
