/// ESRI ASCII grids: a header of keys and values, then the values row by row from the north-west.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/number.hpp"
#include "io/readers.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

struct GridHeader {
  std::optional<std::int64_t> columns, rows;
  std::optional<double> x_corner, x_center, y_corner, y_center, size, dx, dy, nodata;
};

bool read_count(TextScanner& scanner, std::string_view key, std::optional<std::int64_t>& slot) {
  constexpr std::int64_t kMost = 0x7fffffff;
  std::int64_t value = 0;
  if (!scanner.whole(value, 1, kMost, key)) return false;
  slot = value;
  return true;
}

bool read_value(TextScanner& scanner, std::string_view key, std::optional<double>& slot) {
  double value = 0;
  if (!scanner.number(value, key)) return false;
  slot = value;
  return true;
}

bool read_nodata(TextScanner& scanner, std::optional<double>& slot) {
  const std::string_view token = scanner.word();
  const ParsedNumber parsed = parse_number(token);
  // GDAL writes NODATA_value nan, and infinities for what does not fit.
  if (parsed.fault != NumberFault::none && parsed.fault != NumberFault::nan &&
      parsed.fault != NumberFault::infinite) {
    return scanner.fail("NODATA_value " + describe(parsed.fault, token));
  }
  slot = parsed.value;
  return true;
}

// One line of the header, of which `key` is the first word. False with a fault.
bool read_key(TextScanner& scanner, std::string_view key, GridHeader& header) {
  if (same_word(key, "ncols")) return read_count(scanner, key, header.columns);
  if (same_word(key, "nrows")) return read_count(scanner, key, header.rows);
  if (same_word(key, "nodata_value") || same_word(key, "nodata")) return read_nodata(scanner, header.nodata);
  const std::pair<std::string_view, std::optional<double>*> slots[] = {{"xllcorner", &header.x_corner},
                                                                       {"xllcenter", &header.x_center},
                                                                       {"xllcentre", &header.x_center},
                                                                       {"yllcorner", &header.y_corner},
                                                                       {"yllcenter", &header.y_center},
                                                                       {"yllcentre", &header.y_center},
                                                                       {"cellsize", &header.size},
                                                                       {"dx", &header.dx},
                                                                       {"dy", &header.dy}};
  for (const auto& [name, slot] : slots) {
    if (same_word(key, name)) return read_value(scanner, key, *slot);
  }
  return scanner.fail(
      in_quotes(key) +
      " is no header of an ESRI ASCII grid (ncols, nrows, xllcorner or xllcenter, yllcorner or "
      "yllcenter, cellsize or dx and dy, NODATA_value): correct it, or say the format with --from");
}

// Reads keys up to the first line that starts with a value, and stays on that line. False with a fault, or at
// the end.
bool read_header(TextScanner& scanner, GridHeader& header) {
  while (scanner.next_line()) {
    const std::string_view line = scanner.rest();
    const std::string_view key = line.substr(0, line.find_first_of(" \t"));
    const NumberFault fault = parse_number(key).fault;
    if (fault == NumberFault::none || fault == NumberFault::nan || fault == NumberFault::infinite)
      return true;
    scanner.word();
    if (!read_key(scanner, key, header)) return false;
  }
  return false;
}

std::optional<std::string_view> missing_key(const GridHeader& header) {
  if (!header.columns) return "ncols";
  if (!header.rows) return "nrows";
  if (!header.x_corner && !header.x_center) return "xllcorner or xllcenter";
  if (!header.y_corner && !header.y_center) return "yllcorner or yllcenter";
  if (!header.size && !(header.dx && header.dy)) return "cellsize";
  return std::nullopt;
}

// Centres of cells from the lower left corner or from the centre of the lower left cell, by rising
// coordinate.
std::vector<double> centers(std::uint32_t count, std::optional<double> center, std::optional<double> corner,
                            double step) {
  std::vector<double> out(count);
  for (std::uint32_t i = 0; i < count; ++i) out[i] = center ? *center + i * step : *corner + (i + 0.5) * step;
  return out;
}

