/// Which exits cross each other.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "terrain/units.hpp"

namespace thalweg::detail {

/// For each exit the exits that it cannot share a triangulation with: those that it crosses properly, and the
/// same pair taken from the other end (one edge drains one unit).
class Crossings {
 public:
  /// Exact. Complexity: O(m log m) for the m faces of all sleeves together and the pairs of exits that share
  /// one.
  Crossings(const Surface& surface, std::span<const UnitExit> exits);

  /// Adds further pairs of exits that are not to be chosen together.
  void add(std::span<const std::pair<std::uint32_t, std::uint32_t>> pairs);

  std::span<const std::uint32_t> of(std::uint32_t exit) const noexcept {
    return std::span(others_).subspan(starts_[exit], starts_[exit + 1] - starts_[exit]);
  }

 private:
  void pack();

  std::size_t count_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;  // each in both directions, sorted
  std::vector<std::uint32_t> starts_, others_;
};

/// Pairs of exits (i < j, sorted) whose sleeves share a Delaunay triangle; the sleeve of a Delaunay edge
/// being the faces on its sides. Exits that cross are among them: where they cross, both pass the same
/// triangle, or one is the side by which the other enters it.
std::vector<std::pair<std::uint32_t, std::uint32_t>> meeting_pairs(const Surface& surface,
                                                                   std::span<const UnitExit> exits);

/// Whether the open segments ab and cd cross at a point that is an end of neither. Exact.
bool cross_properly(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;

}  // namespace thalweg::detail
