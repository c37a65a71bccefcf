#include "io/table_layout.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <system_error>
#include <utility>

#include "io/number.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

using Fields = std::vector<std::string_view>;

// Normalised names by falling preference: of a table with x, y, lon, lat the plain x, y are meant. "depth" is
// absent on purpose: it grows downward, and a terrain upside down has no warning sign.
constexpr std::array<std::string_view, 14> kXNames = {"x",      "easting", "east", "lon",    "longitude",
                                                      "long",   "lng",     "e",    "xcoord", "coordx",
                                                      "pointx", "utmx",    "utme", "posx"};
constexpr std::array<std::string_view, 12> kYNames = {
    "y", "northing", "north", "lat", "latitude", "n", "ycoord", "coordy", "pointy", "utmy", "utmn", "posy"};
constexpr std::array<std::string_view, 12> kZNames = {
    "z", "elevation", "elev", "height", "altitude", "alt", "ele", "h", "zcoord", "coordz", "pointz", "posz"};
constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};

std::span<const std::string_view> names_of(std::size_t axis) {
  if (axis == 0) return kXNames;
  if (axis == 1) return kYNames;
  return kZNames;
}

// "X [m]", "x_coord" and "POINT-X" become x, xcoord and pointx.
std::string normalised(std::string_view name) {
  std::string out;
  for (const char c : name.substr(0, name.find_first_of("([{"))) {
    if (c >= 'A' && c <= 'Z') out += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) out += c;
  }
  return out;
}

bool is_known_name(std::string_view field) {
  const std::string name = normalised(field);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto names = names_of(axis);
    if (std::find(names.begin(), names.end(), name) != names.end()) return true;
  }
  return false;
}

// NaN, infinities and decimal commas are meant as numbers, though none that we take.
bool looks_numeric(std::string_view field) {
  const NumberFault fault = parse_number(field).fault;
  return fault != NumberFault::not_a_number && fault != NumberFault::empty;
}

/// What --columns asks for, one entry an axis: a number from 0 or a name; all empty without the option.
struct Wanted {
  std::array<std::optional<std::size_t>, 3> number;
  std::array<std::string, 3> name;
  bool given = false;

  bool names_any() const { return given && !(number[0] && number[1] && number[2]); }
  bool mentions(std::string_view field) const {
    return std::any_of(name.begin(), name.end(),
                       [&](const std::string& n) { return !n.empty() && same_word(n, field); });
  }
  /// How many columns a row must have at least to satisfy it.
  std::size_t width() const {
    if (!given) return 3;
    std::size_t width = names_any() ? 3 : 1;
    for (const auto& n : number) width = std::max(width, n ? *n + 1 : std::size_t{0});
    return width;
  }
};

Result<Wanted> parse_wanted(std::string_view columns) {
  Wanted wanted;
  if (columns.empty()) return wanted;
  const Error bad = {
      ErrorCode::invalid_argument,
      "--columns " + in_quotes(columns) +
          ": give three different columns for x, y, z, by name or by number from 1: --columns 1,2,5"};
  Fields parts;
  split_fields(columns, ',', parts);
  if (parts.size() != 3) return bad;
  wanted.given = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view part = parts[axis];
    if (part.empty()) return bad;
    for (std::size_t other = 0; other < axis; ++other) {
      if (same_word(part, parts[other])) return bad;
    }
    wanted.name[axis] = part;
    if (part.find_first_not_of("0123456789") != std::string_view::npos) continue;
    std::uint32_t number = 0;
    const auto [end, fault] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (fault != std::errc() || number == 0 || number > 1000000) return bad;
    wanted.number[axis] = number - 1;
    wanted.name[axis].clear();
  }
  return wanted;
}

