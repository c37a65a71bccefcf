/// The geometry of a report as the page decodes it (src/io/report/payload.js): small numbers in few bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/report.hpp"

namespace thalweg::io {

/// Places as the page holds them: origin + unit * (a 32-bit float). The origin is the middle of the range, so
/// that neither overflows; the unit is 1, or a power of two where floats could not span the range.
struct FloatFrame {
  double origin = 0;
  double unit = 1;

  /// Requires: low <= high, finite.
  static FloatFrame around(double low, double high) noexcept;
  float operator()(double value) const noexcept;
  /// What the page makes of a float, in the same arithmetic; infinite where that is beyond all doubles.
  double value(float held) const noexcept;
};

/// One axis of the drawn vertices.
struct PackedAxis {
  FloatFrame frame;
  double steps = 0;
  std::optional<unsigned> residual_bytes;  ///< of each vertex; see report_residual.hpp. None: floats alone
};

/// So many vertices have all their digits in the page; of more, only axes that need no bytes for it.
inline constexpr std::size_t kMostExactVertices = 200'000;

/// Vertices are sorted along a space-filling curve, so that neighbours have close numbers, and everything
/// that refers to vertices is written as differences, seven bits a byte:
///
///     x, y, z       32-bit floats of the frames: all first bytes, all second bytes, ...
///     names         difference to the one before
///     common        three a triangle: first corner less that of the triangle before, the others less the
///     first before        the same after         the same, then the order of each downstream    before: next
///     vertex less the vertex, 0 at sinks; after: where it differs, (gap, the same)
///     residuals     of x, y, z, see report_residual.hpp
struct Payload {
  PackedAxis x, y, z;
  std::vector<std::uint32_t> position;  ///< of each vertex of the report among those of the page
  std::vector<std::uint8_t> bytes;      ///< the sections one after the other
  std::size_t changed_flows = 0;        ///< vertices whose next one differs
};

Payload pack(const Report& report);

/// Base64 of RFC 4648, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace thalweg::io
