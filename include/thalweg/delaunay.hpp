/// The canonical Delaunay triangulation.
#pragma once

#include <span>

#include "thalweg/export.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg {

/// How `delaunay` works.
struct DelaunayOptions {
  unsigned threads = 1;  ///< 0 = all of the machine; the result does not depend on it
};

/// The Delaunay triangulation of the distinct points among `sites`. Vertex ids are the indices of `sites`; of
/// equal points the first is a vertex and the others are isolated. Canonical: where more than three sites lie
/// on one empty circle, the diagonals are those of the symbolic perturbation that lifts a site above the
/// paraboloid the more, beyond all comparison, the larger it is lexicographically in (x, y). The set of
/// triangles depends on the set of coordinates alone. Exact. Errors: not_finite, too_few_points,
/// all_collinear, too_many_points, each with the rows to blame. Complexity: O(n log n), about 100 bytes a
/// site at the peak. Source: Lee and Schachter 1980, Guibas and Stolfi 1985, Dwyer 1987; ghost triangles as
/// in Shewchuk 1996.
THALWEG_EXPORT Result<Triangulation> delaunay(std::span<const Point2> sites,
                                              const DelaunayOptions& options = {});

}  // namespace thalweg
