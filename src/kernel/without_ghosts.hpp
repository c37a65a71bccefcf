/// The way back from slots to packed arrays.
#pragma once

#include "kernel/ghosted_triangulation.hpp"
#include "thalweg/result.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

/// The triangles alone; all_collinear if there are none.
/// Laws: the arrays do not depend on `threads`.
/// Complexity: O(n); 28 bytes a site, one more on several threads, and 4 an edge of the hull, beside those of
/// `mesh`, which are given back on the way.
Result<Triangulation> without_ghosts(GhostedTriangulation mesh, unsigned threads);

}  // namespace thalweg::detail
