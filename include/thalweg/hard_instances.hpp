/// The paper's proofs of hardness as instances: terrains on which pits are as hard to minimise as it gets.
///
/// From n segments a terrain is built in which a pit can be removed only by an edge along its own segment.
/// The fewest pits of any triangulation are then
///
///     2n - (the largest number of segments no two of which cross),
///
/// which is NP-hard to compute. Source: de Kok, van Kreveld, Loeffler, Theorem 1 and Corollary 2. Departures:
///
/// - The paper says that an endpoint of elevation 2 "is a local minimum if and only if the segment ... is in
///   the triangulation". It is one if and only if the segment is NOT: along the segment it drains to its
///   partner of elevation 1. The largest set of segments corresponds to the ends of elevation 2 that drain.
/// - Shields need not lie on the circle of radius eps / 3, whose points are irrational, but within it and on
///   no segment; see src/terrain/shields.hpp.
/// - Corollary 2 with a shield at both ends of a pair has triples (p, shield, shield) that were collinear and
///   that no guard watches. Here a pair has one shield, and then |H| = 2n (n - 1), k = |P| + |H| = 2n^2, and
///   the points are 2n^2 + 2n (n - 1)(2n^2 + 1): of the order of n^4, well within the paper's O(n^8). The
///   proof is in src/terrain/guarded_instance.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "thalweg/export.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg {

/// A place with whole coordinates, so that what is collinear with it can be computed exactly.
struct LatticePoint {
  std::int64_t x = 0;  ///< any unit, the same as y
  std::int64_t y = 0;  ///< any unit, the same as x
  /// Whether it is the same place.
  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

/// A segment between two such places.
struct LatticeSegment {
  LatticePoint a;  ///< the end that gets elevation 1
  LatticePoint b;  ///< the end that gets elevation 2
  /// Whether it is the same segment in the same direction.
  friend bool operator==(const LatticeSegment&, const LatticeSegment&) = default;
};

/// A terrain made from segments.
struct HardInstance {
  /// Points 2i and 2i + 1 are the ends a and b of segment i, at elevations 1 and 2; after them the shields,
  /// then the guards, all at elevation 3. All coordinates are integers below 2^53 in magnitude.
  std::vector<Point3> points;
  std::uint32_t segments = 0;  ///< n: how many segments were given
  std::uint32_t shields = 0;   ///< how many of the points are shields
  std::uint32_t guards = 0;    ///< how many of the points are guards: Corollary 2 only
  /// The order k for which the minimum is as said: Theorem 1: so large that every triangulation is of order k
  /// (points - 3); Corollary 2: |P| + |H|.
  unsigned order = 0;
  /// Input coordinates times this are those of the ends, exactly.
  std::int64_t scale = 1;
};

/// The most segments that `theorem1_instance` takes: 16.8 million points.
inline constexpr std::uint32_t kMostTheorem1Segments = 2048;
/// The most segments that `corollary2_instance` takes: 14,576 points. More rarely fit into 2^53.
inline constexpr std::uint32_t kMostCorollary2Segments = 8;

/// The degenerate instance: shields lie exactly on the segments between ends that are not partners. Laws:
/// over all triangulations the minimum of pits is 2n - (maximum set of non-crossing segments); every end of
/// elevation 1 is a pit in every triangulation, no shield ever is. Has 2n (2n - 2) shields if no three ends
/// are collinear; pairs of ends with another end between them need none. Exact. Errors: invalid_argument,
/// with the segments to blame as rows, for fewer than 2 or more than kMostTheorem1Segments, a coordinate
/// beyond 2^29, a segment that is a point, two ends at one place, an end on another segment, and coordinates
/// that would not fit into 2^53; all_collinear. Complexity: O(n^2 log n).
THALWEG_EXPORT Result<HardInstance> theorem1_instance(std::span<const LatticeSegment> segments);

/// The instance in general position, for triangulations of order at most `order`. Laws: over all
/// triangulations of order <= `order` the minimum of pits is 2n - (maximum set of non-crossing segments); no
/// three ends or shields are collinear. Errors: as theorem1_instance, with at most kMostCorollary2Segments,
/// and invalid_argument if three ends are collinear, or if the points would not fit into 2^53. Complexity:
/// O(n^6) a try, below half a second at n = 8.
THALWEG_EXPORT Result<HardInstance> corollary2_instance(std::span<const LatticeSegment> segments);

}  // namespace thalweg
