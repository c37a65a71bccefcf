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

#include "io/line_blocks.hpp"
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

/// Walks over the fields of the line at `first`. With blanks as delimiter a run of them separates, else every
/// delimiter does.
template <bool by_blanks>
class FieldCursor {
 public:
  /// `last`: the end of the text.
  FieldCursor(const char* first, const char* last, char delimiter)
      : at_(first), last_(last), delimiter_(delimiter) {}

  const char* position() const { return at_; }

  /// Whether the line may be a comment, whose words are no fields.
  bool at_comment() {
    skip_blanks();
    return at_ != last_ && (*at_ == '#' || *at_ == '/');
  }

  bool skip_field() {
    skip_blanks();
    if (at_ != last_ && *at_ == '"') return false;
    while (at_ != last_ && *at_ != '\n' && !(by_blanks ? is_blank(*at_) : *at_ == delimiter_)) ++at_;
    if (at_ == last_ || *at_ == '\n') return false;
    if constexpr (!by_blanks) ++at_;
    return true;
  }

  bool number(double& value) {
    skip_blanks();
    at_ = scan_number(at_, last_, value);
    if (at_ == nullptr) return false;
    if constexpr (by_blanks) return at_line_end() || is_blank(*at_);
    skip_blanks();
    return at_line_end() || *at_++ == delimiter_;
  }

 private:
  bool is_blank(char c) const { return c == ' ' || (c == '\t' && (by_blanks || delimiter_ != '\t')); }
  void skip_blanks() {
    while (at_ != last_ && is_blank(*at_)) ++at_;
  }
  bool at_line_end() const {
    if (at_ == last_ || *at_ == '\n') return true;
    return *at_ == '\r' && (at_ + 1 == last_ || at_[1] == '\n');
  }

  const char* at_;
  const char* last_;
  char delimiter_;
};

