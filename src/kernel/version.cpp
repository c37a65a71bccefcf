/// The version, handed in by the build from its one place in CMakeLists.txt.
#include "thalweg/version.hpp"

namespace thalweg {

const char* version() noexcept {
  return THALWEG_VERSION;
}

}  // namespace thalweg
