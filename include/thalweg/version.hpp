/// The version of the library.
#pragma once

namespace thalweg {

/// "major.minor.patch", the same as the package's and the command's.
const char* version() noexcept;

}  // namespace thalweg