// The common row, fast: where its last number ends. nullptr for anything out of the ordinary, faults
// included: study_row decides then.
template <bool by_blanks>
const char* scan_row(const char* first, const char* last, const RowPlan& plan, std::array<double, 3>& place) {
  FieldCursor<by_blanks> cursor(first, last, plan.delimiter);
  if (cursor.at_comment()) return nullptr;
  std::size_t column = 0;
  for (std::size_t i = 0; i < 3; ++i, ++column) {
    for (; column < plan.column[i]; ++column) {
      if (!cursor.skip_field()) return nullptr;
    }
    if (!cursor.number(place[plan.axis[i]])) return nullptr;
  }
  return cursor.position();
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

/// What came of one part of the text, with line ends at its borders.
struct Part {
  std::string_view text;
  std::uint64_t skipped = 0;
  std::uint64_t lines = 0;  // up to the fault, if there is one
  std::optional<std::string> fault;
};

// The end of the line in which `at` is: its line end, or that of the text.
const char* line_end(const char* at, const char* last) {
  const void* newline = std::memchr(at, '\n', static_cast<std::size_t>(last - at));
  return newline != nullptr ? static_cast<const char*>(newline) : last;
}

template <bool by_blanks>
void parse_part(const RowPlan& plan, Part& part, std::vector<Point3>& points) {
  const char* at = part.text.data();
  const char* const last = at + part.text.size();
  std::array<double, 3> place{};
  while (at != last) {
    ++part.lines;
    RowKind kind = RowKind::point;
    const char* stop = scan_row<by_blanks>(at, last, plan, place);
    if (stop != nullptr) {
      if (stop != last && *stop != '\n') stop = line_end(stop, last);
    } else {
      stop = line_end(at, last);
      const char* const end = stop != at && stop[-1] == '\r' ? stop - 1 : stop;
      const std::string_view line(at, static_cast<std::size_t>(end - at));
      RowStudy study{RowKind::nothing, {}};
      if (!is_comment_or_blank(line)) study = study_row(line, plan, place);
      kind = study.kind;
      if (kind == RowKind::faulty) {
        part.fault = std::move(study.fault);
        return;
      }
    }
    at = stop != last ? stop + 1 : last;
    if (kind == RowKind::nothing) continue;
    if (kind == RowKind::nodata || (plan.nodata && place[2] == *plan.nodata)) {
      ++part.skipped;
    } else {
      points.push_back({place[0], place[1], place[2]});
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

/// Parses a text block by block, the parts of a block at once.
class TableReader {
 public:
  TableReader(InputFile& input, const TableLayout& layout, const ReadOptions& options)
      : input_(input),
        plan_(plan_rows(layout, options)),
        threads_(resolve_threads(options.threads)),
        blocks_(input, std::min<std::size_t>(threads_, kMostParts) * kPartSize),
        line_(layout.first_line) {}

  Result<PointTable> read() {
    for (;;) {
      const Result<std::string_view> block = blocks_.next();
      if (!block) return block.error();
      if (block->empty()) return std::move(table_);
      if (auto error = add(*block)) return std::move(*error);
    }
  }

  /// A NUL byte in what has not been read yet; it tells more than any fault before it.
  std::optional<Error> find_nul_in_rest(std::uint64_t first_line) {
    for (std::uint64_t line = first_line;;) {
      const Result<std::string_view> block = blocks_.next();
      if (!block) return block.error();
      if (block->empty()) return std::nullopt;
      if (auto error = find_nul(input_, *block, line)) return error;
      line += static_cast<std::uint64_t>(std::count(block->begin(), block->end(), '\n'));
    }
  }

 private:
  static constexpr std::size_t kPartSize = std::size_t{1} << 19;  // with its points it fits a core's cache
  static constexpr std::size_t kMostParts = 64;
  static constexpr std::size_t kSmallestPart = std::size_t{1} << 16;

  std::optional<Error> add(std::string_view block) {
    if (auto error = find_nul(input_, block, line_)) return error;
    std::vector<Part> parts =
        cut(block, std::clamp<std::size_t>(block.size() / kSmallestPart, 1,
                                           std::min<std::size_t>(threads_, kMostParts)));
    if (others_.size() < parts.size()) others_.resize(parts.size());
    run_all(parts.size(), [&](std::size_t i) {
      std::vector<Point3>& points = i == 0 ? table_.points : others_[i];
      plan_.delimiter == ' ' ? parse_part<true>(plan_, parts[i], points)
                             : parse_part<false>(plan_, parts[i], points);
    });
    const std::uint64_t first_line = line_;
    for (const Part& part : parts) {
      line_ += part.lines;
      if (!part.fault) continue;
      const auto lines = static_cast<std::uint64_t>(std::count(block.begin(), block.end(), '\n'));
      Error fault = line_error(input_.name(), line_ - 1, *part.fault);
      if (auto nul = find_nul_in_rest(first_line + lines)) return nul;
      return fault;
    }
    gather(parts, block.size());
    return find_excess(input_, table_.points.size());
  }

  // The points of the parts in their order, and room for those that the rest of the file will bring.
  void gather(const std::vector<Part>& parts, std::size_t bytes) {
    std::size_t count = table_.points.size();
    for (std::size_t i = 0; i < parts.size(); ++i) {
      table_.skipped_nodata += parts[i].skipped;
      if (i > 0) count += others_[i].size();
    }
    read_ += bytes;
    const std::size_t next = count + static_cast<std::size_t>(count / (read_ / bytes)) + 1;
    if (next > table_.points.capacity()) reserve_large(table_.points, next + expected_rows(count));
    for (std::size_t i = 1; i < parts.size(); ++i) {
      table_.points.insert(table_.points.end(), others_[i].begin(), others_[i].end());
      others_[i].clear();
    }
  }

  // How many rows are still to come; of a pipe, which does not tell, half as many as came.
  std::size_t expected_rows(std::size_t count) const {
    const auto unread = input_.unread();
    if (!unread) return count / 2;
    return static_cast<std::size_t>(1.02 * static_cast<double>(count) * static_cast<double>(*unread) /
                                    static_cast<double>(read_));
  }

  InputFile& input_;
  RowPlan plan_;
  unsigned threads_;
  LineBlocks blocks_;
  std::uint64_t line_;      // the number of the next line
  std::uint64_t read_ = 0;  // bytes
  PointTable table_;
  std::vector<std::vector<Point3>> others_;  // of each part but the first
};

}  // namespace

Result<PointTable> parse_table(InputFile& input, const ReadOptions& options) {
  while (!input.at_end() && !has_opening(input.text())) {
    if (auto error = input.load_more()) return std::move(*error);
  }
  if (auto fault = find_text_fault(input)) return std::move(*fault);
  Result<TableLayout> layout = find_layout(input, options.columns);
  input.seek(layout ? static_cast<std::size_t>(layout->body.data() - input.bytes().data()) : 0);
  TableReader reader(input, layout ? *layout : TableLayout{}, options);
  if (layout) return reader.read();
  if (auto nul = reader.find_nul_in_rest(1)) return std::move(*nul);
  return std::move(layout).error();
}

}  // namespace thalweg::io
