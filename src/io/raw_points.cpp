#include "io/raw_points.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <string>
#include <utility>

#include "io/readers.hpp"
#include "io/scalar.hpp"

namespace thalweg::io {
namespace {

static_assert(sizeof(Point3) == 24, "points lie in memory as in the files");

/// Writes items that a little endian machine has in memory as the file wants them.
template <class Item, class Append>
void write_items(OutputFile& output, std::span<const Item> items, Append&& append) {
  if constexpr (std::endian::native == std::endian::little) {
    output.write({reinterpret_cast<const char*>(items.data()), items.size_bytes()});
    return;
  }
  std::string bytes;
  for (const Item& item : items) {
    if (output.error()) return;
    append(bytes, item);
    output.write(std::exchange(bytes, {}));
  }
}

}  // namespace

Error row_error(const InputFile& input, std::string_view row, std::uint64_t index, std::string_view what) {
  return input.error(ErrorCode::malformed,
                     std::string(row) + " " + std::to_string(index) + " (from 0): " + std::string(what));
}

Result<std::vector<Point3>> read_raw_points(InputFile& input, std::uint64_t count, std::string_view row,
                                            bool nan_z) {
  constexpr std::uint64_t kBlock = 1 << 15;  // stays in a core's cache between its steps
  std::vector<Point3> points;
  if (input.unread().value_or(0) / sizeof(Point3) >= count)
    reserve_large(points, static_cast<std::size_t>(count));
  while (points.size() < count) {
    const std::size_t first = points.size();
    points.resize(static_cast<std::size_t>(std::min(count, first + kBlock)));
    const std::span<Point3> block = std::span(points).subspan(first);
    const Result<std::size_t> got = input.read(reinterpret_cast<char*>(block.data()), block.size_bytes());
    if (!got) return got.error();
    if (*got < block.size_bytes())
      return row_error(input, row, first + *got / sizeof(Point3), "the file ends here: it is cut short");
    from_little_endian(block);
    if (const auto fault = find_not_finite(block, nan_z))
      return row_error(input, row, first + fault->index, fault->what);
  }
  return points;
}

std::optional<Error> read_rest(InputFile& input) {
  std::string scratch(1 << 16, '\0');
  for (;;) {
    const Result<std::size_t> got = input.read(scratch.data(), scratch.size());
    if (!got) return got.error();
    if (*got == 0) return std::nullopt;
  }
}

void write_raw_points(OutputFile& output, std::span<const Point3> points) {
  write_items(output, points, [](std::string& bytes, const Point3& p) {
    for (const double value : {p.x, p.y, p.z}) append_number(bytes, std::bit_cast<std::uint64_t>(value), 8);
  });
}

void write_raw_numbers(OutputFile& output, std::span<const std::uint32_t> numbers) {
  write_items(output, numbers,
              [](std::string& bytes, std::uint32_t value) { append_number(bytes, value, 4); });
}

std::uint64_t little_endian_number(const char* bytes, std::size_t size) noexcept {
  std::uint64_t value = 0;
  while (size-- > 0) value = value << 8 | static_cast<unsigned char>(bytes[size]);
  return value;
}

void append_number(std::string& out, std::uint64_t value, std::size_t size) {
  for (; size > 0; --size, value >>= 8) out += static_cast<char>(value & 0xff);
}

}  // namespace thalweg::io
