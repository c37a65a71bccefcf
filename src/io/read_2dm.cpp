/// 2DM meshes (SMS): `ND id x y z` and `E3T id a b c material`; ids may be any distinct whole numbers from 0.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

constexpr std::int64_t kLargestId = 0xffffffff;

struct Reading {
  MeshFile mesh;                  // triangles hold ids until all nodes are known
  std::vector<std::uint32_t> id;  // of each node
};

bool read_node(TextScanner& scanner, Reading& reading) {
  std::int64_t id = 0;
  Point3 p;
  if (!scanner.whole(id, 0, kLargestId, "the id of the node") || !scanner.number(p.x, "x") ||
      !scanner.number(p.y, "y") || !scanner.number(p.z, "z")) {
    return false;
  }
  reading.id.push_back(static_cast<std::uint32_t>(id));
  reading.mesh.points.push_back(p);
  return true;
}

bool read_triangle(TextScanner& scanner, Reading& reading) {
  std::int64_t id = 0;
  if (!scanner.whole(id, 0, kLargestId, "the id of the element")) return false;
  IndexTriangle triangle{};
  for (std::uint32_t& corner : triangle) {
    if (!scanner.whole(id, 0, kLargestId, "the id of a corner")) return false;
    corner = static_cast<std::uint32_t>(id);
  }
  reading.mesh.triangles.push_back(triangle);
  return true;
}

bool is_other_element(std::string_view keyword) {
  constexpr std::array<std::string_view, 5> kOthers = {"E4Q", "E6T", "E8Q", "E9Q", "E5P"};
  return std::find(kOthers.begin(), kOthers.end(), keyword) != kOthers.end();
}

bool read_line(TextScanner& scanner, Faces faces, Reading& reading) {
  const std::string_view keyword = scanner.word();
  if (keyword == "ND") return read_node(scanner, reading);
  if (faces == Faces::ignore) return true;
  if (keyword == "E3T") return read_triangle(scanner, reading);
  if (is_other_element(keyword)) {
    return scanner.fail("an element " + std::string(keyword) +
                        " has more than 3 nodes: only triangles (E3T) can be read; triangulate it first");
  }
  return true;
}

std::uint64_t line_of(const InputFile& input, std::string_view keyword, std::size_t nth) {
  TextScanner scanner(input.text(), input.name());
  while (scanner.next_line()) {
    if (scanner.word() == keyword && nth-- == 0) break;
  }
  return scanner.line_number();
}

// Nodes by id. In nearly every file node i has id i + 1, and then there is nothing to look up.
class NodeIndex {
 public:
  explicit NodeIndex(const std::vector<std::uint32_t>& id) {
    for (std::size_t i = 0; i < id.size(); ++i) consecutive_ &= id[i] == i + 1;
    count_ = id.size();
    if (consecutive_) return;
    sorted_.reserve(id.size());
    for (std::size_t i = 0; i < id.size(); ++i) sorted_.emplace_back(id[i], static_cast<std::uint32_t>(i));
    std::sort(sorted_.begin(), sorted_.end());
  }

  /// The later of two nodes with the same id, if there are such.
  std::optional<std::uint32_t> find_duplicate() const {
    std::optional<std::uint32_t> first;
    for (std::size_t i = 1; i < sorted_.size(); ++i) {
      if (sorted_[i - 1].first == sorted_[i].first) first = std::min(first.value_or(~0u), sorted_[i].second);
    }
    return first;
  }

  std::optional<std::uint32_t> find(std::uint32_t id) const {
    if (consecutive_) return id >= 1 && id <= count_ ? std::optional(id - 1) : std::nullopt;
    const auto at = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(id, std::uint32_t{0}));
    return at != sorted_.end() && at->first == id ? std::optional(at->second) : std::nullopt;
  }

 private:
  bool consecutive_ = true;
  std::size_t count_ = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted_;
};

}  // namespace

Result<MeshFile> parse_2dm(const InputFile& input, Faces faces) {
  if (auto fault = find_text_fault(input)) return std::move(*fault);
  TextScanner scanner(input.text(), input.name());
  if (!scanner.next_line() || scanner.word() != "MESH2D") {
    return line_error(input.name(), scanner.line_number(),
                      "the first word of a 2DM file must be MESH2D: say what it is with --from");
  }
  Reading reading;
  while (scanner.next_line() && read_line(scanner, faces, reading)) {
  }
  if (scanner.fault()) return *scanner.fault();
  const NodeIndex index(reading.id);
  if (const auto node = index.find_duplicate()) {
    return line_error(
        input.name(), line_of(input, "ND", *node),
        "node " + std::to_string(reading.id[*node]) + " is there already: give each node an id of its own");
  }
  for (std::size_t i = 0; i < reading.mesh.triangles.size(); ++i) {
    for (std::uint32_t& corner : reading.mesh.triangles[i]) {
      const auto vertex = index.find(corner);
      if (!vertex) {
        return line_error(
            input.name(), line_of(input, "E3T", i),
            "node " + std::to_string(corner) + " does not exist: add it or correct the element");
      }
      corner = *vertex;
    }
  }
  return std::move(reading.mesh);
}

}  // namespace thalweg::io
