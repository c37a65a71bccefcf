/// The random numbers of tests and benchmarks: the generator of src/io, with the draws that they like.
#pragma once

#include <cstdint>

#include "io/random.hpp"

namespace support {

class Random : public thalweg::io::Random {
 public:
  using thalweg::io::Random::Random;

  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(thalweg::io::Random::below(n)); }
  /// A whole number of [low, high].
  int between(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::uint32_t>(high - low + 1)));
  }
  double whole(int low, int high) { return between(low, high); }
};

}  // namespace support
