/// What the tests of readers and writers share: doubles that are hard to print, and errors with the folder
/// cut off.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "support/scratch_folder.hpp"
#include "thalweg/point.hpp"
#include "thalweg/result.hpp"

namespace thalweg::test {

/// The message of an error about `path`, with only the file name left of the path; "no error" for a value.
template <class T>
std::string message_of(const Result<T>& result, const std::string& path) {
  if (result) return "no error";
  std::string message = result.error().message;
  const std::size_t folder = path.rfind('/') + 1;
  if (message.starts_with(path)) message.erase(0, folder);
  return message;
}

inline bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_bits(const Point3& a, const Point3& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

inline bool same_bits(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same_bits(a[i], b[i])) return false;
  }
  return true;
}

/// Doubles that careless printing or parsing changes.
inline std::vector<double> nasty_doubles() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> out = {0.0,
                             -0.0,
                             0.1,
                             0.2,
                             0.3,
                             1.0 / 3,
                             2.0 / 3,
                             1e23,
                             9007199254740993.0,
                             5e-324,
                             Limits::min(),
                             Limits::max(),
                             Limits::lowest(),
                             Limits::epsilon(),
                             Limits::denorm_min(),
                             2.2250738585072011e-308,
                             1e15,
                             999999999999999.9,
                             1e-5,
                             9.999e-6,
                             123456.789,
                             0.001,
                             0.0005,
                             400000,
                             1e12,
                             999999999999.999,
                             1e22,
                             4503599627370497.5,
                             557805.0000000001};
  std::uint64_t state = 20221122;
  while (out.size() < 3000) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double any = std::bit_cast<double>(state ^ state >> 29);
    if (any - any == 0) out.push_back(any);
    out.push_back(static_cast<double>(static_cast<std::int64_t>(state >> 30)) / 1000);
    out.push_back(-static_cast<double>(state >> 40) / 64);
  }
  const std::size_t plain = out.size();
  for (std::size_t i = 0; i < plain; ++i) out.push_back(-out[i]);
  return out;
}

/// The nasty doubles as points.
inline std::vector<Point3> nasty_points() {
  const std::vector<double> v = nasty_doubles();
  std::vector<Point3> out;
  for (std::size_t i = 0; i < v.size(); ++i)
    out.push_back({v[i], v[(i * 7 + 3) % v.size()], v[(i * 11 + 5) % v.size()]});
  return out;
}

}  // namespace thalweg::test
