/// The point sets of the benchmarks. Each is made when it is first asked for; the spans refer to what is then
/// kept for the rest of the process, so that all benchmarks of a set run on the same bytes.
///
/// A set has a name and a number of sites, and is the same on every machine but for libm:
///   uniform        of the unit square
///   clustered      a hundred gaussians of sigma 1e-6 to 1e-1
///   lidar          a jittered grid rounded to hundredths, in scan order, at UTM coordinates
///   grid           whole coordinates, row by row
///   grid_shuffled  the same in random order
///   ring           random places of the unit circle, in doubles
///   parabola       y = x^2, x of [-1, 1]
///   strip          a million times as long as wide
/// Real terrain has the name of its file: jacksboro_fault.asc of tests/data, and all files that can be read
/// of the folder that the environment variable THALWEG_DATA names.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "thalweg/point.hpp"

namespace bench {

/// The number of sites of real terrain: all of the file.
inline constexpr std::size_t kAll = 0;

/// A set in names of benchmarks: `uniform/1000000`, `jacksboro_fault.asc/all`.
struct SetOfSites {
  std::string name;
  std::size_t count = kAll;

  std::string label() const;
};

/// uniform .. strip.
std::span<const std::string_view> synthetic_sets();

/// Every synthetic set at 1000, 10,000 .. `most` sites, and the real ones.
std::vector<SetOfSites> all_sets(std::size_t most);

/// The sites. Throws std::runtime_error for an unknown name, and for a file that cannot be read.
std::vector<thalweg::Point2> make_places(const SetOfSites& set);

/// The sites in the same order with elevations: the file's, or those of a rough surface whose finest details
/// are as large as the sites are apart on average, so that 3 to 5 % of uniform sites are pits. Throws as
/// make_places.
std::vector<thalweg::Point3> make_terrain(const SetOfSites& set);

/// The same, kept.
std::span<const thalweg::Point2> places(const SetOfSites& set);
std::span<const thalweg::Point3> terrain(const SetOfSites& set);

}  // namespace bench
