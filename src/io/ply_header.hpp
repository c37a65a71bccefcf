/// The header of a PLY file: which elements follow, how many, and of what properties.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_file.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

enum class PlyEncoding { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of one value in a binary file.
std::size_t size_of(PlyType type) noexcept;
bool is_real(PlyType type) noexcept;

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
  std::string_view body;    ///< what follows the header; a part of the input
  std::uint64_t lines = 0;  ///< of the header
};

/// Errors: malformed, naming the line; also if the file is too short for what the header promises, so that a
/// reader may reserve room for `count` elements of any kind without asking for more than a small multiple of
/// the size of the file.
Result<PlyHeader> parse_ply_header(const InputFile& input);

}  // namespace thalweg::io
