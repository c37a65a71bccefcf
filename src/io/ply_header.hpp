/// The header of a PLY file: which elements follow, how many, and of what properties.
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

enum class PlyEncoding { ascii, little_endian, big_endian };

using PlyType = ScalarType;  // but for the whole numbers of 64 bits

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float64;  ///< of the value, or of the items of a list
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of the length of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// The least room one such element takes in a file: every list empty, every number one digit and a
  /// separator.
  std::size_t least_size(PlyEncoding encoding) const noexcept;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::string crs;          ///< of a line `comment crs: ...`
  std::size_t size = 0;     ///< bytes of the header: where the body begins
  std::uint64_t lines = 0;  ///< of the header
};

/// Loads the header and reads it; of an ascii file all is loaded. Errors: malformed, naming the line; also if
/// the file is too short for what the header promises, so that a reader may reserve room for `count` elements
/// of any kind without asking for more than a small multiple of the size of the file. Of a pipe the size may
/// not be known yet: then InputFile::unread says nothing.
Result<PlyHeader> parse_ply_header(InputFile& input);

}  // namespace thalweg::io
