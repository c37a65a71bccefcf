/// A triangulation that is still growing: triangles, and ghosts around them.
#pragma once

#include <cstdint>

#include "thalweg/array.hpp"

namespace thalweg::detail {

/// A triangulated sphere: the triangles of the plane, and a ghost for each edge of the hull, whose third
/// vertex is kGhost.
///
/// Half-edge 4t+i (i < 3) of slot t runs from its i-th to its next corner. m sites make 2m - 2 triangles,
/// ghosts included; if all sites are collinear there are ghosts only. Triangles are in slots near twice the
/// numbers of their sites, most of them.
struct GhostedTriangulation {
  Array<std::uint32_t> origin;
  Array<std::uint32_t> twin;
};

inline constexpr std::uint32_t kGhost = 0xffffffffu;

constexpr std::uint32_t next_of(std::uint32_t h) noexcept {
  return (h & 2) != 0 ? h - 2 : h + 1;
}
constexpr std::uint32_t prev_of(std::uint32_t h) noexcept {
  return (h & 3) == 0 ? h + 2 : h - 1;
}

}  // namespace thalweg::detail
