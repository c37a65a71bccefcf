/// Segments for the hard instances, drawn from a seed.
#pragma once

#include <cstdint>
#include <vector>

#include "thalweg/hard_instances.hpp"

namespace thalweg::io {

/// The most segments that `random_segments` draws; general position takes cubic time.
inline constexpr std::uint32_t kMostRandomSegments = 200;

/// `count` segments with ends drawn from a square of side 32 count, no three of them collinear, nor nearly
/// so. The same on every machine. Errors: invalid_argument for more than kMostRandomSegments. Complexity:
/// O(count^3).
Result<std::vector<LatticeSegment>> random_segments(std::uint32_t count, std::uint64_t seed);

}  // namespace thalweg::io
