/// Writers of order-k Voronoi diagrams and of nearest sites.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "io/format.hpp"
#include "io/output_file.hpp"
#include "thalweg/order_k_voronoi.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// A diagram as it is to be drawn.
struct VoronoiView {
  const OrderKVoronoi* diagram = nullptr;
  std::span<const std::uint32_t> names;  ///< how each vertex id is called in the output
  Box box;                               ///< cells are clipped to it
};

/// Writes the cells that have area within the box; the caller commits. geojson: a polygon a cell, with the
/// properties `cell`, `sites` and `unbounded`; svg: a picture, 1000 units wide, of cells and sites. Returns
/// how many cells it wrote. Errors: those of the output; invalid_argument for other formats.
Result<std::uint32_t> write_voronoi(OutputFile& output, const VoronoiView& view, Format format);

/// Writes the header `query,site,...` and a row a query: its number from 0 and the names of its nearest
/// sites, nearest first. The caller commits. Errors: those of the output.
[[nodiscard]] std::optional<Error> write_nearest(OutputFile& output, const OrderKVoronoi& diagram,
                                                 std::span<const std::uint32_t> names,
                                                 std::span<const Point2> queries);

}  // namespace thalweg::io
