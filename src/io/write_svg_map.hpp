/// Writer of the map for papers: the result as one plain SVG.
#pragma once

#include <optional>

#include "io/output_file.hpp"
#include "io/report.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// What is drawn, from the bottom up.
struct MapLayers {
  bool shading = false;  ///< triangles tinted by elevation, lit from the north-west
  bool cells = false;    ///< Voronoi cells of the vertices
  bool flow = false;     ///< paths of steepest descent, the wider the more come together
  bool edges = true;
  bool changes = true;  ///< edges that have gone, dashed, and those that came
  bool pits = true;     ///< circles, the larger the deeper
};

/// Writes the map with a legend and a scale bar; the caller commits. The same report gives the same bytes.
/// Text of the report is never markup. Errors: those of the output. Requires: as write_report.
[[nodiscard]] std::optional<Error> write_svg_map(OutputFile& output, const Report& report,
                                                 const MapLayers& layers);

}  // namespace thalweg::io
