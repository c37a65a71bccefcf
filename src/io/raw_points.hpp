/// The part that .tlw and .npy have in common: rows of three little endian doubles, one after another.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_file.hpp"
#include "io/output_file.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// The next `count` points of the input. `row` names one in messages: "point". Room for them is taken at once
/// where the size of the input says that they are there, else as they come. Errors: malformed for a
/// coordinate that is not finite (`nan_z`: but for a z of NaN) and if the file ends; those of read.
Result<std::vector<Point3>> read_raw_points(InputFile& input, std::uint64_t count, std::string_view row,
                                            bool nan_z = false);

/// The error "NAME: ROW INDEX (from 0): what".
Error row_error(const InputFile& input, std::string_view row, std::uint64_t index, std::string_view what);

/// Reads what is left, so that whoever writes a pipe is not cut off before its end.
std::optional<Error> read_rest(InputFile& input);

void write_raw_points(OutputFile& output, std::span<const Point3> points);
void write_raw_numbers(OutputFile& output, std::span<const std::uint32_t> numbers);

/// The number of `size` little endian bytes at `bytes`, at most 8.
std::uint64_t little_endian_number(const char* bytes, std::size_t size) noexcept;
/// Appends `size` little endian bytes.
void append_number(std::string& out, std::uint64_t value, std::size_t size);

}  // namespace thalweg::io
