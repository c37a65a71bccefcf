/// Compression that every browser can undo, without a library for it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace thalweg::io {

/// `bytes` as a zlib stream (RFC 1950): deflate with dynamic Huffman codes (RFC 1951) and an Adler-32 sum.
/// The same bytes give the same stream everywhere. Complexity: O(n); memory a small multiple of a block.
std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> bytes);

}  // namespace thalweg::io
