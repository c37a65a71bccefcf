/// Ids from plain numbers, for tests that write triangles down.
#pragma once

#include <cstdint>

#include "thalweg/triangulation.hpp"

namespace support {

inline thalweg::VertexId vertex(std::uint32_t i) {
  return thalweg::VertexId(i);
}

inline thalweg::Triangle tri(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  return {vertex(a), vertex(b), vertex(c)};
}

}  // namespace support
