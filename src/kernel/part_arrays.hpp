/// The sites, and the arrays of a GhostedTriangulation while its parts are built and merged.
#pragma once

#include <cstdint>

#include "kernel/ghosted_triangulation.hpp"
#include "thalweg/point.hpp"

namespace thalweg::detail {

/// Views of the arrays, and steps in them. Sites [lo, hi) of a part are in slots [2 lo, 2 hi - 2).
struct PartArrays {
  using Index = std::uint32_t;

  const Point2* sites;
  Index* origins;
  Index* twins;

  Point2 at(Index v) const noexcept { return sites[v]; }

  Index origin(Index h) const noexcept { return origins[h]; }
  Index dest(Index h) const noexcept { return origins[next_of(h)]; }
  Index apex(Index h) const noexcept { return origins[prev_of(h)]; }
  Index twin(Index h) const noexcept { return twins[h]; }
  /// The half-edge after h, counter-clockwise, of all that leave its origin.
  Index around(Index h) const noexcept { return twins[prev_of(h)]; }

  /// For the ghost half-edge of a hull edge: that of the edge after it, or before it, counter-clockwise along
  /// the hull.
  Index hull_next(Index h) const noexcept { return prev_of(twins[prev_of(h)]); }
  Index hull_prev(Index h) const noexcept { return next_of(twins[next_of(h)]); }

  void link(Index h, Index g) const noexcept {
    twins[h] = g;
    twins[g] = h;
  }
  void set_corners(Index slot, Index a, Index b, Index c) const noexcept {
    origins[4 * slot] = a;
    origins[4 * slot + 1] = b;
    origins[4 * slot + 2] = c;
  }
};

}  // namespace thalweg::detail
