#include "io/write_mesh.hpp"

#include <bit>
#include <limits>
#include <string>
#include <string_view>

#include "io/npy.hpp"
#include "io/row_writer.hpp"
#include "io/tlw.hpp"

namespace thalweg::io {
namespace {

Error wrong_format(Format format, std::string_view what, std::string_view formats) {
  return {ErrorCode::invalid_argument, std::string(name_of(format)) + " cannot hold " + std::string(what) +
                                           ": use one of " + std::string(formats)};
}

// A comment is one line, whatever its text.
std::string one_line(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return out;
}

void write_obj(RowWriter& out, const MeshView& mesh) {
  out << "# thalweg terrain: " << mesh.points.size() << " vertices, " << mesh.triangles.size()
      << " triangles\n";
  if (!mesh.crs.empty()) out << "# crs: " << one_line(mesh.crs) << '\n';
  for (const Point3& p : mesh.points) {
    if (out.failed()) return;
    out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  }
  for (const IndexTriangle& t : mesh.triangles) {
    if (out.failed()) return;
    out << "f " << std::uint64_t{t[0]} + 1 << ' ' << std::uint64_t{t[1]} + 1 << ' ' << std::uint64_t{t[2]} + 1
        << '\n';
  }
}

void write_2dm(RowWriter& out, const MeshView& mesh) {
  out << "MESH2D\n";
  std::uint64_t id = 0;
  for (const Point3& p : mesh.points) {
    if (out.failed()) return;
    out << "ND " << ++id << ' ' << p.x << ' ' << p.y << ' ' << p.z << '\n';
  }
  id = 0;
  for (const IndexTriangle& t : mesh.triangles) {
    if (out.failed()) return;
    out << "E3T " << ++id << ' ' << std::uint64_t{t[0]} + 1 << ' ' << std::uint64_t{t[1]} + 1 << ' '
        << std::uint64_t{t[2]} + 1 << " 1\n";
  }
}

// MDAL, and so QGIS, takes lower-case names, `comment crs:` and any further scalar property as a layer; long
// headers and upper-case names keep other programs from opening the file.
void write_ply_header(RowWriter& out, const MeshView& mesh, bool ascii) {
  out << "ply\nformat " << (ascii ? "ascii" : "binary_little_endian") << " 1.0\ncomment written by thalweg\n";
  if (!mesh.crs.empty()) out << "comment crs: " << one_line(mesh.crs) << '\n';
  out << "element vertex " << mesh.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  if (!mesh.pit.empty()) out << "property uchar pit\n";
  out << "element face " << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\n";
  if (!mesh.order.empty()) out << "property int order\n";
  out << "end_header\n";
}

void write_ply_ascii(RowWriter& out, const MeshView& mesh) {
  for (std::size_t i = 0; i < mesh.points.size() && !out.failed(); ++i) {
    const Point3& p = mesh.points[i];
    out << p.x << ' ' << p.y << ' ' << p.z;
    if (!mesh.pit.empty()) out << ' ' << mesh.pit[i];
    out << '\n';
  }
  for (std::size_t i = 0; i < mesh.triangles.size() && !out.failed(); ++i) {
    const IndexTriangle& t = mesh.triangles[i];
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2];
    if (!mesh.order.empty()) out << ' ' << mesh.order[i];
    out << '\n';
  }
}

std::uint32_t little(std::uint32_t value) {
  if constexpr (std::endian::native == std::endian::little) return value;
  return value << 24 | (value & 0xff00u) << 8 | (value >> 8 & 0xff00u) | value >> 24;
}

void put_double(RowWriter& out, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  out.raw(little(static_cast<std::uint32_t>(bits & 0xffffffffu)));
  out.raw(little(static_cast<std::uint32_t>(bits >> 32)));
}

void write_ply_binary(RowWriter& out, const MeshView& mesh) {
  for (std::size_t i = 0; i < mesh.points.size() && !out.failed(); ++i) {
    const Point3& p = mesh.points[i];
    put_double(out, p.x);
    put_double(out, p.y);
    put_double(out, p.z);
    if (!mesh.pit.empty()) out.raw(mesh.pit[i]);
  }
  for (std::size_t i = 0; i < mesh.triangles.size() && !out.failed(); ++i) {
    out.raw(std::uint8_t{3});
    for (const std::uint32_t vertex : mesh.triangles[i]) out.raw(little(vertex));
    if (!mesh.order.empty()) out.raw(little(mesh.order[i]));
  }
}

void write_rows(RowWriter& out, std::span<const Point3> points, std::span<const std::uint8_t> pit,
                Format format) {
  const char separator = format == Format::csv ? ',' : format == Format::tsv ? '\t' : ' ';
  if (format != Format::xyz) {
    out << 'x' << separator << 'y' << separator << 'z';
    if (!pit.empty()) out << separator << "pit";
    out << '\n';
  }
  for (std::size_t i = 0; i < points.size() && !out.failed(); ++i) {
    out << points[i].x << separator << points[i].y << separator << points[i].z;
    if (!pit.empty()) out << separator << pit[i];
    out << '\n';
  }
}

}  // namespace

std::optional<Error> write_mesh(OutputFile& output, const MeshView& mesh, Format format) {
  RowWriter out(output);
  switch (format) {
    case Format::obj:
      write_obj(out, mesh);
      break;
    case Format::two_dm:
      write_2dm(out, mesh);
      break;
    case Format::ply:
    case Format::ply_ascii:
      if (mesh.points.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
        return Error{ErrorCode::too_many_points, "PLY numbers vertices by 31 bits: use obj or 2dm"};
      }
      write_ply_header(out, mesh, format == Format::ply_ascii);
      format == Format::ply_ascii ? write_ply_ascii(out, mesh) : write_ply_binary(out, mesh);
      break;
    case Format::tlw:
      write_tlw(output, mesh);
      break;
    case Format::npy:
      write_npy(output, mesh.triangles);
      break;
    case Format::csv:
    case Format::tsv:
    case Format::xyz:
      write_rows(out, mesh.points, mesh.pit, format);
      break;
    default:
      return wrong_format(format, "a mesh", "ply, ply-ascii, obj, 2dm, tlw, npy, csv, tsv, xyz");
  }
  out.flush();
  return output.error();
}

std::optional<Error> write_points(OutputFile& output, std::span<const Point3> points, Format format) {
  if (format == Format::tlw || format == Format::npy) {
    format == Format::npy ? write_npy(output, points)
                          : write_tlw(output, {.points = points, .triangles = {}});
    return output.error();
  }
  if (format != Format::csv && format != Format::tsv && format != Format::xyz) {
    return wrong_format(format, "bare points", "xyz, csv, tsv, tlw, npy");
  }
  RowWriter out(output);
  write_rows(out, points, {}, format);
  out.flush();
  return output.error();
}

}  // namespace thalweg::io
