/// Writers of meshes and of bare points.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "io/format.hpp"
#include "io/mesh_file.hpp"
#include "io/output_file.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// A mesh as it is to be written. Requires: indices below points.size(); `pit` and `order` empty or full.
struct MeshView {
  std::span<const Point3> points;             ///< exactly the vertices to write, in that order
  std::span<const IndexTriangle> triangles;   ///< counter-clockwise
  std::span<const std::uint8_t> pit = {};     ///< one a vertex: 1 on a pit, else 0
  std::span<const std::uint32_t> order = {};  ///< one a triangle: its order
  std::string crs = {};                       ///< for the comment `crs:` of PLY
};

/// Writes the mesh; the caller commits. PLY carries `pit` and `order` as properties; csv, tsv and xyz are the
/// vertices alone, with `pit` as fourth column; tlw is points and triangles, npy the triangles alone. Every
/// number is the shortest decimal that reads back to the same double. Errors: those of the output;
/// invalid_argument for a format that is not for meshes; too_many_points for PLY beyond 2^31 - 1 vertices.
[[nodiscard]] std::optional<Error> write_mesh(OutputFile& output, const MeshView& mesh, Format format);

/// Writes points as xyz (no header), csv or tsv (header x, y, z), tlw or npy; the caller commits. Errors: as
/// write_mesh.
[[nodiscard]] std::optional<Error> write_points(OutputFile& output, std::span<const Point3> points,
                                                Format format);

}  // namespace thalweg::io
