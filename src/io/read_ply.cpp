/// PLY meshes: ascii, binary little and big endian; any elements and properties beside x, y, z and the faces
/// are skipped.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/number.hpp"
#include "io/ply_header.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

/// Where in the file a reader is, for messages.
struct Place {
  std::string_view element;
  std::uint64_t row = 0;
};

// AsciiSource and BinarySource have the same members: a row of values one after another, each asked for by
// its type. All answer false after a fault, which `fault` then holds.

class AsciiSource {
 public:
  AsciiSource(const InputFile& input, const PlyHeader& header)
      : scanner_(header.body, input.name(), 0, header.lines + 1) {}

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
  BinarySource(const InputFile& input, const PlyHeader& header)
      : at_(header.body.data()),
        last_(at_ + header.body.size()),
        name_(input.name()),
        swap_((header.encoding == PlyEncoding::big_endian) != (std::endian::native == std::endian::big)) {}

  bool begin_row(const Place& place) {
    place_ = place;
    return !fault_;
  }
  bool end_row() { return true; }

  bool real(PlyType type, double& value, std::string_view what) {
    if (!load(type, value)) return false;
    return std::isfinite(value) || fail(std::string(what) + (std::isnan(value) ? " is NaN" : " is infinite") +
                                        ": correct or remove it");
  }
  bool whole(PlyType type, std::int64_t& value, std::string_view) {
    double number = 0;  // holds every 32-bit whole number exactly
    if (!load(type, number)) return false;
    value = static_cast<std::int64_t>(number);
    return true;
  }
  bool skip(PlyType type, std::int64_t count) {
    if (static_cast<std::uint64_t>(count) > remaining() / size_of(type)) return cut_short();
    at_ += static_cast<std::size_t>(count) * size_of(type);
    return true;
  }
  bool fail(std::string_view what) {
    if (!fault_) {
      fault_ =
          Error{ErrorCode::malformed, std::string(name_) + ": " + std::string(place_.element) + " " +
                                          std::to_string(place_.row) + " (from 0): " + std::string(what)};
    }
    return false;
  }
  bool end_file() {
    const std::string_view rest(at_, static_cast<std::size_t>(last_ - at_));
    if (trimmed(rest).find_first_not_of('\n') == std::string_view::npos) return true;
    fault_ = Error{ErrorCode::malformed,
                   std::string(name_) + ": " + std::to_string(rest.size()) +
                       " bytes more than the header promises: its counts or types are wrong"};
    return false;
  }
  std::uint64_t remaining() const { return static_cast<std::uint64_t>(last_ - at_); }
  const std::optional<Error>& fault() const { return fault_; }

 private:
  bool cut_short() { return fail("the file ends here: it is cut short"); }

  template <class T>
  double take() {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, at_, sizeof(T));
    at_ += sizeof(T);
    if (swap_) std::reverse(bytes, bytes + sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
  }

  bool load(PlyType type, double& value) {
    if (remaining() < size_of(type)) return cut_short();
    switch (type) {
      case PlyType::int8:
        value = take<std::int8_t>();
        break;
      case PlyType::uint8:
        value = take<std::uint8_t>();
        break;
      case PlyType::int16:
        value = take<std::int16_t>();
        break;
      case PlyType::uint16:
        value = take<std::uint16_t>();
        break;
      case PlyType::int32:
        value = take<std::int32_t>();
        break;
      case PlyType::uint32:
        value = take<std::uint32_t>();
        break;
      case PlyType::float32:
        value = take<float>();
        break;
      case PlyType::float64:
        value = take<double>();
        break;
    }
    return true;
  }

  const char* at_;
  const char* last_;
  std::string_view name_;
  bool swap_;
  Place place_;
  std::optional<Error> fault_;
};

template <class Source>
bool skip_property(Source& source, const PlyProperty& property) {
  if (!property.is_list) return source.skip(property.type, 1);
  std::int64_t count = 0;
  if (!source.whole(property.count_type, count, "the length of a list")) return false;
  if (count < 0) return source.fail("a list of negative length: correct it");
  return source.skip(property.type, count);
}

// The axis of a property of vertices, or nothing. QGIS once wrote the names in upper case.
std::optional<std::size_t> axis_of(const PlyProperty& property) {
  if (same_word(property.name, "x")) return 0;
  if (same_word(property.name, "y")) return 1;
  if (same_word(property.name, "z")) return 2;
  return std::nullopt;
}

template <class Source>
bool read_vertices(Source& source, const PlyElement& element, MeshFile& mesh) {
  std::vector<std::optional<std::size_t>> axes;
  for (const PlyProperty& property : element.properties) axes.push_back(axis_of(property));
  mesh.points.reserve(static_cast<std::size_t>(element.count));
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (!source.begin_row({element.name, row})) return false;
    Point3 p;
    double* const places[] = {&p.x, &p.y, &p.z};
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      const bool good = axes[i] ? source.real(property.type, *places[*axes[i]], property.name)
                                : skip_property(source, property);
      if (!good) return false;
    }
    if (!source.end_row()) return false;
    mesh.points.push_back(p);
  }
  return true;
}

