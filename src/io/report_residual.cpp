#include "io/report_residual.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace thalweg::io {
namespace {

std::uint64_t folded(std::int64_t value) {
  return static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63);
}

/// Numbers all doubles upwards, one after the other.
std::uint64_t rank(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return (bits >> 63) != 0 ? ~bits : bits | std::uint64_t{1} << 63;
}

/// The multiple of 1 / steps nearest to a value, as the page computes it.
double nearest_step(double value, double steps) {
  return std::floor(value * steps + 0.5);
}

/// Whether each value is a whole number of steps, its bits included; sums of steps must be exact, too.
bool all_are_steps(std::span<const double> exact, std::span<const double> near, double steps) {
  constexpr double kMost = 0x1p52;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const double step = nearest_step(exact[i], steps);
    if (!(std::fabs(step) < kMost) || !(std::fabs(nearest_step(near[i], steps)) < kMost)) return false;
    if (std::bit_cast<std::uint64_t>(step / steps) != std::bit_cast<std::uint64_t>(exact[i])) return false;
  }
  return true;
}

/// Decimals of up to 12 places; or binary fractions, as of files of floats; else 0.
double find_steps(std::span<const double> exact, std::span<const double> near) {
  double steps = 1;
  for (int places = 0; places <= 12; ++places, steps *= 10) {
    if (all_are_steps(exact, near, steps)) return steps;
  }
  for (int bits = 1; bits <= 40; ++bits) {
    if (all_are_steps(exact, near, std::ldexp(1.0, bits))) return std::ldexp(1.0, bits);
  }
  return 0;
}

}  // namespace

Residuals find_residuals(std::span<const double> exact, std::span<const double> near) {
  Residuals result;
  result.steps = find_steps(exact, near);
  result.values.reserve(exact.size());
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const std::int64_t residual = result.steps > 0
                                      ? static_cast<std::int64_t>(nearest_step(exact[i], result.steps) -
                                                                  nearest_step(near[i], result.steps))
                                      : static_cast<std::int64_t>(rank(exact[i]) - rank(near[i]));
    result.values.push_back(folded(residual));
    all |= result.values.back();
  }
  result.bytes = static_cast<unsigned>((std::bit_width(all) + 7) / 8);
  return result;
}

}  // namespace thalweg::io
