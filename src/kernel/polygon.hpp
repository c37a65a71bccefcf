/// The constrained Delaunay triangulation of the polygon on one side of an inserted edge.
#pragma once

#include <span>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg::detail {

/// Appends to `triangles` the constrained Delaunay triangles of the polygon bounded by the edge from `from`
/// to `to` and, on its left, the chain of vertices that leads back, listed from `from` to `to` (both left
/// out): chain.size() counter-clockwise triangles. Degenerate: a chain may visit a vertex more than once (an
/// edge dangles into the polygon); cocircular vertices are joined canonically. Requires: the chain is a side
/// of a sleeve (sleeve.hpp): every vertex of it sees the edge. Exact. Complexity: O(m^2) incircle tests for m
/// chain vertices, O(m log m) when the splits are even; no recursion. Source: the divide and conquer of
/// Anglada 1997; why visibility need not be tested stands in polygon.cpp.
void triangulate_polygon(std::span<const Point2> sites, VertexId from, VertexId to,
                         std::span<const VertexId> chain, std::vector<Triangle>& triangles);

}  // namespace thalweg::detail
