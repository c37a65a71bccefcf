/// Numbers as binary files hold them, and their conversion to coordinates a block at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "thalweg/point.hpp"

namespace thalweg::io {

enum class ScalarType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Bytes of one value.
std::size_t size_of(ScalarType type) noexcept;
bool is_real(ScalarType type) noexcept;

/// A value of each of a run of records: its type, and where it is.
struct Column {
  ScalarType type = ScalarType::float64;
  std::size_t offset = 0;  ///< of the value in a record
  bool swap = false;       ///< whether its bytes are in the order that is not this machine's
};

/// The value of one record. Whole numbers beyond 2^53 are rounded.
double value_of(const Column& column, const char* record) noexcept;

/// Sets coordinate `axis` (0 to 2) of each point to the value of its record, which are `stride` bytes apart.
/// Whole numbers that no double is equal to become NaN.
void convert(const Column& column, const char* records, std::size_t stride, std::size_t axis,
             std::span<Point3> points) noexcept;

/// The corners of triangles as 32-bit numbers: value `corner` of each record. Requires: a type of at most 32
/// bits; negative values wrap around.
void convert(const Column& column, const char* records, std::size_t stride, std::span<std::uint32_t> values,
             std::size_t values_apart) noexcept;

/// Reverses the bytes of every coordinate if this machine is big endian: what little endian files need.
void from_little_endian(std::span<Point3> points) noexcept;

/// The first point that is not finite, in words: "y is NaN: correct or remove it".
struct PointFault {
  std::size_t index = 0;
  std::string what;
};
/// `nan_z`: whether a z of NaN is legal.
std::optional<PointFault> find_not_finite(std::span<const Point3> points, bool nan_z = false);

}  // namespace thalweg::io
