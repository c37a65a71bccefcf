/// Writer of pits, those that remain and those that were removed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "io/format.hpp"
#include "io/output_file.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

struct PitFeature {
  double x = 0;
  double y = 0;
  double z = 0;
  std::uint32_t vertex = 0;  ///< a vertex of the pit, numbered as in the mesh
  bool boundary = false;
  bool removed = false;
  std::string reason = {};  ///< why it remains or how it went; may be empty
  std::optional<std::uint32_t> order_needed = std::nullopt;
  std::size_t vertices = 1;  ///< how many vertices the pit has
};

/// Writes one row or one GeoJSON Point feature a pit, in the order given; the caller commits. Coordinates are
/// those of the input, not reprojected. Errors: those of the output; invalid_argument unless the format is
/// geojson, csv or tsv.
[[nodiscard]] std::optional<Error> write_pits(OutputFile& output, std::span<const PitFeature> pits,
                                              Format format);

}  // namespace thalweg::io
