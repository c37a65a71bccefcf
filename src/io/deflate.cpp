/// Deflate: matches found by a hash of three bytes, then one dynamic Huffman code a block. Source: RFC 1950
/// and 1951.
#include "io/deflate.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>

namespace thalweg::io {
namespace {

constexpr std::size_t kWindow = 32768, kLeastMatch = 3, kMostMatch = 258, kBlock = 1 << 16;
constexpr int kLongestChain = 24;
constexpr unsigned kEndOfBlock = 256;

/// Bits, least significant first.
class BitWriter {
 public:
  explicit BitWriter(std::vector<std::uint8_t>& out) : out_(out) {}

  void put(std::uint32_t bits, unsigned count) {
    held_ |= std::uint64_t{bits} << used_;
    for (used_ += count; used_ >= 8; used_ -= 8, held_ >>= 8)
      out_.push_back(static_cast<std::uint8_t>(held_));
  }
  void finish() {
    if (used_ > 0) out_.push_back(static_cast<std::uint8_t>(held_));
  }

 private:
  std::vector<std::uint8_t>& out_;
  std::uint64_t held_ = 0;
  unsigned used_ = 0;
};

/// A range of lengths or distances: its symbol, and the bits that follow it.
struct Extra {
  unsigned symbol;
  unsigned bits;
  std::uint32_t value;
};

Extra length_extra(std::size_t length) {
  if (length == kMostMatch) return {285, 0, 0};
  const auto rest = static_cast<std::uint32_t>(length - kLeastMatch);
  if (rest < 8) return {257 + rest, 0, 0};
  const auto bits = static_cast<unsigned>(std::bit_width(rest)) - 3;
  return {257 + 4 * bits + (rest >> bits), bits, rest & ((1u << bits) - 1)};
}

Extra distance_extra(std::size_t distance) {
  const auto rest = static_cast<std::uint32_t>(distance - 1);
  if (rest < 4) return {rest, 0, 0};
  const auto bits = static_cast<unsigned>(std::bit_width(rest)) - 2;
  return {2 * bits + (rest >> bits), bits, rest & ((1u << bits) - 1)};
}

/// Lengths of a Huffman code for these counts, none above `most`; at least one symbol has a code.
std::vector<std::uint8_t> code_lengths(std::vector<std::uint32_t> counts, unsigned most) {
  const std::size_t symbols = counts.size();
  if (std::ranges::all_of(counts, [](std::uint32_t c) { return c == 0; })) counts[0] = 1;
  for (;;) {
    // A node is its weight and its number; parents have larger numbers than their children.
    using Node = std::pair<std::uint64_t, std::uint32_t>;
    std::priority_queue<Node, std::vector<Node>, std::greater<>> nodes;
    std::vector<std::uint32_t> parent(2 * symbols, 0);
    for (std::uint32_t s = 0; s < symbols; ++s) {
      if (counts[s] > 0) nodes.emplace(counts[s], s);
    }
    std::vector<std::uint8_t> lengths(symbols, 0);
    if (nodes.size() == 1) {
      lengths[nodes.top().second] = 1;
      return lengths;
    }
    auto next = static_cast<std::uint32_t>(symbols);
    while (nodes.size() > 1) {
      const Node a = nodes.top();
      nodes.pop();
      const Node b = nodes.top();
      nodes.pop();
      parent[a.second] = parent[b.second] = next;
      nodes.emplace(a.first + b.first, next++);
    }
    std::vector<unsigned> depth(next, 0);
    for (std::uint32_t i = next - 1; i-- > 0;) {
      if (parent[i] != 0) depth[i] = depth[parent[i]] + 1;
    }
    bool fits = true;
    for (std::size_t s = 0; s < symbols; ++s) {
      fits = fits && depth[s] <= most;
      lengths[s] = static_cast<std::uint8_t>(depth[s]);
    }
    if (fits) return lengths;
    for (std::uint32_t& count : counts) count = (count + 1) / 2;  // flatter counts, shorter codes
  }
}

/// Canonical codes, ready to be put least significant bit first.
std::vector<std::uint32_t> codes_of(const std::vector<std::uint8_t>& lengths) {
  std::array<std::uint32_t, 17> next{};
  for (const std::uint8_t length : lengths) ++next[length + 1u];
  next[1] = 0;
  for (std::size_t l = 1; l < next.size(); ++l) next[l] = (next[l - 1] + next[l]) << (l > 1 ? 1 : 0);
  std::vector<std::uint32_t> codes(lengths.size(), 0);
  for (std::size_t s = 0; s < lengths.size(); ++s) {
    if (lengths[s] == 0) continue;
    std::uint32_t code = next[lengths[s]]++;
    for (unsigned i = 0; i < lengths[s]; ++i, code >>= 1) codes[s] = codes[s] << 1 | (code & 1);
  }
  return codes;
}

/// What a block consists of: a byte if `distance` is 0, else a match of `length`.
struct Piece {
  std::uint16_t length;
  std::uint16_t distance;  // 32768 does not occur: the window is kept one byte smaller
};

struct Code {
  std::vector<std::uint8_t> lengths;
  std::vector<std::uint32_t> codes;

