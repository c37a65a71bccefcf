#include "io/ply_source.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "io/readers.hpp"
#include "io/scalar.hpp"

namespace thalweg::io {
namespace {

/// Bytes of a row in which every list has `list_length` items.
std::size_t row_size(const PlyElement& element, std::size_t list_length) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) {
    size += property.is_list ? size_of(property.count_type) + list_length * size_of(property.type)
                             : size_of(property.type);
  }
  return size;
}

/// Where the only list of an element begins.
struct ListPlace {
  std::size_t offset = 0;
  PlyType type = PlyType::int32;
};

/// Nothing unless there is one list, and one byte tells its length.
std::optional<ListPlace> only_list(const PlyElement& element) {
  std::optional<ListPlace> place;
  std::size_t offset = 0;
  for (const PlyProperty& property : element.properties) {
    if (property.is_list) {
      if (place || size_of(property.count_type) != 1) return std::nullopt;
      place = ListPlace{offset, property.type};
    }
    offset += property.is_list ? 1 : size_of(property.type);
  }
  return place;
}

/// How many of the first `most` rows have this byte as the length of their list.
std::size_t count_alike(const char* length, std::size_t stride, std::size_t most, char expected) {
  std::size_t count = 0;
  while (count < most && length[count * stride] == expected) ++count;
  return count;
}

}  // namespace

std::optional<std::size_t> axis_of(const PlyProperty& property) {
  if (same_word(property.name, "x")) return 0;
  if (same_word(property.name, "y")) return 1;
  if (same_word(property.name, "z")) return 2;
  return std::nullopt;
}

bool is_corner_list(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

BinarySource::BinarySource(InputFile& input, const PlyHeader& header)
    : input_(input),
      window_(input, header.size),
      swap_((header.encoding == PlyEncoding::big_endian) != (std::endian::native == std::endian::big)) {}

std::string_view BinarySource::window(std::size_t least) {
  if (fault_) return {};
  Result<std::string_view> bytes = window_.peek(least);
  if (bytes) return *bytes;
  fault_ = std::move(bytes).error();
  return {};
}

std::uint64_t BinarySource::take_vertices(const PlyElement& element, std::vector<Point3>& points) {
  std::array<Column, 3> columns;
  std::size_t offset = 0;
  for (const PlyProperty& property : element.properties) {
    if (property.is_list) return 0;
    if (const auto axis = axis_of(property)) columns[*axis] = {property.type, offset, swap_};
    offset += size_of(property.type);
  }
  const std::size_t stride = offset;
  for (std::uint64_t row = 0; row < element.count;) {
    const std::string_view bytes = window(stride);
    const auto count =
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size() / stride, element.count - row));
    if (count == 0) return row;
    points.resize(static_cast<std::size_t>(row) + count);
    const std::span<Point3> block = std::span(points).subspan(static_cast<std::size_t>(row));
    for (std::size_t axis = 0; axis < 3; ++axis) convert(columns[axis], bytes.data(), stride, axis, block);
    const auto fault = find_not_finite(block);
    const std::size_t good = fault ? fault->index : count;
    window_.advance(good * stride);
    row += good;
    points.resize(static_cast<std::size_t>(row));
    if (fault) return row;
  }
  return element.count;
}

std::uint64_t BinarySource::take_triangles(const PlyElement& element, std::uint64_t vertex_count,
                                           std::vector<IndexTriangle>& triangles) {
  const auto list = only_list(element);
  if (!list) return 0;
  const std::size_t stride = row_size(element, 3);
  for (std::uint64_t row = 0; row < element.count;) {
    const std::string_view bytes = window(stride);
    const auto here =
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size() / stride, element.count - row));
    const std::size_t count = count_alike(bytes.data() + list->offset, stride, here, 3);
    if (count == 0) return row;
    triangles.resize(static_cast<std::size_t>(row) + count);
    const std::span<std::uint32_t> corners(triangles[static_cast<std::size_t>(row)].data(), 3 * count);
    for (std::size_t i = 0; i < 3; ++i) {
      const Column column{list->type, list->offset + 1 + i * size_of(list->type), swap_};
      convert(column, bytes.data(), stride, corners.subspan(i), 3);
    }
    const auto foreign = std::find_if(corners.begin(), corners.end(),
                                      [=](std::uint32_t corner) { return corner >= vertex_count; });
    const auto good = static_cast<std::size_t>(foreign - corners.begin()) / 3;
    window_.advance(good * stride);
    row += good;
    triangles.resize(static_cast<std::size_t>(row));
    if (good < here) return row;
  }
  return element.count;
}

std::uint64_t BinarySource::skip_rows(const PlyElement& element) {
  const bool has_lists = std::any_of(element.properties.begin(), element.properties.end(),
                                     [](const PlyProperty& property) { return property.is_list; });
  const auto list = only_list(element);
  if (has_lists && !list) return 0;
  const std::size_t least = row_size(element, 0);
  for (std::uint64_t row = 0; row < element.count;) {
    std::string_view bytes = window(least);
    if (bytes.size() < least) return row;
    const char length = list ? bytes[list->offset] : '\0';
    if (length < 0) return row;
    const std::size_t stride = row_size(element, static_cast<std::size_t>(length));
    bytes = window(stride);
    const auto here =
        static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size() / stride, element.count - row));
    const std::size_t count = list ? count_alike(bytes.data() + list->offset, stride, here, length) : here;
    if (count == 0) return row;
    window_.advance(count * stride);
    row += count;
  }
  return element.count;
}

bool BinarySource::real(PlyType type, double& value, std::string_view what) {
  if (!load(type, value)) return false;
  return std::isfinite(value) || fail(std::string(what) + (std::isnan(value) ? " is NaN" : " is infinite") +
                                      ": correct or remove it");
}

bool BinarySource::whole(PlyType type, std::int64_t& value, std::string_view) {
  double number = 0;  // holds every 32-bit whole number exactly
  if (!load(type, number)) return false;
  value = static_cast<std::int64_t>(number);
  return true;
}

bool BinarySource::skip(PlyType type, std::int64_t count) {
  for (std::uint64_t left = static_cast<std::uint64_t>(count) * size_of(type); left > 0;) {
    const auto here = static_cast<std::size_t>(std::min<std::uint64_t>(window(1).size(), left));
    if (here == 0) return cut_short();
    window_.advance(here);
    left -= here;
  }
  return true;
}

bool BinarySource::load(PlyType type, double& value) {
  const std::string_view bytes = window(size_of(type));
  if (bytes.size() < size_of(type)) return cut_short();
  value = value_of({type, 0, swap_}, bytes.data());
  window_.advance(size_of(type));
  return true;
}

bool BinarySource::fail(std::string_view what) {
  if (!fault_) {
    fault_ =
        input_.error(ErrorCode::malformed, std::string(place_.element) + " " + std::to_string(place_.row) +
                                               " (from 0): " + std::string(what));
  }
  return false;
}

bool BinarySource::end_file() {
  std::uint64_t count = 0;
  bool blank = true;  // some programs end every file with a line end
  for (std::string_view bytes = window(1); !bytes.empty(); bytes = window(1)) {
    blank = blank && bytes.find_first_not_of(" \t\r\n") == std::string_view::npos;
    count += bytes.size();
    window_.advance(bytes.size());
  }
  if (!fault_ && !blank) {
    fault_ = input_.error(ErrorCode::malformed,
                          std::to_string(count) +
                              " bytes more than the header promises: its counts or types are "
                              "wrong");
  }
  return !fault_;
}

}  // namespace thalweg::io
