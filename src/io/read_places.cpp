#include "io/read_places.hpp"

#include <optional>
#include <string_view>
#include <utility>

#include "io/input_file.hpp"
#include "io/number.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

/// Takes the next field off the front of `line`, and one separator: blanks, or a comma with blanks around it.
std::string_view take_field(std::string_view& line) {
  const std::size_t end = line.find_first_of(" \t,");
  const std::string_view field = line.substr(0, end);
  line = trimmed(line.substr(field.size()));
  if (!line.empty() && line.front() == ',') line = trimmed(line.substr(1));
  return field;
}

/// The fault of a line that does not start with two numbers.
struct LineFault {
  NumberFault fault;
  std::string_view field;
};

std::optional<LineFault> parse_place(std::string_view line, Point2& place) {
  for (double* coordinate : {&place.x, &place.y}) {
    const std::string_view field = take_field(line);
    const ParsedNumber number = parse_number(field);
    if (number.fault != NumberFault::none) return LineFault{number.fault, field};
    *coordinate = number.value;
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<Point2>> read_places(const std::string& path, const ReadOptions& options) {
  const Result<InputFile> input = read_input(path, options);
  if (!input) return input.error();
  if (auto fault = find_text_fault(*input)) return *fault;
  TextScanner lines(input->text(), input->name());
  std::vector<Point2> places;
  for (bool first = true; lines.next_line(); first = false) {
    if (options.cancel != nullptr && *options.cancel) return Error{ErrorCode::cancelled, "interrupted"};
    Point2 place;
    const std::optional<LineFault> fault = parse_place(lines.rest(), place);
    if (!fault) {
      places.push_back(place);
    } else if (!first || fault->fault != NumberFault::not_a_number) {
      return line_error(input->name(), lines.line_number(),
                        describe(fault->fault, fault->field) + ": each line must begin with x and y");
    }
  }
  return places;
}

}  // namespace thalweg::io
