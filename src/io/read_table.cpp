/// Rows and columns: xyz, csv, tsv.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/number.hpp"
#include "io/parallel.hpp"
#include "io/readers.hpp"
#include "io/table_layout.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};

/// The columns to parse, from left to right, and the axis each is for.
struct RowPlan {
  char delimiter = ' ';
  std::array<std::size_t, 3> column{};
  std::array<std::size_t, 3> axis{};
  std::optional<double> nodata;
};

RowPlan plan_rows(const TableLayout& layout, const ReadOptions& options) {
  RowPlan plan{layout.delimiter, {}, {0, 1, 2}, options.nodata};
  std::sort(plan.axis.begin(), plan.axis.end(),
            [&](std::size_t a, std::size_t b) { return layout.column[a] < layout.column[b]; });
  for (std::size_t i = 0; i < 3; ++i) plan.column[i] = layout.column[plan.axis[i]];
  return plan;
}

/// Walks over the fields of one line. With blanks as delimiter a run of them separates, else every delimiter
/// does.
template <bool by_blanks>
class FieldCursor {
 public:
  FieldCursor(const char* first, const char* last, char delimiter)
      : at_(first), last_(last), delimiter_(delimiter) {}

  /// Whether the line may be a comment, whose words are no fields.
  bool at_comment() {
    skip_blanks();
    return at_ != last_ && (*at_ == '#' || *at_ == '/');
  }

  bool skip_field() {
    skip_blanks();
    if (at_ == last_ || *at_ == '"') return false;
    if constexpr (by_blanks) {
      while (at_ != last_ && !is_blank(*at_)) ++at_;
      return true;
    } else {
      at_ = static_cast<const char*>(std::memchr(at_, delimiter_, static_cast<std::size_t>(last_ - at_)));
      if (at_ == nullptr) return false;
      ++at_;
      return true;
    }
  }

  bool number(double& value) {
    skip_blanks();
    at_ = scan_number(at_, last_, value);
    if (at_ == nullptr) return false;
    if constexpr (by_blanks) return at_ == last_ || is_blank(*at_);
    skip_blanks();
    if (at_ == last_) return true;
    return *at_++ == delimiter_;
  }

 private:
  bool is_blank(char c) const { return c == ' ' || (c == '\t' && (by_blanks || delimiter_ != '\t')); }
  void skip_blanks() {
    while (at_ != last_ && is_blank(*at_)) ++at_;
  }

  const char* at_;
  const char* last_;
  char delimiter_;
};

// The common row, fast. False for anything out of the ordinary, faults included: study_row decides then.
template <bool by_blanks>
bool scan_row(const char* first, const char* last, const RowPlan& plan, std::array<double, 3>& place) {
  FieldCursor<by_blanks> cursor(first, last, plan.delimiter);
  if (cursor.at_comment()) return false;
  std::size_t column = 0;
  for (std::size_t i = 0; i < 3; ++i, ++column) {
    for (; column < plan.column[i]; ++column) {
      if (!cursor.skip_field()) return false;
    }
    if (!cursor.number(place[plan.axis[i]])) return false;
  }
  return true;
}

enum class RowKind { point, nodata, nothing, faulty };

struct RowStudy {
  RowKind kind = RowKind::faulty;
  std::string fault;
};

RowStudy study_fields(const std::vector<std::string_view>& fields, const RowPlan& plan,
                      std::array<double, 3>& place) {
  if (std::all_of(fields.begin(), fields.end(), [](std::string_view f) { return f.empty(); })) {
    return {RowKind::nothing, {}};  // spreadsheets end with rows of nothing but delimiters
  }
  const bool skips_nan = plan.nodata && std::isnan(*plan.nodata);
  bool nan_skipped = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = plan.axis[i];
    const std::string which =
        "column " + std::to_string(plan.column[i] + 1) + " (" + std::string(kAxes[axis]) + ") ";
    if (plan.column[i] >= fields.size()) {
      return {RowKind::faulty, which + "is missing: there " + (fields.size() == 1 ? "is" : "are") + " only " +
                                   std::to_string(fields.size()) +
                                   (fields.size() == 1 ? " column" : " columns") +
                                   " here; complete the row, or say which columns to read with --columns"};
    }
    const ParsedNumber parsed = parse_number(fields[plan.column[i]]);
    place[axis] = parsed.value;
    if (axis == 2 && skips_nan && parsed.fault == NumberFault::nan) {
      nan_skipped = true;
    } else if (parsed.fault != NumberFault::none) {
      return {RowKind::faulty, which + describe(parsed.fault, fields[plan.column[i]])};
    }
  }
  return {nan_skipped ? RowKind::nodata : RowKind::point, {}};
}

