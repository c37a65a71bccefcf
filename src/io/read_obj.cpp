/// Wavefront OBJ: `v x y z` and `f a b c`; everything else in it is no concern of a terrain and skipped.
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

#include "io/number.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

// The vertex of a corner `v`, `v/vt`, `v//vn` or `v/vt/vn`, from 0. A negative one counts back from the last
// vertex read; a positive one may name a vertex that comes later, so its upper end is checked when all are
// known.
bool read_corner(TextScanner& scanner, std::string_view token, std::uint64_t vertex_count,
                 std::uint32_t& vertex) {
  const char* const last = token.data() + token.size();
  std::int64_t number = 0;
  const auto [end, fault] = std::from_chars(token.data(), last, number);
  if (end == token.data() || (end != last && *end != '/')) {
    return scanner.fail(in_quotes(token) + " is not the number of a vertex: correct the face");
  }
  const auto count = static_cast<std::int64_t>(vertex_count);
  const bool in_range =
      fault == std::errc() &&
      (number > 0 ? static_cast<std::uint64_t>(number) <= kMostPoints : number < 0 && number >= -count);
  if (!in_range) {
    return scanner.fail("vertex " + in_quotes(token) + " does not exist: there are " + std::to_string(count) +
                        " so far, numbered from 1");
  }
  vertex = static_cast<std::uint32_t>(number > 0 ? number - 1 : count + number);
  return true;
}

bool read_face(TextScanner& scanner, MeshFile& mesh) {
  IndexTriangle triangle{};
  std::size_t corners = 0;
  for (std::string_view token = scanner.word(); !token.empty(); token = scanner.word(), ++corners) {
    if (corners < 3 && !read_corner(scanner, token, mesh.points.size(), triangle[corners])) return false;
  }
  if (corners != 3) {
    return scanner.fail("a face with " + std::to_string(corners) +
                        " corners: only triangles can be read; triangulate it first");
  }
  mesh.triangles.push_back(triangle);
  return true;
}

bool read_line(TextScanner& scanner, Faces faces, MeshFile& mesh) {
  const std::string_view keyword = scanner.word();
  if (keyword == "v") {
    Point3 p;
    if (!scanner.number(p.x, "x") || !scanner.number(p.y, "y") || !scanner.number(p.z, "z")) return false;
    mesh.points.push_back(p);
  } else if (keyword == "f" && faces == Faces::keep) {
    return read_face(scanner, mesh);
  }
  return true;
}

// The line of a face, found again only once it is known to be faulty.
std::uint64_t line_of_face(const InputFile& input, std::size_t face) {
  TextScanner scanner(input.text(), input.name());
  while (scanner.next_line()) {
    if (scanner.word() == "f" && face-- == 0) break;
  }
  return scanner.line_number();
}

}  // namespace

Result<MeshFile> parse_obj(const InputFile& input, Faces faces) {
  if (auto fault = find_text_fault(input)) return std::move(*fault);
  MeshFile mesh;
  TextScanner scanner(input.text(), input.name());
  while (scanner.next_line() && read_line(scanner, faces, mesh)) {
  }
  if (scanner.fault()) return *scanner.fault();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (const std::uint32_t vertex : mesh.triangles[i]) {
      if (vertex < mesh.points.size()) continue;
      return line_error(input.name(), line_of_face(input, i),
                        "vertex " + std::to_string(std::uint64_t{vertex} + 1) +
                            " does not exist: there are " + std::to_string(mesh.points.size()) +
                            ", numbered from 1");
    }
  }
  return mesh;
}

}  // namespace thalweg::io
