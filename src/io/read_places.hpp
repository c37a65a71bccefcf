/// Places without elevation: the points that a user asks about.
#pragma once

#include <string>
#include <vector>

#include "io/read_options.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

/// The first two numbers of every line of the file at `path`; "-" is stdin. Separated by blanks or a comma;
/// what follows them is ignored, so are blank lines, comments (#) and a first line that starts with no
/// number. Uses only `cancel` of the options. Errors: unreadable, malformed ("FILE:LINE: what"), cancelled.
Result<std::vector<Point2>> read_places(const std::string& path, const ReadOptions& options = {});

}  // namespace thalweg::io
