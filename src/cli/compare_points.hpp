/// Whether the vertices of a mesh are the points of a file, bit for bit.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "thalweg/point.hpp"

namespace thalweg::cli {

struct PointDifferences {
  std::uint64_t sites = 0;    ///< distinct (x, y) in the file
  std::uint64_t missing = 0;  ///< of them, those where the mesh has no vertex
  std::uint64_t foreign = 0;  ///< vertices at no place of the file, or second at one
  std::uint64_t changed = 0;  ///< vertices at a place of the file with an elevation, or bits, of no row there
  std::vector<std::string> examples;  ///< the first few, in words

  bool none() const noexcept { return missing == 0 && foreign == 0 && changed == 0; }
};

/// How `vertices` differ from `rows`: each place (x, y) of the file must have exactly one vertex, whose
/// coordinates are bit for bit those of one row there. Complexity: O(n log n).
PointDifferences compare_points(std::span<const Point3> vertices, std::span<const Point3> rows);

}  // namespace thalweg::cli
