/// The version of the library.
#pragma once

#include "thalweg/export.hpp"

namespace thalweg {

/// "major.minor.patch" of the library that was linked, the same as the package's and the command's.
THALWEG_EXPORT const char* version() noexcept;

}  // namespace thalweg
