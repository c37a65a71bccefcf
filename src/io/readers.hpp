/// One reader a format, each on content that is already in memory; read_points, read_grid and read_mesh
/// choose among them.
#pragma once

#include "io/grid.hpp"
#include "io/input_file.hpp"
#include "io/mesh_file.hpp"
#include "io/point_table.hpp"
#include "io/read_options.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// Whether a reader of meshes keeps the faces, and so insists on triangles, or is asked for the vertices
/// alone.
enum class Faces { keep, ignore };

Result<PointTable> parse_table(const InputFile& input, const ReadOptions& options);
Result<Grid> parse_grid(const InputFile& input, const ReadOptions& options);
Result<MeshFile> parse_obj(const InputFile& input, Faces faces);
Result<MeshFile> parse_ply(const InputFile& input, Faces faces);
Result<MeshFile> parse_2dm(const InputFile& input, Faces faces);

/// The largest number of vertices that 32-bit indices can name.
inline constexpr std::uint64_t kMostPoints = 0xfffffffeu;

}  // namespace thalweg::io
