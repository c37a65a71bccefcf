#include "io/tlw.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "io/raw_points.hpp"

namespace thalweg::io {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kMagic = "\x89TLW\r\n\x1a\n"sv;
constexpr std::uint64_t kVersion = 1;
constexpr std::uint64_t kOrderMark = 0x01020304;
constexpr std::uint64_t kSwappedMark = 0x04030201;
constexpr std::size_t kHeaderSize = 40;
constexpr std::size_t kLongestName = 4096;
/// A triangle has three half-edges, each with a 32-bit id.
constexpr std::uint64_t kMostTriangles = 0xffffffffu / 3;

struct TlwHeader {
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  std::size_t name = 0;  // bytes

  std::uint64_t padded_name() const { return (name + 7) / 8 * 8; }
  std::uint64_t file_size() const { return kHeaderSize + padded_name() + 24 * points + 12 * triangles; }
};

/// What is wrong with a header, in words.
std::optional<std::string> find_fault(std::string_view bytes, const TlwHeader& header) {
  if (!begins_as_tlw(bytes))
    return "is no thalweg file (.tlw), whatever its name: say what it is with --from";
  if (!bytes.starts_with(kMagic)) return "was changed as if it were text: copy it again, as binary data";
  if (bytes.size() < kHeaderSize) return "the file ends in its header: it is cut short";
  const std::uint64_t version = little_endian_number(bytes.data() + 8, 4);
  const std::uint64_t mark = little_endian_number(bytes.data() + 12, 4);
  if (mark == kSwappedMark) return "is big endian, and .tlw is little endian: write it again with thalweg";
  if (version != kVersion) {
    return "is version " + std::to_string(version) + " of .tlw, and this thalweg reads version " +
           std::to_string(kVersion) + ": write it again, or take a newer thalweg";
  }
  if (mark != kOrderMark || little_endian_number(bytes.data() + 36, 4) != 0 || header.name > kLongestName)
    return "has a damaged header: write it again";
  return std::nullopt;
}

std::string promise(const TlwHeader& header) {
  return "the header promises " + std::to_string(header.points) + " points and " +
         std::to_string(header.triangles) + " triangles";
}

/// Requires: counts within their limits, so that nothing overflows.
std::optional<Error> check_size(const InputFile& input, const TlwHeader& header) {
  const auto size = input.size();
  if (!size || *size == header.file_size()) return std::nullopt;
  const bool shorter = *size < header.file_size();
  return input.error(ErrorCode::malformed,
                     promise(header) + ", which take " + std::to_string(header.file_size()) +
                         " bytes, but the file has " + std::to_string(*size) + ": it is " +
                         (shorter ? "cut short or damaged" : "damaged, or something was appended to it"));
}

Result<TlwHeader> parse_header(const InputFile& input) {
  const std::string_view bytes = input.bytes();
  TlwHeader header;
  if (bytes.size() >= kHeaderSize) {
    header.points = little_endian_number(bytes.data() + 16, 8);
    header.triangles = little_endian_number(bytes.data() + 24, 8);
    header.name = static_cast<std::size_t>(little_endian_number(bytes.data() + 32, 4));
  }
  if (auto fault = find_fault(bytes, header)) return input.error(ErrorCode::malformed, *fault);
  if (auto excess = find_excess(input, header.points)) return std::move(*excess);
  if (header.triangles > kMostTriangles) {
    return input.error(ErrorCode::too_many_points, promise(header) + ", and 32-bit ids allow " +
                                                       std::to_string(kMostTriangles) + ": split the mesh");
  }
  if (auto error = check_size(input, header)) return std::move(*error);
  return header;
}

Result<std::string> read_name(InputFile& input, const TlwHeader& header) {
  std::string name(static_cast<std::size_t>(header.padded_name()), '\0');
  const Result<std::size_t> got = input.read(name.data(), name.size());
  if (!got) return got.error();
  if (*got < name.size())
    return input.error(ErrorCode::malformed, "the file ends in its header: it is cut short");
  name.resize(header.name);
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::any_of(name.begin(), name.end(), control)) {
    return input.error(ErrorCode::malformed,
                       "the name of the coordinate system is no line of text: the file is damaged");
  }
  return name;
}

