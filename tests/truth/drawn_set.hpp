/// Random sets of 5 to 11 sites on which to hold the library to an enumeration of all triangulations.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "oracle/enumeration.hpp"
#include "support/cloud.hpp"

namespace support {

/// How sets are drawn; the kinds take turns.
enum class SetKind : std::uint8_t {
  general,         ///< a square of side 1000
  grid5,           ///< a 5 x 5 grid: cocircular sites, collinear hulls
  grid7,           ///< a 7 x 7 grid
  flats,           ///< a square of side 31, four elevations
  circle,          ///< integer points of a circle, and some inside
  collinear_hull,  ///< on the sides of a rectangle or triangle, and some inside
  strip,           ///< 1000 by 2 to 5: slivers, circles that are almost lines
  conflict,        ///< places as in one of the others; two edges that exclude each other are wanted
  trap             ///< known traps, disturbed
};
inline constexpr std::uint32_t kSetKinds = 9;

const char* set_kind_name(SetKind kind) noexcept;

struct DrawnSet {
  SetKind kind;
  Cloud cloud;
  std::shared_ptr<const oracle::Enumeration> enumeration;
};

/// Kinds that are made to be hard.
constexpr bool is_adversarial(SetKind kind) noexcept {
  return kind == SetKind::conflict || kind == SetKind::trap;
}

/// Set number `index` of the sequence that `seed` starts; depends on these two alone.
///
/// A conflict: two pairs that do not cross and that no triangulation of an order holds together which holds
/// each alone. Elevations are drawn so that either pair is the way down of one of its ends, all other sites
/// being higher, then disturbed. A trap: choosing ways down that do not cross, without regard to the order of
/// triangles, gives fewer pits than any triangulation of the order has. Of several draws the first that is a
/// trap is taken; since few conflicts make one, those found by a long search are kept and drawn from too.
DrawnSet draw_set(std::uint64_t seed, std::uint64_t index);

/// The set as C++ to paste.
std::string printed(const Cloud& cloud);

/// The number that an environment variable holds, or another if it is not set.
std::uint64_t from_environment(const char* name, std::uint64_t otherwise);

/// Entry k: the fewest pits that edges of useful order at most k have in any triangulation, whatever its
/// order.
std::vector<unsigned> fewest_pits_regardless(const oracle::Enumeration& enumeration,
                                             const oracle::Relief& relief);

}  // namespace support
