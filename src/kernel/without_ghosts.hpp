/// The way back from slots to packed arrays.
#pragma once

#include <cstdint>
#include <span>

#include "kernel/ghosted_triangulation.hpp"
#include "thalweg/result.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

/// What sites are called as vertices.
struct VertexNames {
  std::span<const std::uint32_t> of_site;  ///< distinct numbers below `count`; empty: their own
  std::uint32_t count = 0;                 ///< of vertices; those without a name are isolated
};

/// The triangles alone; all_collinear if there are none.
/// Laws: the arrays do not depend on `threads`.
/// Complexity: O(n); 5 bytes a site and 4 an edge of the hull beside those of `mesh`, a quarter of which is
/// given back; with names 4 more a vertex.
Result<Triangulation> without_ghosts(GhostedTriangulation mesh, const VertexNames& names, unsigned threads);

}  // namespace thalweg::detail
