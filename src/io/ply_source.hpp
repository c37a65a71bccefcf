/// The bodies of PLY files: a row of values one after another, each asked for by its type. AsciiSource and
/// BinarySource have the same members; all answer false after a fault, which `fault` then holds.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/byte_window.hpp"
#include "io/mesh_file.hpp"
#include "io/ply_header.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {

/// Where in the file a reader is, for messages.
struct Place {
  std::string_view element;
  std::uint64_t row = 0;
};

class AsciiSource {
 public:
  /// Requires: all of the input loaded.
  AsciiSource(const InputFile& input, const PlyHeader& header)
      : scanner_(input.bytes().substr(header.size), input.name(), 0, header.lines + 1) {}

  std::uint64_t take_vertices(const PlyElement&, std::vector<Point3>&) { return 0; }
  std::uint64_t take_triangles(const PlyElement&, std::uint64_t, std::vector<IndexTriangle>&) { return 0; }
  std::uint64_t skip_rows(const PlyElement&) { return 0; }

  bool begin_row(const Place& place) {
    if (scanner_.next_line()) return true;
    if (!scanner_.fault()) {
      scanner_.fail("the file ends before " + std::string(place.element) + " " + std::to_string(place.row) +
                    " (from 0) that the header promises: it is cut short");
    }
    return false;
  }
  bool end_row() {
    return scanner_.at_line_end() ||
           scanner_.fail("more values on the line than the element has properties: correct it");
  }
  bool real(PlyType, double& value, std::string_view what) { return scanner_.number(value, what); }
  bool whole(PlyType, std::int64_t& value, std::string_view what) {
    return scanner_.whole(value, std::numeric_limits<std::int32_t>::min(),
                          std::numeric_limits<std::uint32_t>::max(), what);
  }
  bool skip(PlyType, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
      if (scanner_.word().empty()) return scanner_.fail("a value is missing: the line is too short");
    }
    return true;
  }
  bool fail(std::string_view what) { return scanner_.fail(what); }
  bool end_file() {
    return !scanner_.next_line() || scanner_.fail("more lines than the header promises: correct its counts");
  }
  std::uint64_t remaining() const { return scanner_.remaining().size(); }
  const std::optional<Error>& fault() const { return scanner_.fault(); }

 private:
  TextScanner scanner_;
};

class BinarySource {
 public:
  BinarySource(InputFile& input, const PlyHeader& header);

  // The first rows of an element whose rows are alike, many at a time. They stop before the first row that is
  // not as it should be, and say how many they took: the other members find out what is wrong with it.
  std::uint64_t take_vertices(const PlyElement& element, std::vector<Point3>& points);
  std::uint64_t take_triangles(const PlyElement& element, std::uint64_t vertex_count,
                               std::vector<IndexTriangle>& triangles);
  std::uint64_t skip_rows(const PlyElement& element);

  bool begin_row(const Place& place) {
    place_ = place;
    return !fault_;
  }
  bool end_row() { return true; }
  bool real(PlyType type, double& value, std::string_view what);
  bool whole(PlyType type, std::int64_t& value, std::string_view what);
  bool skip(PlyType type, std::int64_t count);
  bool fail(std::string_view what);
  bool end_file();
  std::uint64_t remaining() const { return input_.unread().value_or(0); }
  const std::optional<Error>& fault() const { return fault_; }

 private:
  bool load(PlyType type, double& value);
  bool cut_short() { return fail("the file ends here: it is cut short"); }
  /// What is in the window, `least` bytes at least unless the file ends; nothing after a fault.
  std::string_view window(std::size_t least);

  InputFile& input_;
  ByteWindow window_;
  bool swap_;
  Place place_;
  std::optional<Error> fault_;
};

/// The axis of a property of vertices, or nothing. QGIS once wrote the names in upper case.
std::optional<std::size_t> axis_of(const PlyProperty& property);

/// Whether a property of faces holds their corners.
bool is_corner_list(const PlyProperty& property);

}  // namespace thalweg::io
