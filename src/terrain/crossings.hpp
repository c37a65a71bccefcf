/// Which exits cross each other.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "terrain/units.hpp"

namespace thalweg::detail {

using ExitPair = std::pair<std::uint32_t, std::uint32_t>;

/// Pairs of exits (i < j, sorted) whose sleeves share a Delaunay triangle; the sleeve of a Delaunay edge
/// being the faces on its sides. Exits that cross are among them: where they cross, both pass the same
/// triangle, or one is the side by which the other enters it. Nothing if there would be more than tens of
/// millions: as many chords as a large cocircular face can have.
std::optional<std::vector<ExitPair>> meeting_pairs(const Surface& surface, std::span<const UnitExit> exits);

/// For each exit the exits that it cannot share a triangulation with: those that it crosses properly, and the
/// same pair taken from the other end (one edge drains one unit).
class Crossings {
 public:
  /// Exact. Complexity: O(m log m) for the m faces of all sleeves together and the pairs of exits that share
  /// one.
  Crossings(const Surface& surface, std::span<const UnitExit> exits);

  /// False if there were too many pairs to look at; then none is held.
  bool complete() const noexcept { return complete_; }

  /// Adds further pairs of exits that are not to be chosen together.
  void add(std::span<const ExitPair> pairs);

  std::span<const std::uint32_t> of(std::uint32_t exit) const noexcept {
    return std::span(others_).subspan(starts_[exit], starts_[exit + 1] - starts_[exit]);
  }

 private:
  void pack();

  std::size_t count_;
  bool complete_ = false;
  std::vector<ExitPair> pairs_;  // each in both directions, sorted
  std::vector<std::uint32_t> starts_, others_;
};

/// Whether the open segments ab and cd cross at a point that is an end of neither. Exact.
bool cross_properly(Point2 a, Point2 b, Point2 c, Point2 d) noexcept;

}  // namespace thalweg::detail