/// Brings the corners of a block into this machine's byte order and sees that there are such points.
std::optional<Error> check_corners(const InputFile& input, std::size_t first, std::span<IndexTriangle> block,
                                   std::size_t points) {
  const std::span<std::uint32_t> corners(block.front().data(), 3 * block.size());
  if constexpr (std::endian::native != std::endian::little) {
    for (std::uint32_t& c : corners)
      c = static_cast<std::uint32_t>(little_endian_number(reinterpret_cast<const char*>(&c), 4));
  }
  const auto foreign = [=](std::uint32_t corner) { return corner >= points; };
  std::uint32_t largest = 0;
  for (const std::uint32_t corner : corners) largest = std::max(largest, corner);
  if (!foreign(largest)) return std::nullopt;
  const auto at =
      static_cast<std::size_t>(std::find_if(corners.begin(), corners.end(), foreign) - corners.begin());
  return row_error(input, "triangle", first + at / 3,
                   "point " + std::to_string(corners[at]) + " does not exist: there are " +
                       std::to_string(points) + ", numbered from 0");
}

std::optional<Error> read_triangles(InputFile& input, std::uint64_t count, MeshFile& mesh) {
  constexpr std::uint64_t kBlock = 1 << 15;
  if (input.unread().value_or(0) / sizeof(IndexTriangle) >= count)
    reserve_large(mesh.triangles, static_cast<std::size_t>(count));
  while (mesh.triangles.size() < count) {
    const std::size_t first = mesh.triangles.size();
    mesh.triangles.resize(static_cast<std::size_t>(std::min(count, first + kBlock)));
    const std::span<IndexTriangle> block = std::span(mesh.triangles).subspan(first);
    const Result<std::size_t> got = input.read(reinterpret_cast<char*>(block.data()), block.size_bytes());
    if (!got) return got.error();
    if (*got < block.size_bytes())
      return row_error(input, "triangle", first + *got / sizeof(IndexTriangle),
                       "the file ends here: it is cut short");
    if (auto error = check_corners(input, first, block, mesh.points.size())) return error;
  }
  return std::nullopt;
}

}  // namespace

bool begins_as_tlw(std::string_view bytes) noexcept {
  return bytes.starts_with(kMagic.substr(0, 4));
}

Result<MeshFile> parse_tlw(InputFile& input, Faces faces) {
  const Result<TlwHeader> header = parse_header(input);
  if (!header) return header.error();
  input.seek(kHeaderSize);
  Result<std::string> name = read_name(input, *header);
  if (!name) return std::move(name).error();
  Result<std::vector<Point3>> points = read_raw_points(input, header->points, "point");
  if (!points) return std::move(points).error();
  MeshFile mesh;
  mesh.points = std::move(*points);
  mesh.crs = std::move(*name);
  if (faces == Faces::keep) {
    if (auto error = read_triangles(input, header->triangles, mesh)) return std::move(*error);
  }
  // A file has been checked by its size; a pipe shows its own at its end.
  if (auto error = read_rest(input)) return std::move(*error);
  if (auto error = check_size(input, *header)) return std::move(*error);
  return mesh;
}

void write_tlw(OutputFile& output, const MeshView& mesh) {
  const std::string name = mesh.crs.substr(0, kLongestName);
  std::string header(kMagic);
  append_number(header, kVersion, 4);
  append_number(header, kOrderMark, 4);
  append_number(header, mesh.points.size(), 8);
  append_number(header, mesh.triangles.size(), 8);
  append_number(header, name.size(), 4);
  append_number(header, 0, 4);
  header += name;
  header.resize((header.size() + 7) / 8 * 8, '\0');
  output.write(header);
  write_raw_points(output, mesh.points);
  const std::uint32_t* const corners = mesh.triangles.empty() ? nullptr : mesh.triangles.front().data();
  write_raw_numbers(output, std::span(corners, 3 * mesh.triangles.size()));
}

}  // namespace thalweg::io
