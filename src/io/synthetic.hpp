/// Synthetic terrain for tests, benchmarks and first steps: points "read" from a seed.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

enum class TerrainKind {
  fractal,  ///< uniform places 10 m apart on average, rough ground: about 4 % of the sites are pits
  ridge,    ///< two families of narrow valleys, oblique to each other, that Delaunay edges dam
  plateau,  ///< terraces: a dozen elevations, so that nearly all neighbours are level
  ring,     ///< rings of 324 sites on one circle, exactly, and as many within one unit of it
  grid,     ///< a square grid of whole coordinates: four cocircular sites everywhere
  lidar,    ///< scan lines with jitter, in centimetres, at UTM coordinates
};

/// fractal, ridge, plateau, ring, grid, lidar.
std::string_view name_of(TerrainKind kind) noexcept;
std::optional<TerrainKind> terrain_kind(std::string_view name) noexcept;

/// `count` points of the kind. The same arguments give the same points on every machine. Places are distinct;
/// of fractal, ridge and plateau, whose places are independent, but for one chance in 10^8 at a million
/// points. Errors: too_few_points below 3; too_many_points beyond 2^32 - 2. Complexity: O(count log count).
Result<std::vector<Point3>> synthetic_terrain(TerrainKind kind, std::uint64_t count, std::uint64_t seed);

}  // namespace thalweg::io
