/// A fingerprint that anybody can compute again.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "thalweg/point.hpp"

namespace thalweg::io {

/// SHA-256 of `bytes` in hexadecimal. Source: FIPS 180-4.
std::string sha256(std::span<const std::uint8_t> bytes);

/// SHA-256 of the sites whatever their order: sorted by (x, y, z), each as three little-endian doubles.
/// Zeros of either sign are hashed as they are; points that differ in that alone are sorted by sign.
std::string hash_of_sites(std::span<const Point3> sites);

}  // namespace thalweg::io
