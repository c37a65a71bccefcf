#include "io/npy.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/byte_window.hpp"
#include "io/npy_header.hpp"
#include "io/raw_points.hpp"
#include "io/scalar.hpp"

namespace thalweg::io {
namespace {

std::optional<Error> check_size(const InputFile& input, const NpyHeader& header) {
  const auto size = input.size();
  const std::uint64_t promised = header.size + 3 * size_of(header.type) * header.rows;
  if (!size || *size == promised) return std::nullopt;
  return input.error(
      ErrorCode::malformed,
      "an array of shape (" + std::to_string(header.rows) + ", 3) takes " + std::to_string(promised) +
          " bytes, but the file has " + std::to_string(*size) + ": it is " +
          (*size < promised ? "cut short or damaged" : "damaged, or holds more than one array"));
}

/// Values that are in the file as another type, or in another order.
class ValueReader {
 public:
  ValueReader(InputFile& input, const NpyHeader& header, bool nan_z)
      : input_(input), header_(header), nan_z_(nan_z), window_(input, header.size) {}

  Result<std::vector<Point3>> read() {
    if (input_.unread().value_or(0) / (3 * size_of(header_.type)) >= header_.rows)
      reserve_large(points_, static_cast<std::size_t>(header_.rows));
    for (std::size_t axis = 0; axis < 3; axis += header_.fortran_order ? 1 : 3) {
      if (auto error = read_values(axis)) return std::move(*error);
    }
    return std::move(points_);
  }

 private:
  /// Row by row all three columns, or else one column.
  std::optional<Error> read_values(std::size_t axis) {
    const std::size_t size = size_of(header_.type);
    const std::size_t stride = header_.fortran_order ? size : 3 * size;
    for (std::uint64_t row = 0; row < header_.rows;) {
      const Result<std::string_view> bytes = window_.peek(stride);
      if (!bytes) return bytes.error();
      const auto count =
          static_cast<std::size_t>(std::min<std::uint64_t>(bytes->size() / stride, header_.rows - row));
      if (count == 0) return row_error(input_, "row", row, "the file ends here: it is cut short");
      const auto first = static_cast<std::size_t>(row);
      if (first + count > points_.size()) points_.resize(first + count);
      const std::span<Point3> block = std::span(points_).subspan(first, count);
      for (std::size_t i = 0; i < stride / size; ++i)
        convert({header_.type, i * size, header_.swap}, bytes->data(), stride, axis + i, block);
      if (const auto fault = find_not_finite(block, nan_z_)) return fault_of(first, *fault);
      window_.advance(count * stride);
      row += count;
    }
    return std::nullopt;
  }

  Error fault_of(std::size_t first, const PointFault& fault) const {
    const std::string what =
        is_real(header_.type)
            ? fault.what
            : std::string(1, fault.what[0]) + " is beyond 2^53 and no double equals it: subtract an offset";
    return row_error(input_, "row", first + fault.index, what);
  }

  InputFile& input_;
  const NpyHeader& header_;
  bool nan_z_;
  ByteWindow window_;
  std::vector<Point3> points_;
};

}  // namespace

bool begins_as_npy(std::string_view bytes) noexcept {
  return bytes.starts_with(kNpyMagic);
}

Result<PointTable> parse_npy(InputFile& input, const ReadOptions& options) {
  const Result<NpyHeader> header = parse_npy_header(input);
  if (!header) return header.error();
  if (auto excess = find_excess(input, header->rows)) return std::move(*excess);
  if (auto error = check_size(input, *header)) return std::move(*error);
  const bool nan_z = options.nodata && std::isnan(*options.nodata) && is_real(header->type);
  const bool raw = header->type == ScalarType::float64 && !header->fortran_order &&
                   header->swap == (std::endian::native != std::endian::little);
  input.seek(header->size);
  Result<std::vector<Point3>> points =
      raw ? read_raw_points(input, header->rows, "row", nan_z) : ValueReader(input, *header, nan_z).read();
  if (!points) return std::move(points).error();
  // A file has been checked by its size; a pipe shows its own at its end.
  if (auto error = read_rest(input)) return std::move(*error);
  if (auto error = check_size(input, *header)) return std::move(*error);
  PointTable table;
  table.points = std::move(*points);
  return table;
}

void write_npy(OutputFile& output, std::span<const Point3> points) {
  output.write(npy_header("<f8", points.size()));
  write_raw_points(output, points);
}

void write_npy(OutputFile& output, std::span<const IndexTriangle> triangles) {
  output.write(npy_header("<u4", triangles.size()));
  const std::uint32_t* const corners = triangles.empty() ? nullptr : triangles.front().data();
  write_raw_numbers(output, std::span(corners, 3 * triangles.size()));
}

}  // namespace thalweg::io
