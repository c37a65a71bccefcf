/// Constrained Delaunay triangulation of one side of an inserted edge, by splitting at the apex over the
/// base.
///
/// Over a base a -> b the apex is the chain vertex c whose circle with a and b holds no other chain vertex.
/// No chain edge e cuts the triangle abc: c sees a point m of the base (in the old triangulation an edge led
/// from c across it), and e meets neither the base nor the segment cm. To cut the triangle amc or mbc all the
/// same it would have to enter and leave by one side, or end inside, where no vertex is, the triangle being
/// inside the circle. The chain splits at c, and both parts see their new bases a -> c and c -> b, since
/// their segments to the old base cross them.
#include "kernel/polygon.hpp"

#include "kernel/assert.hpp"
#include "kernel/predicates_inline.hpp"

namespace thalweg::detail {
namespace {

/// A part of the chain, [begin, end), over its base.
struct ChainPart {
  VertexId from, to;
  std::size_t begin, end;
};

/// The position in the part of the vertex whose circle with the base is empty.
std::size_t apex_position(std::span<const Point2> sites, std::span<const VertexId> chain,
                          const ChainPart& part) {
  const Point2 a = sites[part.from.index()], b = sites[part.to.index()];
  std::size_t best = part.end;
  for (std::size_t i = part.begin; i < part.end; ++i) {
    const Point2 c = sites[chain[i].index()];
    if (best == part.end) {
      if (orient2d_sign(a, b, c) > 0) best = i;
    } else if (chain[i] != chain[best] && incircle_canonical(a, b, sites[chain[best].index()], c) > 0 &&
               orient2d_sign(a, b, c) > 0) {
      best = i;
    }
  }
  THALWEG_ASSERT(best != part.end);
  return best;
}

}  // namespace

void triangulate_polygon(std::span<const Point2> sites, VertexId from, VertexId to,
                         std::span<const VertexId> chain, std::vector<Triangle>& triangles) {
  std::vector<ChainPart> parts = {{from, to, 0, chain.size()}};
  while (!parts.empty()) {
    const ChainPart part = parts.back();
    parts.pop_back();
    if (part.begin == part.end) continue;
    const std::size_t at = apex_position(sites, chain, part);
    const VertexId c = chain[at];
    triangles.push_back({part.from, part.to, c});
    parts.push_back({part.from, c, part.begin, at});
    parts.push_back({c, part.to, at + 1, part.end});
  }
}

}  // namespace thalweg::detail
