/// What 32-bit floats leave out of doubles, in few bytes, so that a page can tell coordinates bit for bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace thalweg::io {

/// The doubles of one axis, given what the page makes of their floats (`near`):
///
///     steps > 0     (floor(near * steps + 0.5) + residual) / steps: most files hold decimals, or floats
///     steps = 0     the double that is `residual` doubles above `near`; -0 is just below +0
///
/// A residual r is written as 2 r, or -2 r - 1 if it is negative, in `bytes` bytes: all lowest ones first.
/// The page computes in doubles as well, so all this is exact.
struct Residuals {
  double steps = 0;
  unsigned bytes = 0;
  std::vector<std::uint64_t> values;  ///< as they are written
};

/// Requires: as many of `near` as of `exact`, and no NaN among them.
Residuals find_residuals(std::span<const double> exact, std::span<const double> near);

}  // namespace thalweg::io