// The separator under which most fields are numbers or known names, among those that give enough columns.
// What decides between "1,5;2,5;3,5" and "1,2,3,a;b" is that the right one leaves more fields with a meaning.
char sniff_delimiter(std::string_view line, const Wanted& wanted) {
  char best = ' ';
  std::size_t best_width = 0;
  std::size_t best_score = 0;
  Fields fields;
  for (const char delimiter : {';', '\t', ',', ' '}) {
    split_fields(line, delimiter, fields);
    const std::size_t width = std::min(fields.size(), wanted.width());
    const auto score =
        static_cast<std::size_t>(std::count_if(fields.begin(), fields.end(), [&](std::string_view f) {
          return looks_numeric(f) || wanted.mentions(f) || is_known_name(f);
        }));
    if (best_width == 0 || width > best_width || (width == best_width && score > best_score)) {
      best = delimiter;
      best_width = width;
      best_score = score;
    }
  }
  return best;
}

bool is_header(const Fields& fields, const Wanted& wanted) {
  if (std::none_of(fields.begin(), fields.end(), looks_numeric)) return true;
  if (std::any_of(fields.begin(), fields.end(), [&](std::string_view f) { return wanted.mentions(f); }))
    return true;
  return std::count_if(fields.begin(), fields.end(), is_known_name) >= 2;
}

std::string list_of(const Fields& fields) {
  std::string out;
  for (std::size_t i = 0; i < fields.size() && i < 20; ++i)
    out += (i == 0 ? "" : ", ") + in_quotes(fields[i]);
  return out + (fields.size() > 20 ? ", ..." : "");
}

// The column of one axis in a header, or why there is none, in words.
struct Found {
  std::optional<std::size_t> column;
  std::string fault;
};

Found find_named(const Fields& header, std::string_view wanted_name) {
  Found found;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (!same_word(header[i], wanted_name)) continue;
    if (found.column)
      return {std::nullopt, "two columns are called " + in_quotes(wanted_name) + ": name them by number"};
    found.column = i;
  }
  if (!found.column)
    found.fault = "no column is called " + in_quotes(wanted_name) + ": there are " + list_of(header);
  return found;
}

Found find_axis(const Fields& header, std::size_t axis) {
  std::vector<std::string> names;
  for (const std::string_view field : header) names.push_back(normalised(field));
  for (const std::string_view known : names_of(axis)) {
    const auto first = std::find(names.begin(), names.end(), known);
    if (first == names.end()) continue;
    if (std::find(first + 1, names.end(), known) != names.end()) {
      return {std::nullopt,
              "two columns could be " + std::string(kAxes[axis]) + ": say which with --columns"};
    }
    return {static_cast<std::size_t>(first - names.begin()), {}};
  }
  return {std::nullopt, "no column for " + std::string(kAxes[axis]) + " in the header (" + list_of(header) +
                            "): say which with --columns"};
}

// Fills layout.column from a header; the fault in words if it cannot.
std::optional<std::string> apply_header(const Fields& header, const Wanted& wanted, TableLayout& layout) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (wanted.number[axis]) {
      layout.column[axis] = *wanted.number[axis];
      continue;
    }
    Found found = wanted.given ? find_named(header, wanted.name[axis]) : find_axis(header, axis);
    if (!found.column) return std::move(found.fault);
    layout.column[axis] = *found.column;
  }
  return std::nullopt;
}

/// The lines that decide: the last comment before them, the first that is no comment, and the one after it.
struct Opening {
  std::string_view comment;
  std::array<std::string_view, 2> line;
  std::array<std::uint64_t, 2> number = {0, 0};
};

Opening find_opening(std::string_view text) {
  Opening opening;
  std::size_t found = 0;
  std::uint64_t number = 0;
  for (std::size_t start = 0; start < text.size() && found < 2;) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line = text.substr(start, end - start);
    ++number;
    start = end + 1;
    if (!is_comment_or_blank(line)) {
      opening.line[found] = line;
      opening.number[found++] = number;
    } else if (found == 0 && !trimmed(line).empty()) {
      opening.comment = trimmed(line);
    }
  }
  return opening;
}

// "# y x z" above unnamed columns: to take them as x, y, z would turn the terrain over without a word.
bool apply_comment(std::string_view comment, std::size_t width, const Wanted& wanted, TableLayout& layout) {
  const std::size_t start = comment.find_first_not_of("#/ \t");
  if (start == std::string_view::npos) return false;
  Fields names;
  for (const char delimiter : {';', '\t', ',', ' '}) {
    split_fields(comment.substr(start), delimiter, names);
    TableLayout candidate = layout;
    if (names.size() == width && !apply_header(names, wanted, candidate)) {
      layout = candidate;
      return true;
    }
  }
  return false;
}

}  // namespace