  Code(std::vector<std::uint32_t> counts, unsigned most)
      : lengths(code_lengths(std::move(counts), most)), codes(codes_of(lengths)) {}
  void put(BitWriter& out, unsigned symbol) const { out.put(codes[symbol], lengths[symbol]); }
};

/// The lengths of both codes, themselves coded; zeros by runs.
void put_lengths(BitWriter& out, const Code& literals, const Code& distances) {
  constexpr std::array<unsigned, 19> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                               11, 4,  12, 3, 13, 2, 14, 1, 15};
  std::vector<std::uint8_t> all = literals.lengths;
  all.insert(all.end(), distances.lengths.begin(), distances.lengths.end());
  std::vector<Extra> words;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t run = 1;
    while (i + run < all.size() && all[i + run] == all[i] && run < 138) ++run;
    if (all[i] == 0 && run >= 11) {
      words.push_back({18, 7, static_cast<std::uint32_t>(run - 11)});
    } else if (all[i] == 0 && run >= 3) {
      words.push_back({17, 3, static_cast<std::uint32_t>(run - 3)});
    } else {
      run = 1;
      words.push_back({all[i], 0, 0});
    }
    i += run;
  }
  std::vector<std::uint32_t> counts(kOrder.size(), 0);
  for (const Extra& word : words) ++counts[word.symbol];
  const Code code(std::move(counts), 7);
  out.put(static_cast<std::uint32_t>(literals.lengths.size() - 257), 5);
  out.put(static_cast<std::uint32_t>(distances.lengths.size() - 1), 5);
  out.put(static_cast<std::uint32_t>(kOrder.size() - 4), 4);
  for (const unsigned symbol : kOrder) out.put(code.lengths[symbol], 3);
  for (const Extra& word : words) {
    code.put(out, word.symbol);
    out.put(word.value, word.bits);
  }
}

void put_block(BitWriter& out, std::span<const Piece> pieces, bool last) {
  std::vector<std::uint32_t> literal_counts(286, 0), distance_counts(30, 0);
  for (const Piece& piece : pieces) {
    ++literal_counts[piece.distance == 0 ? piece.length : length_extra(piece.length).symbol];
    if (piece.distance != 0) ++distance_counts[distance_extra(piece.distance).symbol];
  }
  ++literal_counts[kEndOfBlock];
  const Code literals(std::move(literal_counts), 15), distances(std::move(distance_counts), 15);
  out.put(last ? 1 : 0, 1);
  out.put(2, 2);
  put_lengths(out, literals, distances);
  for (const Piece& piece : pieces) {
    if (piece.distance == 0) {
      literals.put(out, piece.length);
      continue;
    }
    const Extra length = length_extra(piece.length), distance = distance_extra(piece.distance);
    literals.put(out, length.symbol);
    out.put(length.value, length.bits);
    distances.put(out, distance.symbol);
    out.put(distance.value, distance.bits);
  }
  literals.put(out, kEndOfBlock);
}

/// Where the same three bytes occurred before.
class Matches {
 public:
  explicit Matches(std::span<const std::uint8_t> bytes)
      : bytes_(bytes), head_(1 << 15, kNone), previous_(kWindow, kNone) {}

  void remember(std::size_t at) {
    if (at + kLeastMatch > bytes_.size()) return;
    std::size_t& head = head_[hash(at)];
    previous_[at % kWindow] = head;
    head = at;
  }

  /// The longest match found at `at`: its length, 0 if there is none worth it, and its distance.
  std::pair<std::size_t, std::size_t> longest(std::size_t at) const {
    std::size_t best = kLeastMatch, distance = 0;
    const std::size_t most = std::min(kMostMatch, bytes_.size() - at);
    if (most <= kLeastMatch) return {0, 0};
    std::size_t candidate = head_[hash(at)];
    for (int step = 0; step < kLongestChain && candidate != kNone && at - candidate < kWindow; ++step) {
      std::size_t length = 0;
      while (length < most && bytes_[candidate + length] == bytes_[at + length]) ++length;
      if (length > best) {
        best = length;
        distance = at - candidate;
        if (length == most) break;
      }
      const std::size_t earlier = previous_[candidate % kWindow];
      if (earlier != kNone && earlier >= candidate) break;  // that place of the ring has been used again
      candidate = earlier;
    }
    return distance == 0 ? std::pair<std::size_t, std::size_t>{0, 0} : std::pair{best, distance};
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t hash(std::size_t at) const {
    const std::uint32_t word =
        bytes_[at] | std::uint32_t{bytes_[at + 1]} << 8 | std::uint32_t{bytes_[at + 2]} << 16;
    return word * 2654435761u >> 17;
  }

  std::span<const std::uint8_t> bytes_;
  std::vector<std::size_t> head_, previous_;
};

std::uint32_t adler32(std::span<const std::uint8_t> bytes) {
  std::uint32_t a = 1, b = 0;
  for (const std::uint8_t byte : bytes) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

}  // namespace

std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> result = {0x78, 0x9c};
  BitWriter out(result);
  Matches matches(bytes);
  std::vector<Piece> pieces;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto [length, distance] = matches.longest(at);
    const std::size_t step = distance == 0 ? 1 : length;
    pieces.push_back({static_cast<std::uint16_t>(distance == 0 ? bytes[at] : length),
                      static_cast<std::uint16_t>(distance)});
    for (std::size_t i = 0; i < step; ++i) matches.remember(at + i);
    at += step;
    if (pieces.size() == kBlock && at < bytes.size()) {
      put_block(out, pieces, false);
      pieces.clear();
    }
  }
  put_block(out, pieces, true);
  out.finish();
  const std::uint32_t sum = adler32(bytes);
  for (int shift = 24; shift >= 0; shift -= 8) result.push_back(static_cast<std::uint8_t>(sum >> shift));
  return result;
}

}  // namespace thalweg::io
