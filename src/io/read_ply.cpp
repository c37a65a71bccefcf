/// PLY meshes: ascii, binary little and big endian; any elements and properties beside x, y, z and the faces
/// are skipped.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/number.hpp"
#include "io/ply_header.hpp"
#include "io/ply_source.hpp"
#include "io/readers.hpp"

namespace thalweg::io {
namespace {

template <class Source>
bool skip_property(Source& source, const PlyProperty& property) {
  if (!property.is_list) return source.skip(property.type, 1);
  std::int64_t count = 0;
  if (!source.whole(property.count_type, count, "the length of a list")) return false;
  if (count < 0) return source.fail("a list of negative length: correct it");
  return source.skip(property.type, count);
}

template <class Source>
bool read_vertices(Source& source, const PlyElement& element, MeshFile& mesh) {
  std::vector<std::optional<std::size_t>> axes;
  for (const PlyProperty& property : element.properties) axes.push_back(axis_of(property));
  // Of a pipe it is not known whether the points that the header promises are there.
  if (source.remaining() / element.properties.size() >= element.count)
    reserve_large(mesh.points, static_cast<std::size_t>(element.count));
  for (std::uint64_t row = source.take_vertices(element, mesh.points); row < element.count; ++row) {
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
  reserve_large(mesh.triangles,
                static_cast<std::size_t>(std::min(element.count, source.remaining() / kSmallestFace)));
  const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_corner_list);
  const PlyProperty* const corners = &*list;  // find_header_fault has seen to it that there is one
  std::uint64_t row = source.take_triangles(element, vertex_count, mesh.triangles);
  for (; row < element.count; ++row) {
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
  for (std::uint64_t row = source.skip_rows(element); row < element.count; ++row) {
    if (!source.begin_row({element.name, row})) return false;
    for (const PlyProperty& property : element.properties) {
      if (!skip_property(source, property)) return false;
    }
    if (!source.end_row()) return false;
  }
  return true;
}

template <class Source>
std::optional<Error> read_body(Source&& source, const PlyHeader& header, Faces faces, MeshFile& mesh) {
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

Result<MeshFile> parse_ply(InputFile& input, Faces faces) {
  Result<PlyHeader> header = parse_ply_header(input);
  if (!header) return std::move(header).error();
  if (auto fault = find_header_fault(*header, faces)) return input.error(ErrorCode::malformed, *fault);
  for (const PlyElement& element : header->elements) {
    if (element.name != "vertex") continue;
    if (auto excess = find_excess(input, element.count)) return std::move(*excess);
  }
  MeshFile mesh;
  mesh.crs = header->crs;
  auto error = header->encoding == PlyEncoding::ascii
                   ? read_body(AsciiSource(input, *header), *header, faces, mesh)
                   : read_body(BinarySource(input, *header), *header, faces, mesh);
  if (error) return std::move(*error);
  return mesh;
}

}  // namespace thalweg::io
