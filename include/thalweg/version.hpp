/// The version of the library.
#pragma once

#include "thalweg/export.h"

namespace thalweg {

/// "major.minor.patch" of the library that was linked, the same as the package's and the command's.
THALWEG_API const char* version() noexcept;

}  // namespace thalweg
