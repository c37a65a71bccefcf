/// Doubles that are not finite numbers.
#pragma once

#include <limits>

namespace support {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace support
