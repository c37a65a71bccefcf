#include "io/format.hpp"

#include <array>

#include "io/number.hpp"

namespace thalweg::io {
namespace {

struct FormatName {
  std::string_view name;
  Format format;
  bool alias;  // known, but not listed
  bool reads;
};

constexpr std::array kNames = {
    FormatName{"xyz", Format::xyz, false, true},
    FormatName{"csv", Format::csv, false, true},
    FormatName{"tsv", Format::tsv, false, true},
    FormatName{"asc", Format::asc, false, true},
    FormatName{"obj", Format::obj, false, true},
    FormatName{"ply", Format::ply, false, true},
    FormatName{"ply-ascii", Format::ply_ascii, false, true},
    FormatName{"2dm", Format::two_dm, false, true},
    FormatName{"tlw", Format::tlw, false, true},
    FormatName{"npy", Format::npy, false, true},
    FormatName{"geojson", Format::geojson, false, false},
    FormatName{"txt", Format::xyz, true, true},
    FormatName{"dat", Format::xyz, true, true},
    FormatName{"pts", Format::xyz, true, true},
    FormatName{"grd", Format::asc, true, true},
    FormatName{"json", Format::geojson, true, false},
    FormatName{"svg", Format::svg, true, false},  // of some commands alone
    FormatName{"html", Format::html, true, false},
    FormatName{"htm", Format::html, true, false},
};

bool allowed(const FormatName& entry, Direction direction) {
  return direction == Direction::read ? entry.reads : entry.format != Format::asc;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

std::string list_of(Direction direction) {
  std::string out;
  for (const FormatName& entry : kNames) {
    if (entry.alias || !allowed(entry, direction)) continue;
    out += out.empty() ? "" : ", ";
    out += entry.name;
  }
  return out;
}

}  // namespace

std::string_view name_of(Format format) noexcept {
  for (const FormatName& entry : kNames) {
    if (entry.format == format) return entry.name;
  }
  return {};
}

Result<Format> format_of(std::string_view path, std::string_view forced, Direction direction) {
  const std::string_view file = path.substr(path.rfind('/') + 1);
  const std::size_t dot = file.rfind('.');
  const bool has_suffix = dot != std::string_view::npos && dot + 1 < file.size();
  const std::string wanted = lower(!forced.empty() ? forced : has_suffix ? file.substr(dot + 1) : "");
  for (const FormatName& entry : kNames) {
    if (entry.name == wanted && allowed(entry, direction)) return entry.format;
  }
  const std::string option = direction == Direction::read ? "--from" : "--to";
  const std::string which = direction == Direction::read ? "can be read" : "can be written";
  const std::string listed = " (" + list_of(direction) + ")";
  if (!forced.empty()) {
    return Error{ErrorCode::invalid_argument, option + " " + in_quotes(forced) + " is not a format that " +
                                                  which + ": name one of them" + listed};
  }
  if (path == "-") return Error{ErrorCode::invalid_argument, "-: say the format with " + option + listed};
  return Error{ErrorCode::invalid_argument,
               std::string(path) + ": " +
                   (has_suffix ? in_quotes(file.substr(dot)) + " is" : std::string("there is")) +
                   " no suffix of a format that " + which + ": say the format with " + option + listed};
}

}  // namespace thalweg::io
