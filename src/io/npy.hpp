/// NumPy arrays (.npy, versions 1.0 to 3.0): points as an array of shape (n, 3).
#pragma once

#include <span>

#include "io/mesh_file.hpp"
#include "io/output_file.hpp"
#include "io/point_table.hpp"
#include "io/readers.hpp"

namespace thalweg::io {

/// Whether a file that begins so is an array of NumPy.
bool begins_as_npy(std::string_view bytes) noexcept;

/// The rows of an array of shape (n, 3) of floats (f8, f4) or whole numbers, in either byte order, row by row
/// or column by column. Begins with what is loaded of the input and reads the rest in blocks; takes no memory
/// for more than the input is long. Errors: malformed, too_many_points.
Result<PointTable> parse_npy(InputFile& input, const ReadOptions& options);

/// Writes an array (n, 3) of f8.
void write_npy(OutputFile& output, std::span<const Point3> points);
/// Writes an array (m, 3) of u4: the numbers of the corners of each triangle, from 0.
void write_npy(OutputFile& output, std::span<const IndexTriangle> triangles);

}  // namespace thalweg::io
