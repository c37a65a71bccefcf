/// A rough surface over the plane, computed from a seed with + - * / and hashes alone, so that every machine
/// gets the same bytes (sines and powers differ in their last bit).
#pragma once

#include <cstdint>
#include <vector>

namespace thalweg::io {

class FractalSurface {
 public:
  /// Details of the size `finest`, and of every size twice as large again up to `coarsest`; each octave is
  /// `roughness` times as high as the one twice as large. Requires: 0 < finest <= coarsest.
  FractalSurface(std::uint64_t seed, double coarsest, double finest, double roughness);

  /// In [-1, 1], continuous. Complexity: O(log(coarsest / finest)).
  double height(double x, double y) const noexcept;

 private:
  struct Octave {
    std::uint64_t seed;
    double cells_per_unit;
    double amplitude;
  };
  std::vector<Octave> octaves_;
};

}  // namespace thalweg::io
