#include "io/npy_header.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <optional>
#include <system_error>

#include "io/number.hpp"
#include "io/raw_points.hpp"

namespace thalweg::io {
namespace {

constexpr std::size_t kPrefix = 8;  // the magic and the version
constexpr std::size_t kLongestHeader = std::size_t{1} << 20;

/// What the literal says, as text and numbers.
struct Literal {
  std::optional<std::string> descr;
  std::optional<bool> fortran_order;
  std::optional<std::vector<std::uint64_t>> shape;
};

/// Reads {'descr': '<f8', 'fortran_order': False, 'shape': (3, 2), }: as much of Python as NumPy writes.
class LiteralParser {
 public:
  explicit LiteralParser(std::string_view text) : rest_(text) {}

  /// False if the text is anything else.
  bool parse(Literal& literal) {
    if (!take('{')) return false;
    while (!take('}')) {
      std::string key;
      if (!quoted(key) || !take(':') || !value(key, literal)) return false;
      if (!take(',')) return take('}') && at_end();
    }
    return at_end();
  }

 private:
  bool value(const std::string& key, Literal& literal) {
    if (key == "descr") return quoted(literal.descr.emplace());
    if (key == "fortran_order") return truth(literal.fortran_order.emplace());
    return key == "shape" && tuple(literal.shape.emplace());
  }
  bool truth(bool& out) {
    out = word("True");
    return out || word("False");
  }
  bool tuple(std::vector<std::uint64_t>& out) {
    if (!take('(')) return false;
    while (!take(')')) {
      skip_blanks();
      std::uint64_t number = 0;
      const auto [end, fault] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
      if (fault != std::errc()) return false;
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      take('L');  // of Python 2
      out.push_back(number);
      if (!take(',')) return take(')');
    }
    return true;
  }
  bool quoted(std::string& out) {
    skip_blanks();
    if (rest_.empty() || (rest_[0] != '\'' && rest_[0] != '"')) return false;
    const std::size_t close = rest_.find(rest_[0], 1);
    if (close == std::string_view::npos) return false;
    out = rest_.substr(1, close - 1);
    rest_.remove_prefix(close + 1);
    return true;
  }
  bool word(std::string_view expected) {
    skip_blanks();
    if (!rest_.starts_with(expected)) return false;
    rest_.remove_prefix(expected.size());
    return true;
  }
  bool take(char c) { return word(std::string_view(&c, 1)); }
  bool at_end() {
    skip_blanks();
    return rest_.empty();
  }
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size())); }

  std::string_view rest_;
};

/// False for a type that is no number of ours.
bool read_type(std::string_view descr, NpyHeader& header) {
  struct Name {
    std::string_view name;
    ScalarType type;
  };
  constexpr std::array kNames = {Name{"f8", ScalarType::float64}, Name{"f4", ScalarType::float32},
                                 Name{"i1", ScalarType::int8},    Name{"i2", ScalarType::int16},
                                 Name{"i4", ScalarType::int32},   Name{"i8", ScalarType::int64},
                                 Name{"u1", ScalarType::uint8},   Name{"u2", ScalarType::uint16},
                                 Name{"u4", ScalarType::uint32},  Name{"u8", ScalarType::uint64}};
  constexpr bool little = std::endian::native == std::endian::little;
  if (descr.size() != 3 || std::string_view("<>|=").find(descr[0]) == std::string_view::npos) return false;
  for (const Name& entry : kNames) {
    if (entry.name != descr.substr(1)) continue;
    if (descr[0] == '|' && size_of(entry.type) > 1) return false;
    header.type = entry.type;
    header.swap = descr[0] == (little ? '>' : '<');
    return true;
  }
  return false;
}

std::string shape_text(const std::vector<std::uint64_t>& shape) {
  std::string out = "(";
  for (std::size_t i = 0; i < shape.size() && i < 8; ++i)
    out += (i == 0 ? "" : ", ") + std::to_string(shape[i]);
  return out + (shape.size() > 8 ? ", ...)" : ")");
}

/// Fills the header; the fault in words if the array is none of points.
std::optional<std::string> interpret(std::string_view text, NpyHeader& header) {
  Literal literal;
  const bool legible = LiteralParser(text).parse(literal);
  if (!legible && text.find("'descr': [") != std::string_view::npos)
    return "holds rows of named fields: save its columns x, y, z as one array: numpy.c_[a['x'], a['y'], "
           "a['z']]";
  if (!legible || !literal.descr || !literal.fortran_order || !literal.shape)
    return "has a header that NumPy does not write: it is damaged; save the array again";
  if (!read_type(*literal.descr, header))
    return "holds values of type " + in_quotes(*literal.descr) +
           ": only f8, f4 and whole numbers can be read; save a.astype('f8')";
  if (literal.shape->size() != 2 || literal.shape->back() != 3)
    return "is an array of shape " + shape_text(*literal.shape) +
           ": points are of shape (n, 3), columns x, y, z";
  header.fortran_order = *literal.fortran_order;
  header.rows = literal.shape->front();
  return std::nullopt;
}

Error faulty(const InputFile& input, const std::string& what) {
  return input.error(ErrorCode::malformed, what);
}

}  // namespace

Result<NpyHeader> parse_npy_header(InputFile& input) {
  if (!input.bytes().starts_with(kNpyMagic))
    return faulty(input, "is no array of NumPy (.npy), whatever its name: say what it is with --from");
  const std::string cut_short = "the file ends in its header: it is cut short";
  if (input.bytes().size() < kPrefix + 4) return faulty(input, cut_short);
  const auto major = static_cast<unsigned char>(input.bytes()[6]);
  const auto minor = static_cast<unsigned char>(input.bytes()[7]);
  if (major < 1 || major > 3 || minor != 0) {
    return faulty(input, "is version " + std::to_string(major) + "." + std::to_string(minor) +
                             " of .npy, and 1.0, 2.0 and 3.0 can be read: save it again");
  }
  const std::size_t width = major == 1 ? 2 : 4;
  const std::uint64_t length = little_endian_number(input.bytes().data() + kPrefix, width);
  if (length > kLongestHeader)
    return faulty(input, "has a header of " + std::to_string(length) + " bytes: it is damaged");
  NpyHeader header;
  header.size = kPrefix + width + static_cast<std::size_t>(length);
  while (input.bytes().size() < header.size && !input.at_end()) {
    if (auto error = input.load_more()) return std::move(*error);
  }
  if (input.bytes().size() < header.size) return faulty(input, cut_short);
  const std::string_view text = input.bytes().substr(kPrefix + width, static_cast<std::size_t>(length));
  if (auto fault = interpret(text, header)) return faulty(input, *fault);
  return header;
}

std::string npy_header(std::string_view descr, std::uint64_t rows) {
  constexpr std::size_t kAlignment = 64;
  std::string text = "{'descr': '" + std::string(descr) + "', 'fortran_order': False, 'shape': (" +
                     std::to_string(rows) + ", 3), }";
  const std::size_t unpadded = kPrefix + 2 + text.size() + 1;
  text.append((kAlignment - unpadded % kAlignment) % kAlignment, ' ');
  text += '\n';
  std::string header(kNpyMagic);
  header += {'\1', '\0'};
  append_number(header, text.size(), 2);
  return header + text;
}

}  // namespace thalweg::io
