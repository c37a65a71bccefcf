/// What the user may say about an input file.
#pragma once

#include <atomic>
#include <optional>
#include <string>

namespace thalweg::io {

struct ReadOptions {
  /// Name of the format (`--from`); empty: by the suffix, and for stdin by the content.
  std::string format = {};
  /// `--columns`: three names from the header, or numbers from 1, in the order x, y, z: "lon,lat,z" or
  /// "1,2,5". Used by the formats of rows and columns (xyz, csv, tsv) alone.
  std::string columns = {};
  /// Rows or cells with exactly this z are skipped and counted. May be NaN: then a z of NaN is skipped, not
  /// refused.
  std::optional<double> nodata = std::nullopt;
  /// Rows are parsed by this many threads, 0 for all of the machine; the result does not depend on it.
  unsigned threads = 1;
  /// Set by another thread or a signal handler to make reading stop with ErrorCode::cancelled.
  const std::atomic<bool>* cancel = nullptr;
};

}  // namespace thalweg::io