bool is_comment_or_blank(std::string_view line) noexcept {
  line = trimmed(line);
  return line.empty() || line.front() == '#' || line.starts_with("//");
}

void split_fields(std::string_view line, char delimiter, std::vector<std::string_view>& fields) {
  fields.clear();
  if (line.ends_with('\r')) line.remove_suffix(1);
  const bool by_blanks = delimiter == ' ';
  const std::string_view blanks = delimiter == '\t' ? std::string_view(" ") : std::string_view(" \t");
  const auto end_of_field = [&](std::size_t from) {
    return std::min(by_blanks ? line.find_first_of(blanks, from) : line.find(delimiter, from), line.size());
  };
  const auto without_blanks = [&](std::size_t first, std::size_t last) {
    while (first < last && blanks.find(line[first]) != std::string_view::npos) ++first;
    while (first < last && blanks.find(line[last - 1]) != std::string_view::npos) --last;
    return line.substr(first, last - first);
  };
  for (std::size_t at = 0;; ++at) {
    at = std::min(line.find_first_not_of(blanks, at), line.size());
    if (by_blanks && at == line.size()) return;
    const std::size_t start = at;
    if (at < line.size() && line[at] == '"') {
      const std::size_t close = std::min(line.find('"', at + 1), line.size());
      fields.push_back(without_blanks(start + 1, close));
      at = end_of_field(std::min(close + 1, line.size()));
    } else {
      at = end_of_field(at);
      fields.push_back(without_blanks(start, at));
    }
    if (at == line.size()) return;
  }
}

bool has_opening(std::string_view beginning) {
  const std::string_view last = find_opening(beginning).line[1];
  return last.data() != nullptr && last.data() + last.size() != beginning.data() + beginning.size();
}

Result<TableLayout> find_layout(const InputFile& input, std::string_view columns) {
  Result<Wanted> parsed = parse_wanted(columns);
  if (!parsed) return std::move(parsed).error();
  const Wanted& wanted = *parsed;
  const std::string_view text = input.text();
  const Opening opening = find_opening(text);
  if (opening.number[0] == 0) {
    return input.error(ErrorCode::malformed, "has no points: there are only blank lines and comments in it");
  }

  TableLayout layout;
  Fields first;
  layout.delimiter = sniff_delimiter(opening.line[0], wanted);
  split_fields(opening.line[0], layout.delimiter, first);
  const bool header = is_header(first, wanted);
  std::size_t row = 0;
  if (header) {
    // A file of one line of words is more likely to be something else than a header without rows.
    if (auto fault = apply_header(first, wanted, layout))
      return line_error(input.name(), opening.number[0], *fault);
    if (opening.number[1] == 0)
      return input.error(ErrorCode::malformed, "has no points: there is only a header in it");
    row = 1;
    Fields fields;
    split_fields(opening.line[1], layout.delimiter, fields);
    if (fields.size() < wanted.width()) {
      layout.delimiter = sniff_delimiter(opening.line[1], wanted);
      split_fields(opening.line[1], layout.delimiter, fields);
    }
    // R writes a name before each row, but nothing above it.
    if (layout.delimiter == ' ' && fields.size() == first.size() + 1 &&
        (!wanted.given || wanted.names_any())) {
      return line_error(
          input.name(), opening.number[1],
          "one column more than the header names: say which are x, y, z by number: --columns 2,3,4");
    }
  } else if (!apply_comment(opening.comment, first.size(), wanted, layout)) {
    if (wanted.names_any()) {
      return line_error(
          input.name(), opening.number[0],
          "no header, so columns have no names: say which are x, y, z by number: --columns 1,2,3");
    }
    for (std::size_t axis = 0; axis < 3 && wanted.given; ++axis) layout.column[axis] = *wanted.number[axis];
  }
  layout.body = text.substr(static_cast<std::size_t>(opening.line[row].data() - text.data()));
  layout.first_line = opening.number[row];
  return layout;
}

}  // namespace thalweg::io
