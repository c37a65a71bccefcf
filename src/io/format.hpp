/// The file formats the command knows, and how one is chosen: by --from / --to, else by the suffix of the
/// path.
#pragma once

#include <string>
#include <string_view>

#include "thalweg/result.hpp"

namespace thalweg::io {

enum class Format { xyz, csv, tsv, asc, obj, ply, ply_ascii, two_dm, tlw, npy, geojson, svg, html };

enum class Direction { read, write };

/// The name by which --from and --to know the format: xyz, csv, tsv, asc, obj, ply, ply-ascii, 2dm, tlw, npy,
/// geojson, svg, html.
std::string_view name_of(Format format) noexcept;

/// The format called `forced`, or if that is empty the one of the suffix of `path` (any case; .txt, .dat and
/// .pts are xyz, .grd is asc, .json is geojson). Errors: invalid_argument, listing the formats of that
/// direction, if the name or the suffix is not known, and for `-` without a name.
Result<Format> format_of(std::string_view path, std::string_view forced, Direction direction);

}  // namespace thalweg::io
