#include "io/ply_header.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "io/number.hpp"
#include "io/text_scanner.hpp"

namespace thalweg::io {
namespace {

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array kTypes = {TypeName{"char", PlyType::int8},      TypeName{"int8", PlyType::int8},
                               TypeName{"uchar", PlyType::uint8},    TypeName{"uint8", PlyType::uint8},
                               TypeName{"short", PlyType::int16},    TypeName{"int16", PlyType::int16},
                               TypeName{"ushort", PlyType::uint16},  TypeName{"uint16", PlyType::uint16},
                               TypeName{"int", PlyType::int32},      TypeName{"int32", PlyType::int32},
                               TypeName{"uint", PlyType::uint32},    TypeName{"uint32", PlyType::uint32},
                               TypeName{"float", PlyType::float32},  TypeName{"float32", PlyType::float32},
                               TypeName{"double", PlyType::float64}, TypeName{"float64", PlyType::float64}};

bool read_type(TextScanner& scanner, PlyType& type) {
  const std::string_view word = scanner.word();
  for (const TypeName& entry : kTypes) {
    if (entry.name == word) {
      type = entry.type;
      return true;
    }
  }
  return scanner.fail(in_quotes(word) +
                      " is no type of PLY (char, uchar, short, ushort, int, uint, float, double)");
}

bool read_format(TextScanner& scanner, std::optional<PlyEncoding>& encoding) {
  const std::string_view word = scanner.word();
  if (word == "ascii") {
    encoding = PlyEncoding::ascii;
  } else if (word == "binary_little_endian") {
    encoding = PlyEncoding::little_endian;
  } else if (word == "binary_big_endian") {
    encoding = PlyEncoding::big_endian;
  } else {
    return scanner.fail(in_quotes(word) +
                        " is no format of PLY: ascii, binary_little_endian or binary_big_endian");
  }
  const std::string_view version = scanner.word();
  return version == "1.0" || scanner.fail("version " + in_quotes(version) + " of PLY is not known: 1.0 is");
}

// Names appear in messages, so they may not hold what a terminal would act on.
bool is_name(std::string_view word) noexcept {
  constexpr std::size_t kLongest = 100;
  return !word.empty() && word.size() <= kLongest &&
         std::none_of(word.begin(), word.end(), [](char c) { return (c >= 0 && c < 0x20) || c == 0x7f; });
}

bool read_element(TextScanner& scanner, PlyHeader& header) {
  const std::string_view name = scanner.word();
  if (!is_name(name)) {
    return scanner.fail("an element called " + in_quotes(name) + ": write `element NAME COUNT`");
  }
  std::int64_t count = 0;
  if (!scanner.whole(count, 0, std::numeric_limits<std::int64_t>::max(), "the count of the element"))
    return false;
  for (const PlyElement& other : header.elements) {
    if (other.name == name)
      return scanner.fail("a second element " + in_quotes(name) + ": there may be one of each name");
  }
  header.elements.push_back({std::string(name), static_cast<std::uint64_t>(count), {}});
  return true;
}

bool read_property(TextScanner& scanner, PlyHeader& header) {
  if (header.elements.empty()) return scanner.fail("a property before the first element: it belongs to none");
  PlyProperty property;
  if (scanner.rest().starts_with("list") && scanner.word() == "list") {
    property.is_list = true;
    if (!read_type(scanner, property.count_type)) return false;
    if (is_real(property.count_type)) return scanner.fail("the length of a list must be of a whole type");
  }
  if (!read_type(scanner, property.type)) return false;
  property.name = scanner.word();
  if (!is_name(property.name)) {
    return scanner.fail("a property called " + in_quotes(property.name) + ": write `property TYPE NAME`");
  }
  header.elements.back().properties.push_back(std::move(property));
  return true;
}

// Reads up to end_header. False with a fault, or if the text ends before it.
bool read_lines(TextScanner& scanner, PlyHeader& header) {
  std::optional<PlyEncoding> encoding;
  while (scanner.next_line()) {
    const std::string_view keyword = scanner.word();
    if (keyword == "end_header") {
      if (!encoding) return scanner.fail("the header has no format: write `format ascii 1.0` after `ply`");
      header.encoding = *encoding;
      return true;
    }
    if (keyword == "comment") {
      const std::string_view text = scanner.rest();
      if (text.starts_with("crs:")) header.crs = trimmed(text.substr(4));
    } else if (keyword == "format") {
      if (!read_format(scanner, encoding)) return false;
    } else if (keyword == "element") {
      if (!read_element(scanner, header)) return false;
    } else if (keyword == "property") {
      if (!read_property(scanner, header)) return false;
    } else if (keyword != "obj_info") {
      return scanner.fail(in_quotes(keyword) +
                          " is no keyword of a PLY header: correct it, or end the header by end_header");
    }
  }
  return false;
}

/// Whether the header ends within this beginning of a file, with the end of its last line.
bool has_whole_header(std::string_view beginning) {
  TextScanner scanner(beginning, {}, 0);
  while (scanner.next_line()) {
    if (scanner.word() == "end_header") return !scanner.remaining().empty();
  }
  return false;
}

std::optional<Error> find_shortage(const InputFile& input, const PlyHeader& header) {
  const auto size = input.size();
  if (!size) return std::nullopt;
  std::uint64_t room = *size - header.size + 1;  // the last line may lack its end
  for (const PlyElement& element : header.elements) {
    const std::size_t least = element.least_size(header.encoding);
    if (least == 0) continue;
    if (element.count > room / least) {
      return input.error(ErrorCode::malformed,
                         "the header promises " + std::to_string(element.count) + " elements " +
                             in_quotes(element.name) +
                             ", but the file is too short for them: it is cut short or damaged");
    }
    room -= element.count * least;
  }
  return std::nullopt;
}

}  // namespace

std::size_t PlyElement::least_size(PlyEncoding encoding) const noexcept {
  if (encoding == PlyEncoding::ascii) return 2 * properties.size();
  std::size_t size = 0;
  for (const PlyProperty& property : properties)
    size += size_of(property.is_list ? property.count_type : property.type);
  return size;
}

Result<PlyHeader> parse_ply_header(InputFile& input) {
  while (!input.at_end() && input.bytes().starts_with("ply") && !has_whole_header(input.bytes())) {
    if (auto error = input.load_more()) return std::move(*error);
  }
  TextScanner scanner(input.bytes(), input.name(), 0);
  if (!scanner.next_line() || scanner.word() != "ply") {
    return line_error(input.name(), 1,
                      "the first line of a PLY file must be `ply`: say what it is with --from");
  }
  PlyHeader header;
  if (!read_lines(scanner, header)) {
    if (scanner.fault()) return *scanner.fault();
    return line_error(input.name(), scanner.line_number(), "the file ends in its header: it is cut short");
  }
  header.size = input.bytes().size() - scanner.remaining().size();
  header.lines = scanner.line_number();
  if (header.encoding == PlyEncoding::ascii) {
    if (auto error = input.load_all()) return std::move(*error);
  }
  if (auto error = find_shortage(input, header)) return std::move(*error);
  return header;
}

}  // namespace thalweg::io
