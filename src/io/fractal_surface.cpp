/// Value noise: random values at the nodes of a square lattice, smoothly interpolated, summed over octaves
/// whose lattices are turned against each other so that none of their directions shows.
#include "io/fractal_surface.hpp"

#include <cmath>

#include "io/random.hpp"

namespace thalweg::io {
namespace {

/// In [-1, 1].
double node_value(std::uint64_t seed, double x, double y) noexcept {
  const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
  const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(y));
  const std::uint64_t bits = Random::mix(seed + Random::mix(column * 0x9e3779b97f4a7c15u + row));
  return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

double smooth(double t) noexcept {
  return t * t * (3 - 2 * t);
}

double blend(double a, double b, double t) noexcept {
  return a + (b - a) * t;
}

double noise(std::uint64_t seed, double x, double y) noexcept {
  const double column = std::floor(x), row = std::floor(y);
  const double across = smooth(x - column), up = smooth(y - row);
  const double below = blend(node_value(seed, column, row), node_value(seed, column + 1, row), across);
  const double above =
      blend(node_value(seed, column, row + 1), node_value(seed, column + 1, row + 1), across);
  return blend(below, above, up);
}

}  // namespace

FractalSurface::FractalSurface(std::uint64_t seed, double coarsest, double finest, double roughness) {
  Random random(seed);
  double cell = finest;
  while (cell * 2 <= coarsest) cell *= 2;
  double amplitude = 1;
  double sum = 0;
  for (; cell >= finest; cell /= 2) {
    octaves_.push_back({random.next(), 1 / cell, amplitude});
    sum += amplitude;
    amplitude *= roughness;
  }
  for (Octave& octave : octaves_) octave.amplitude /= sum;
}

double FractalSurface::height(double x, double y) const noexcept {
  double sum = 0;
  for (const Octave& octave : octaves_) {
    sum += octave.amplitude * noise(octave.seed, x * octave.cells_per_unit, y * octave.cells_per_unit);
    // A turn by the angle of the triangle 3, 4, 5, which no power of is a quarter turn.
    const double turned = (3 * x - 4 * y) / 5;
    y = (4 * x + 3 * y) / 5;
    x = turned;
  }
  return sum;
}

}  // namespace thalweg::io
