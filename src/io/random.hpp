/// Random numbers that are the same on every machine: the standard distributions differ between libraries.
#pragma once

#include <cstdint>

namespace thalweg::io {

/// SplitMix64. Source: Steele, Lea and Flood, Fast splittable pseudorandom number generators, OOPSLA 2014.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  /// The output function alone: a hash of 64 bits to 64 bits without collisions.
  static constexpr std::uint64_t mix(std::uint64_t bits) noexcept {
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return bits ^ (bits >> 31);
  }

  std::uint64_t next() noexcept {
    state_ += 0x9e3779b97f4a7c15u;
    return mix(state_);
  }

  /// Uniform in [0, bound), without bias: draws below 2^64 mod bound are thrown away. Requires: bound > 0.
  std::uint64_t below(std::uint64_t bound) noexcept {
    const std::uint64_t excess = (0 - bound) % bound;
    std::uint64_t draw = next();
    while (draw < excess) draw = next();
    return draw % bound;
  }

  /// A multiple of 2^-53 in [0, 1), each equally likely.
  double unit() noexcept { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace thalweg::io
