/// Reads segments, a line each.
#include "io/read_segments.hpp"

#include <utility>

#include "io/input_file.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

/// Larger numbers are read, so that the library says how large they may be; differences must not overflow.
constexpr std::int64_t kMostWhole = std::int64_t{1} << 53;

bool read_point(TextScanner& scanner, LatticePoint& point, const char* x, const char* y) {
  return scanner.whole(point.x, -kMostWhole, kMostWhole, x) &&
         scanner.whole(point.y, -kMostWhole, kMostWhole, y);
}

bool read_segment(TextScanner& scanner, LatticeSegment& segment) {
  if (!read_point(scanner, segment.a, "x1", "y1") || !read_point(scanner, segment.b, "x2", "y2"))
    return false;
  if (scanner.at_line_end()) return true;
  return scanner.fail("a segment is four whole numbers x1 y1 x2 y2: remove what follows them");
}

}  // namespace

Error SegmentFile::located(const Error& error) const {
  if (error.rows.empty()) return {ErrorCode::malformed, name + ": " + error.message, {}};
  return line_error(name, lines[error.rows.front()], error.message);
}

Result<SegmentFile> read_segments(const std::string& path, const ReadOptions& options) {
  const Result<InputFile> input = read_input(path, options);
  if (!input) return input.error();
  if (auto fault = find_text_fault(*input)) return *std::move(fault);
  TextScanner scanner(input->text(), input->name());
  SegmentFile file;
  file.name = input->name();
  LatticeSegment segment;
  while (scanner.next_line() && read_segment(scanner, segment)) {
    file.segments.push_back(segment);
    file.lines.push_back(scanner.line_number());
  }
  if (scanner.fault()) return *scanner.fault();
  return file;
}

}  // namespace thalweg::io
