/// Segments for the hard instances, from a file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/read_options.hpp"
#include "thalweg/hard_instances.hpp"

namespace thalweg::io {

struct SegmentFile {
  std::string name;  ///< for messages
  std::vector<LatticeSegment> segments;
  std::vector<std::uint64_t> lines;  ///< where each segment was

  /// `error` about these segments as one about the file: "NAME:LINE: what", malformed.
  Error located(const Error& error) const;
};

/// The segments of the file at `path`, four whole numbers x1 y1 x2 y2 a line; blank lines and those that
/// begin with # are skipped; "-" is stdin. Errors: unreadable, malformed, cancelled; "FILE:LINE: what, and
/// what to do".
Result<SegmentFile> read_segments(const std::string& path, const ReadOptions& options = {});

}  // namespace thalweg::io
