/// Pits: the local minima of a terrain, made safe for flats.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/export.hpp"
#include "thalweg/triangulation.hpp"

namespace thalweg {

/// Numbers of pits. Laws: total == interior + boundary.
struct PitCount {
  std::uint32_t total = 0;     ///< all pits
  std::uint32_t interior = 0;  ///< pits without a vertex on the convex hull
  std::uint32_t boundary = 0;  ///< pits with a vertex on the convex hull
  /// Whether all three are equal.
  friend bool operator==(const PitCount&, const PitCount&) = default;
};

/// The pits of a terrain: maximal sets of vertices of equal z joined by edges, none of which has a strictly
/// lower neighbour. A lake is one pit; a flat shelf that drains is none.
class THALWEG_EXPORT Pits {
 public:
  /// The number of pits.
  std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(boundary_.size()); }
  /// The vertices of pit i, ascending. Requires: i < size().
  std::span<const VertexId> operator[](std::uint32_t i) const noexcept {
    return std::span(vertices_).subspan(starts_[i], starts_[i + 1] - starts_[i]);
  }
  /// Whether pit i touches the convex hull. Requires: i < size().
  bool boundary(std::uint32_t i) const noexcept { return boundary_[i] != 0; }
  /// How many there are of each kind. Complexity: O(size()).
  PitCount count() const noexcept;

  /// Appends a pit, number size(). Requires: vertices ascending, not empty. Invalidates: spans of vertices.
  /// std::bad_alloc leaves all as it was.
  void add(std::span<const VertexId> vertices, bool boundary);

 private:
  std::vector<VertexId> vertices_;
  std::vector<std::uint32_t> starts_ = {0};
  std::vector<std::uint8_t> boundary_;
};

/// The pits of `terrain` with elevation z[v] at vertex v, ordered by their first vertex. Isolated vertices
/// are no part of the terrain. Requires: z.size() == vertex_count(). Complexity: O(n). Source: the paper's
/// local minimum (de Kok, van Kreveld, Loeffler, section 1), taken of whole flats.
THALWEG_EXPORT Pits find_pits(const Triangulation& terrain, std::span<const double> z);

}  // namespace thalweg