// Fills everything but the values. An error in words if the header makes no grid.
std::optional<std::string> lay_out(const GridHeader& header, Grid& grid) {
  grid.dx = header.dx && header.dy ? *header.dx : *header.size;
  grid.dy = header.dx && header.dy ? *header.dy : *header.size;
  if (!(grid.dx > 0) || !(grid.dy > 0)) return "the size of a cell must be above 0: correct cellsize";
  grid.x = centers(grid.columns, header.x_center, header.x_corner, grid.dx);
  grid.y = centers(grid.rows, header.y_center, header.y_corner, grid.dy);
  const auto faulty = [](const std::vector<double>& v) {
    return !std::isfinite(v.front()) || !std::isfinite(v.back()) ||
           std::adjacent_find(v.begin(), v.end(), [](double a, double b) { return !(a < b); }) != v.end();
  };
  if (faulty(grid.x) || faulty(grid.y)) {
    return "the centres of the cells are not distinct finite numbers: correct the corner or cellsize";
  }
  std::reverse(grid.y.begin(), grid.y.end());
  return std::nullopt;
}

// Values from the current line to the end of the text. False with a fault.
bool read_values(TextScanner& scanner, std::uint64_t cells, Grid& grid) {
  do {
    while (!scanner.at_line_end()) {
      double value = 0;
      if (!scanner.try_number(value)) {
        const std::string_view token = scanner.word();
        const ParsedNumber parsed = parse_number(token);
        value = parsed.value;
        const bool legal = (parsed.fault == NumberFault::nan && std::isnan(grid.nodata)) ||
                           (parsed.fault == NumberFault::infinite && value == grid.nodata);
        if (!legal) {
          const std::uint64_t index = grid.values.size();
          return scanner.fail("the value of row " + std::to_string(index / grid.columns + 1) + ", column " +
                              std::to_string(index % grid.columns + 1) + " " + describe(parsed.fault, token));
        }
      }
      if (grid.values.size() == cells) {
        return scanner.fail("more values than the " + std::to_string(cells) + " of " +
                            std::to_string(grid.columns) + " columns times " + std::to_string(grid.rows) +
                            " rows: correct ncols or nrows");
      }
      grid.values.push_back(value);
    }
  } while (scanner.next_line());
  return true;
}

}  // namespace

Result<Grid> parse_grid(const InputFile& input, const ReadOptions& options) {
  if (auto fault = find_text_fault(input)) return std::move(*fault);
  TextScanner scanner(input.text(), input.name(), 0);
  GridHeader header;
  const bool has_values = read_header(scanner, header);
  if (scanner.fault()) return *scanner.fault();
  if (const auto key = missing_key(header)) {
    return line_error(input.name(), scanner.line_number(),
                      "the header has no " + std::string(*key) + ": an ESRI ASCII grid needs it");
  }
  Grid grid;
  grid.columns = static_cast<std::uint32_t>(*header.columns);
  grid.rows = static_cast<std::uint32_t>(*header.rows);
  grid.nodata = options.nodata ? *options.nodata : header.nodata.value_or(-9999);
  const std::uint64_t cells = std::uint64_t{grid.columns} * grid.rows;
  // A value takes two bytes at least, so a header cannot ask for more room than the file accounts for.
  grid.values.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(cells, input.bytes().size() / 2 + 1)));
  if (has_values && !read_values(scanner, cells, grid)) return *scanner.fault();
  if (grid.values.size() < cells) {
    return line_error(input.name(), scanner.line_number(),
                      "the file ends after " + std::to_string(grid.values.size()) + " of the " +
                          std::to_string(cells) + " values that " + std::to_string(grid.columns) +
                          " columns times " + std::to_string(grid.rows) +
                          " rows need: it is cut short, or ncols or nrows is wrong");
  }
  if (auto fault = lay_out(header, grid)) return input.error(ErrorCode::malformed, *fault);
  return grid;
}

}  // namespace thalweg::io
