/// The header of a .npy file: a literal of Python that says what array follows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_file.hpp"
#include "io/scalar.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

struct NpyHeader {
  ScalarType type = ScalarType::float64;
  bool swap = false;           ///< whether the values are in the byte order that is not this machine's
  bool fortran_order = false;  ///< column by column
  std::uint64_t rows = 0;      ///< of three columns
  std::size_t size = 0;        ///< of the header: where the values begin
};

/// Loads the header and reads it. Errors: malformed, naming what is not as it must be.
Result<NpyHeader> parse_npy_header(InputFile& input);

/// The header of an array (rows, 3) of `descr`, as NumPy writes it.
std::string npy_header(std::string_view descr, std::uint64_t rows);

inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

}  // namespace thalweg::io
