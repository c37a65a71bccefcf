/// The front along which two parts grow together.
#pragma once

#include <cstdint>

#include "kernel/part_arrays.hpp"

namespace thalweg::detail {

/// The growing front between two parts. Its last edge, the base, runs from a on the left to b on the right,
/// and everything below it is final.
///
///          ghost                       a_next = origin(left), the next site up the hull of the left part
///     a_next    b_next                 left   = half-edge a_next -> a of a ghost
///        \ left  right /               right  = half-edge b -> b_next of a ghost
///         a -- base - b                below  = half-edge b -> a of the triangle below the base
///
/// The edges from a and from b to the ghost vertex have no twin in the arrays while the front is here. `left`
/// or `right` is kGhost where a part has nothing more to give.
struct Seam {
  std::uint32_t a, b;
  std::uint32_t left, right;
  std::uint32_t below;
};

/// The seam with its base raised to the upper common tangent, or to where `left` would become `last_left` and
/// `right` `last_right`: what is beyond these is not touched. Complexity: linear in the triangles that go or
/// come.
Seam risen_to(const PartArrays& mesh, const Seam& seam, std::uint32_t last_left,
              std::uint32_t last_right) noexcept;

/// Removes the triangle behind the hull edge of a ghost half-edge, `left` or `right` as above, as raising the
/// base does, but anywhere along the front: ghosts stay linked all around. The half-edge then belongs to the
/// upper of the two edges that come to light.
void open_left(const PartArrays& mesh, std::uint32_t left) noexcept;
void open_right(const PartArrays& mesh, std::uint32_t right) noexcept;

}  // namespace thalweg::detail
