/// One reader a format, on content that is in memory unless it is said otherwise; read_points, read_grid and
/// read_mesh choose among them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "io/grid.hpp"
#include "io/huge_pages.hpp"
#include "io/input_file.hpp"
#include "io/mesh_file.hpp"
#include "io/point_table.hpp"
#include "io/read_options.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// Whether a reader of meshes keeps the faces, and so insists on triangles, or is asked for the vertices
/// alone.
enum class Faces { keep, ignore };

/// Begins with what is loaded of the input, and reads the rest in blocks.
Result<PointTable> parse_table(InputFile& input, const ReadOptions& options);
Result<Grid> parse_grid(const InputFile& input, const ReadOptions& options);
Result<MeshFile> parse_obj(const InputFile& input, Faces faces);
/// Begins with what is loaded of the input, and reads the rest of a binary file in blocks.
Result<MeshFile> parse_ply(InputFile& input, Faces faces);
Result<MeshFile> parse_2dm(const InputFile& input, Faces faces);

/// The most points that 32-bit ids can triangulate: a half-edge, of which a site has six, has one too.
inline constexpr std::uint64_t kMostPoints = 0x1fffffff;

/// The error of an input with more points than that, if `count` is. Readers ask before they take memory for
/// so many.
std::optional<Error> find_excess(const InputFile& input, std::uint64_t count);

/// Makes room for `count` items without touching it. Untouched room costs nothing, so a guess may be
/// generous.
template <class T>
void reserve_large(std::vector<T>& items, std::size_t count) {
  constexpr std::size_t kLarge = std::size_t{1} << 22;
  items.reserve(count);
  const std::size_t room = (items.capacity() - items.size()) * sizeof(T);
  if (room >= kLarge) prefer_huge_pages(items.data() + items.size(), room);
}

}  // namespace thalweg::io
