/// Where the shields of the hardness proofs go: a point on the segment from p to q that keeps the two from
/// being joined, near enough to p to be on no other segment.
///
/// The paper takes the circle of radius eps / 3 around p, eps the least distance of two ends. Its points are
/// irrational. Here the shield is p + (q - p) / m with one m for all, and everything is scaled by m, so that
/// the shield m p + (q - p) is an integer point exactly on the segment. m is so large that
///   (1) |q - p| / m < eps / 3 for all p, q: the discs of different ends are disjoint, as in the paper;
///   (2) |q - p| / m < distance from p to every segment but its own: what the paper takes for granted.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "thalweg/hard_instances.hpp"

namespace thalweg::detail {

/// A shield next to end `from` on the way to end `to`. End 2i + s is end s of segment i.
struct Shield {
  std::uint32_t from;
  std::uint32_t to;
};

struct ShieldPlan {
  std::vector<LatticePoint> ends;
  std::int64_t scale = 1;       ///< m
  std::vector<Shield> shields;  ///< by `from`, then `to`

  /// m p + (q - p).
  LatticePoint place(const Shield& shield) const noexcept;
};

/// Whether a and b are the ends of one segment.
constexpr bool partners(std::uint32_t a, std::uint32_t b) noexcept {
  return (a ^ b) == 1;
}

/// Shields in both directions for every pair of ends that are not partners and have no end between them.
/// Laws (each needed by the proof in hard_instances.cpp): ends and shields are distinct; no shield and no
/// third end lies on a segment; between two ends that are not partners lies an end or a shield. Errors: as
/// theorem1_instance.
Result<ShieldPlan> plan_shields(std::span<const LatticeSegment> segments, std::uint32_t most);

/// The largest coordinate of an instance: up to it every integer is a double.
inline constexpr std::int64_t kMostExact = std::int64_t{1} << 53;

/// "segment 3 (from 0)": how errors name a segment.
std::string segment_name(std::uint32_t segment);

}  // namespace thalweg::detail
