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

RowText& operator<<(RowText& out, const Point3& p) {
  return out << p.x << ' ' << p.y << ' ' << p.z;
}

/// The corners, the first vertex of the mesh being number `first`.
void put_corners(RowText& out, const IndexTriangle& t, std::uint64_t first) {
  out << t[0] + first << ' ' << t[1] + first << ' ' << t[2] + first;
}

void write_obj(RowWriter& out, const MeshView& mesh) {
  out << "# thalweg terrain: " << mesh.points.size() << " vertices, " << mesh.triangles.size()
      << " triangles\n";
  if (!mesh.crs.empty()) out << "# crs: " << one_line(mesh.crs) << '\n';
  out.rows(mesh.points.size(), [&](RowText& row, std::size_t i) { row << "v " << mesh.points[i] << '\n'; });
  out.rows(mesh.triangles.size(), [&](RowText& row, std::size_t i) {
    row << "f ";
    put_corners(row, mesh.triangles[i], 1);
    row << '\n';
  });
}

void write_2dm(RowWriter& out, const MeshView& mesh) {
  out << "MESH2D\n";
  out.rows(mesh.points.size(),
           [&](RowText& row, std::size_t i) { row << "ND " << i + 1 << ' ' << mesh.points[i] << '\n'; });
  out.rows(mesh.triangles.size(), [&](RowText& row, std::size_t i) {
    row << "E3T " << i + 1 << ' ';
    put_corners(row, mesh.triangles[i], 1);
    row << " 1\n";
  });
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
  out.rows(mesh.points.size(), [&](RowText& row, std::size_t i) {
    row << mesh.points[i];
    if (!mesh.pit.empty()) row << ' ' << mesh.pit[i];
    row << '\n';
  });
  out.rows(mesh.triangles.size(), [&](RowText& row, std::size_t i) {
    row << "3 ";
    put_corners(row, mesh.triangles[i], 0);
    if (!mesh.order.empty()) row << ' ' << mesh.order[i];
    row << '\n';
  });
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
  out.rows(points.size(), [&](RowText& row, std::size_t i) {
    row << points[i].x << separator << points[i].y << separator << points[i].z;
    if (!pit.empty()) row << separator << pit[i];
    row << '\n';
  });
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
