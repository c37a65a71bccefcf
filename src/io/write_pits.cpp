#include "io/write_pits.hpp"

#include <string>
#include <string_view>

#include "io/row_writer.hpp"

namespace thalweg::io {
namespace {

void put_json_string(RowWriter& out, std::string_view text) {
  constexpr char kHex[] = "0123456789abcdef";
  out << '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out << '\\' << c;
    } else if (byte < 0x20 || byte == 0x7f) {
      out << "\\u00" << kHex[byte >> 4] << kHex[byte & 15];
    } else {
      out << c;
    }
  }
  out << '"';
}

// Quoted only where it must be: by a separator, a quote or a line end in it.
void put_field(RowWriter& out, std::string_view text, char separator) {
  if (text.find_first_of("\"\r\n") == std::string_view::npos &&
      text.find(separator) == std::string_view::npos) {
    out << text;
    return;
  }
  out << '"';
  for (const char c : text) {
    if (c == '"') out << c;
    out << c;
  }
  out << '"';
}

std::string_view word(bool value) {
  return value ? "true" : "false";
}

void put_feature(RowWriter& out, const PitFeature& pit) {
  out << R"({"type":"Feature","geometry":{"type":"Point","coordinates":[)" << pit.x << ',' << pit.y << ','
      << pit.z << R"(]},"properties":{"vertex":)" << pit.vertex << R"(,"z":)" << pit.z << R"(,"boundary":)"
      << word(pit.boundary) << R"(,"removed":)" << word(pit.removed) << R"(,"reason":)";
  put_json_string(out, pit.reason);
  out << R"(,"order_needed":)";
  pit.order_needed ? out << *pit.order_needed : out << "null";
  out << R"(,"vertices":)" << pit.vertices << "}}";
}

void put_row(RowWriter& out, const PitFeature& pit, char separator) {
  out << pit.x << separator << pit.y << separator << pit.z << separator << pit.vertex << separator
      << word(pit.boundary) << separator << word(pit.removed) << separator;
  put_field(out, pit.reason, separator);
  out << separator;
  if (pit.order_needed) out << *pit.order_needed;
  out << separator << pit.vertices << '\n';
}

void write_geojson(RowWriter& out, std::span<const PitFeature> pits) {
  out << R"({"type":"FeatureCollection","features":[)";
  for (std::size_t i = 0; i < pits.size() && !out.failed(); ++i) {
    out << (i == 0 ? "\n" : ",\n");
    put_feature(out, pits[i]);
  }
  out << "\n]}\n";
}

void write_rows(RowWriter& out, std::span<const PitFeature> pits, char separator) {
  constexpr std::string_view kNames[] = {
      "x", "y", "z", "vertex", "boundary", "removed", "reason", "order_needed", "vertices"};
  for (const std::string_view& name : kNames) {
    if (&name != kNames) out << separator;
    out << name;
  }
  out << '\n';
  for (const PitFeature& pit : pits) {
    if (out.failed()) return;
    put_row(out, pit, separator);
  }
}

}  // namespace

std::optional<Error> write_pits(OutputFile& output, std::span<const PitFeature> pits, Format format) {
  RowWriter out(output);
  switch (format) {
    case Format::geojson:
      write_geojson(out, pits);
      break;
    case Format::csv:
      write_rows(out, pits, ',');
      break;
    case Format::tsv:
      write_rows(out, pits, '\t');
      break;
    default:
      return Error{ErrorCode::invalid_argument,
                   std::string(name_of(format)) + " cannot hold pits: use one of geojson, csv, tsv"};
  }
  out.flush();
  return output.error();
}

}  // namespace thalweg::io