bool is_corner_list(const PlyProperty& property) {
  return property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
}

template <class Source>
bool read_corners(Source& source, const PlyProperty& property, std::uint64_t vertex_count,
                  IndexTriangle& triangle) {
  std::int64_t corners = 0;
  if (!source.whole(property.count_type, corners, "the number of corners")) return false;
  if (corners != 3) {
    return source.fail("a face with " + std::to_string(corners) +
                       " corners: only triangles can be read; triangulate it first");
  }
  for (std::uint32_t& corner : triangle) {
    std::int64_t vertex = 0;
    if (!source.whole(property.type, vertex, "a corner")) return false;
    if (vertex < 0 || static_cast<std::uint64_t>(vertex) >= vertex_count) {
      return source.fail("vertex " + std::to_string(vertex) + " does not exist: there are " +
                         std::to_string(vertex_count) + ", numbered from 0");
    }
    corner = static_cast<std::uint32_t>(vertex);
  }
  return true;
}

template <class Source>
bool read_faces(Source& source, const PlyElement& element, std::uint64_t vertex_count, MeshFile& mesh) {
  constexpr std::uint64_t kSmallestFace = 4;  // a length and three corners of one byte each
  mesh.triangles.reserve(
      static_cast<std::size_t>(std::min(element.count, source.remaining() / kSmallestFace)));
  const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_corner_list);
  const PlyProperty* const corners = &*list;  // find_header_fault has seen to it that there is one
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (!source.begin_row({element.name, row})) return false;
    IndexTriangle triangle{};
    for (const PlyProperty& property : element.properties) {
      const bool good = &property == corners ? read_corners(source, property, vertex_count, triangle)
                                             : skip_property(source, property);
      if (!good) return false;
    }
    if (!source.end_row()) return false;
    mesh.triangles.push_back(triangle);
  }
  return true;
}

template <class Source>
bool skip_element(Source& source, const PlyElement& element) {
  if (element.properties.empty()) return true;  // nothing in the file, however many there are said to be
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (!source.begin_row({element.name, row})) return false;
    for (const PlyProperty& property : element.properties) {
      if (!skip_property(source, property)) return false;
    }
    if (!source.end_row()) return false;
  }
  return true;
}

template <class Source>
std::optional<Error> read_body(Source source, const PlyHeader& header, Faces faces, MeshFile& mesh) {
  std::uint64_t vertex_count = 0;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") vertex_count = element.count;
  }
  for (const PlyElement& element : header.elements) {
    const bool good = element.name == "vertex" ? read_vertices(source, element, mesh)
                      : element.name == "face" && faces == Faces::keep
                          ? read_faces(source, element, vertex_count, mesh)
                          : skip_element(source, element);
    if (!good) return source.fault();
  }
  if (!source.end_file()) return source.fault();
  return std::nullopt;
}

// What keeps the header from being that of a mesh, in words.
std::optional<std::string> find_header_fault(const PlyHeader& header, Faces faces) {
  bool has_vertices = false;
  bool has_faces = false;
  for (const PlyElement& element : header.elements) {
    if (element.name == "vertex") {
      has_vertices = true;
      std::size_t found[3] = {0, 0, 0};
      for (const PlyProperty& property : element.properties) {
        const auto axis = axis_of(property);
        if (axis && property.is_list)
          return "property " + in_quotes(property.name) + " of vertices may not be a list";
        if (axis) ++found[*axis];
      }
      if (found[0] != 1 || found[1] != 1 || found[2] != 1)
        return "vertices need properties x, y and z, once each";
      if (element.count > kMostPoints) return "more vertices than 32-bit indices can name: split the mesh";
    } else if (element.name == "face") {
      const auto lists = std::count_if(element.properties.begin(), element.properties.end(), is_corner_list);
      has_faces = lists == 1;
      for (const PlyProperty& property : element.properties) {
        if (is_corner_list(property) && is_real(property.type))
          return "the corners of faces must be whole numbers";
      }
    }
  }
  if (!has_vertices) return "the header has no element vertex: there are no points in it";
  if (faces == Faces::keep && !has_faces) {
    return "the header has no element face with a list vertex_indices: points alone are no mesh, triangle "
           "strips not read";
  }
  return std::nullopt;
}

}  // namespace

Result<MeshFile> parse_ply(const InputFile& input, Faces faces) {
  Result<PlyHeader> header = parse_ply_header(input);
  if (!header) return std::move(header).error();
  if (auto fault = find_header_fault(*header, faces)) return input.error(ErrorCode::malformed, *fault);
  MeshFile mesh;
  mesh.crs = header->crs;
  auto error = header->encoding == PlyEncoding::ascii
                   ? read_body(AsciiSource(input, *header), *header, faces, mesh)
                   : read_body(BinarySource(input, *header), *header, faces, mesh);
  if (error) return std::move(*error);
  return mesh;
}

}  // namespace thalweg::io
