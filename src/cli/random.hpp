/// Random numbers that are the same on every machine: the standard distributions differ between libraries.
#pragma once

#include <cstdint>

namespace thalweg::cli {

/// SplitMix64. Source: Steele, Lea and Flood, Fast splittable pseudorandom number generators, OOPSLA 2014.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

  std::uint64_t next() noexcept {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
    return mixed ^ (mixed >> 31);
  }

  /// Uniform in [0, bound), without bias: draws below 2^64 mod bound are thrown away. Requires: bound > 0.
  std::uint64_t below(std::uint64_t bound) noexcept {
    const std::uint64_t excess = (0 - bound) % bound;
    std::uint64_t draw = next();
    while (draw < excess) draw = next();
    return draw % bound;
  }

 private:
  std::uint64_t state_;
};

}  // namespace thalweg::cli
