/// What a C caller wants, in the words of C++.
#pragma once

#include <atomic>

#include "thalweg/minimize.hpp"
#include "thalweg/result.hpp"
#include "thalweg/thalweg.h"

namespace thalweg::bindings {

/// The options that a caller's struct (null = the defaults) stands for. `stop` serves for stopping if the
/// caller has no request of his own. Requires: `stop` and the caller's request outlive the options. Errors:
/// invalid_argument for a size, value or handle that makes no sense.
Result<MinimizeOptions> read_options(const thalweg_build_options* theirs, std::atomic<bool>& stop);

}  // namespace thalweg::bindings