// The uncommon row: quotes, a comment at its end, NaN, a fault. Slow, and in words.
RowStudy study_row(std::string_view line, const RowPlan& plan, std::array<double, 3>& place) {
  std::vector<std::string_view> fields;
  split_fields(line, plan.delimiter, fields);
  RowStudy study = study_fields(fields, plan, place);
  const std::size_t comment = line.find('#');
  if (study.kind != RowKind::faulty || comment == std::string_view::npos) return study;
  split_fields(line.substr(0, comment), plan.delimiter, fields);
  RowStudy shorter = study_fields(fields, plan, place);
  return shorter.kind == RowKind::point || shorter.kind == RowKind::nodata ? shorter : study;
}

/// What came of one part of the text.
struct Part {
  std::string_view text;
  std::vector<Point3> points;
  std::uint64_t skipped = 0;
  std::uint64_t lines = 0;  // up to the fault, if there is one
  std::optional<std::string> fault;
};

template <bool by_blanks>
void parse_part(const RowPlan& plan, Part& part) {
  constexpr std::size_t kShortestRow = 6;  // "1 2 3\n"
  const auto newlines = static_cast<std::size_t>(std::count(part.text.begin(), part.text.end(), '\n'));
  part.points.reserve(std::min(newlines, part.text.size() / kShortestRow) + 1);
  const char* at = part.text.data();
  const char* const last = at + part.text.size();
  std::array<double, 3> place{};
  while (at != last) {
    const void* newline = std::memchr(at, '\n', static_cast<std::size_t>(last - at));
    const char* const stop = newline != nullptr ? static_cast<const char*>(newline) : last;
    const char* const end = stop != at && stop[-1] == '\r' ? stop - 1 : stop;
    const std::string_view line(at, static_cast<std::size_t>(end - at));
    at = newline != nullptr ? stop + 1 : last;
    ++part.lines;
    RowKind kind = RowKind::point;
    if (!scan_row<by_blanks>(line.data(), end, plan, place)) {
      if (is_comment_or_blank(line)) continue;
      RowStudy study = study_row(line, plan, place);
      kind = study.kind;
      if (kind == RowKind::faulty) {
        part.fault = std::move(study.fault);
        return;
      }
    }
    if (kind == RowKind::nothing) continue;
    if (kind == RowKind::nodata || (plan.nodata && place[2] == *plan.nodata)) {
      ++part.skipped;
    } else {
      part.points.push_back({place[0], place[1], place[2]});
    }
  }
}

// Cuts the text into parts of about equal size that end at line ends.
std::vector<Part> cut(std::string_view text, std::size_t count) {
  std::vector<Part> parts;
  while (count > 1 && !text.empty()) {
    const std::size_t newline = text.find('\n', text.size() / count);
    if (newline == std::string_view::npos) break;
    parts.emplace_back().text = text.substr(0, newline + 1);
    text.remove_prefix(newline + 1);
    --count;
  }
  parts.emplace_back().text = text;
  return parts;
}

}  // namespace

Result<PointTable> parse_table(const InputFile& input, const ReadOptions& options) {
  if (auto fault = find_text_fault(input)) return std::move(*fault);
  Result<TableLayout> layout = find_layout(input, options.columns);
  if (!layout) return std::move(layout).error();

  constexpr std::size_t kSmallestPart = std::size_t{1} << 16;
  const RowPlan plan = plan_rows(*layout, options);
  const std::size_t most = std::max<std::size_t>(1, layout->body.size() / kSmallestPart);
  std::vector<Part> parts = cut(layout->body, std::min<std::size_t>(std::max(1u, options.threads), most));
  run_all(parts.size(), [&](std::size_t i) {
    plan.delimiter == ' ' ? parse_part<true>(plan, parts[i]) : parse_part<false>(plan, parts[i]);
  });

  PointTable table;
  std::uint64_t line = layout->first_line - 1;
  std::size_t total = 0;
  for (const Part& part : parts) {
    line += part.lines;
    if (part.fault) return line_error(input.name, line, *part.fault);
    total += part.points.size();
    table.skipped_nodata += part.skipped;
  }
  table.points = std::move(parts[0].points);
  if (parts.size() > 1) table.points.reserve(total);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    table.points.insert(table.points.end(), parts[i].points.begin(), parts[i].points.end());
    parts[i].points = {};
  }
  return table;
}

}  // namespace thalweg::io
