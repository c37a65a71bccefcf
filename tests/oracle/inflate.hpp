/// Inflate straight from RFC 1950 and 1951, one bit at a time; throws nothing, returns nothing if the stream
/// is wrong in any way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace oracle {

class Inflate {
 public:
  static std::optional<std::vector<std::uint8_t>> run(std::span<const std::uint8_t> stream) {
    if (stream.size() < 6 || (stream[0] * 256 + stream[1]) % 31 != 0 || (stream[0] & 15) != 8)
      return std::nullopt;
    Inflate inflate(stream.subspan(2, stream.size() - 6));
    for (bool last = false; !last;) {
      last = inflate.bits(1) == 1;
      if (inflate.bits(2) != 2 || !inflate.dynamic_block()) return std::nullopt;
    }
    if (inflate.failed_ || (inflate.at_ + 7) / 8 != stream.size() - 6) return std::nullopt;
    std::uint32_t a = 1, b = 0, told = 0;
    for (const std::uint8_t byte : inflate.out_) {
      a = (a + byte) % 65521;
      b = (b + a) % 65521;
    }
    for (std::size_t i = stream.size() - 4; i < stream.size(); ++i) told = told << 8 | stream[i];
    if (told != (b << 16 | a)) return std::nullopt;
    return std::move(inflate.out_);
  }

 private:
  using Code = std::map<std::pair<unsigned, unsigned>, unsigned>;  // (length, bits) -> symbol

  explicit Inflate(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  unsigned bits(unsigned count) {
    unsigned value = 0;
    for (unsigned i = 0; i < count; ++i, ++at_) {
      if (at_ / 8 >= bytes_.size()) {
        failed_ = true;
        return 0;
      }
      value |= (bytes_[at_ / 8] >> (at_ % 8) & 1u) << i;
    }
    return value;
  }

  static Code code_of(std::span<const unsigned> lengths) {
    Code code;
    unsigned next = 0;
    for (unsigned length = 1; length <= 15; ++length, next <<= 1) {
      for (unsigned symbol = 0; symbol < lengths.size(); ++symbol) {
        if (lengths[symbol] == length) code[{length, next++}] = symbol;
      }
    }
    return code;
  }

  unsigned symbol(const Code& code) {
    unsigned value = 0;
    for (unsigned length = 1; length <= 15 && !failed_; ++length) {
      value = value << 1 | bits(1);
      const auto found = code.find({length, value});
      if (found != code.end()) return found->second;
    }
    failed_ = true;
    return 0;
  }

  bool dynamic_block() {
    constexpr unsigned kOrder[] = {16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15};
    const unsigned literals = bits(5) + 257, distances = bits(5) + 1, coded = bits(4) + 4;
    std::array<unsigned, 19> lengths_of_lengths{};
    for (unsigned i = 0; i < coded; ++i) lengths_of_lengths[kOrder[i]] = bits(3);
    const Code code = code_of(lengths_of_lengths);
    std::vector<unsigned> lengths;
    while (lengths.size() < literals + distances && !failed_) {
      const unsigned word = symbol(code);
      if (word < 16) {
        lengths.push_back(word);
      } else if (word == 16) {
        if (lengths.empty()) return false;
        lengths.insert(lengths.end(), 3 + bits(2), lengths.back());
      } else {
        lengths.insert(lengths.end(), word == 17 ? 3 + bits(3) : 11 + bits(7), 0u);
      }
    }
    if (failed_ || lengths.size() != literals + distances) return false;
    return contents(code_of(std::span(lengths).first(literals)),
                    code_of(std::span(lengths).subspan(literals)));
  }

  bool contents(const Code& literal_code, const Code& distance_code) {
    constexpr unsigned kLengths[] = {3,  4,  5,  6,  7,  8,  9,  10, 11,  13,  15,  17,  19,  23, 27,
                                     31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258};
    constexpr unsigned kLengthBits[] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,
                                        2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0};
    constexpr unsigned kDistances[] = {1,    2,    3,    4,    5,    7,    9,    13,    17,    25,
                                       33,   49,   65,   97,   129,  193,  257,  385,   513,   769,
                                       1025, 1537, 2049, 3073, 4097, 6145, 8193, 12289, 16385, 24577};
    constexpr unsigned kDistanceBits[] = {0, 0, 0, 0, 1, 1, 2, 2,  3,  3,  4,  4,  5,  5,  6,
                                          6, 7, 7, 8, 8, 9, 9, 10, 10, 11, 11, 12, 12, 13, 13};
    while (!failed_) {
      const unsigned word = symbol(literal_code);
      if (word == 256) return !failed_;
      if (word < 256) {
        out_.push_back(static_cast<std::uint8_t>(word));
        continue;
      }
      const unsigned length = kLengths[word - 257] + bits(kLengthBits[word - 257]);
      const unsigned way = symbol(distance_code);
      const std::size_t distance = kDistances[way] + bits(kDistanceBits[way]);
      if (failed_ || distance > out_.size()) return false;
      for (unsigned i = 0; i < length; ++i) out_.push_back(out_[out_.size() - distance]);
    }
    return false;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
  std::vector<std::uint8_t> out_;
};

}  // namespace oracle
