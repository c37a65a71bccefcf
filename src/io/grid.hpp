/// An elevation grid (ESRI ASCII).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/read_options.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

struct Grid {
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  std::vector<double> x;  ///< centre of each column, west to east
  std::vector<double> y;  ///< centre of each row, north to south
  double dx = 0;
  double dy = 0;
  double nodata = -9999;
  std::vector<double> values;  ///< rows * columns, row by row from the top left; finite or `nodata`

  double value(std::uint32_t row, std::uint32_t column) const noexcept {
    return values[std::size_t{row} * columns + column];
  }
  /// Whether this value stands for "no data". A no-data value of NaN equals NaN.
  bool is_nodata(double value) const noexcept {
    return value == nodata || (std::isnan(value) && std::isnan(nodata));
  }
};

/// The ESRI ASCII grid at `path`; "-" is stdin. options.nodata takes the place of NODATA_value of the header.
/// Errors: as read_points, and malformed if the number of values is not rows times columns.
Result<Grid> read_grid(const std::string& path, const ReadOptions& options = {});

}  // namespace thalweg::io
