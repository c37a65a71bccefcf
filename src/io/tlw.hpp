/// The binary format of thalweg: the points, and the triangles if there are any, as they are in memory.
///
///     bytes          what                              all numbers little endian
///     0  .. 7        89 54 4c 57 0d 0a 1a 0a           "\x89TLW\r\n\x1a\n": tells copies made as text
///     8  .. 11       1                                 version of the format, 32 bits
///     12 .. 15       0x01020304                        so that the order of the bytes can be told
///     16 .. 23       n                                 number of points, 64 bits
///     24 .. 31       m                                 number of triangles, 64 bits; 0: points alone
///     32 .. 35       c                                 bytes of the name of the coordinate system, 32 bits
///     36 .. 39       0                                 not used
///     40 .. 39+p     name, as "EPSG:2056"              c bytes of text, then zeros up to a multiple of 8
///     then 24 n      x y z of every point              64-bit IEEE 754
///     then 12 m      a b c of every triangle           32 bits each, points counted from 0
///
/// Nothing follows.
#pragma once

#include <optional>

#include "io/mesh_file.hpp"
#include "io/output_file.hpp"
#include "io/readers.hpp"
#include "io/write_mesh.hpp"

namespace thalweg::io {

/// Whether a file that begins so is of this format, or was before it was damaged.
bool begins_as_tlw(std::string_view bytes) noexcept;

/// Begins with what is loaded of the input and reads the rest in blocks; takes no memory for more than the
/// input is long. Errors: malformed, too_many_points.
Result<MeshFile> parse_tlw(InputFile& input, Faces faces);

/// Writes points and triangles; `pit` and `order` have no place in the format.
void write_tlw(OutputFile& output, const MeshView& mesh);

}  // namespace thalweg::io
