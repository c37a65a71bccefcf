/// Numbers as people type and read them. (Data files have their own exact numbers: io/number.hpp.)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace thalweg::cli {

/// The whole number that `text` is, all of it: decimal digits alone, at most `most`; nothing otherwise.
std::optional<std::uint64_t> parse_whole(std::string_view text, std::uint64_t most) noexcept;

/// A number of bytes: "8G", "1.5 GB", "500MiB", "4096". K, M, G, T are powers of 1024, in either case.
std::optional<std::uint64_t> parse_bytes(std::string_view text) noexcept;

/// A number of seconds that is finite and not negative: "60", "0.5".
std::optional<double> parse_seconds(std::string_view text) noexcept;

/// The first and last of "3..7", or twice the number of "5".
struct OrderRange {
  unsigned first = 0;
  unsigned last = 0;
};

/// Nothing unless `text` is A or A..B with A <= B.
std::optional<OrderRange> parse_range(std::string_view text) noexcept;

/// "812 bytes", "3.4 MB", "1.2 GB": powers of 1024, as --max-memory reads them.
std::string format_bytes(std::uint64_t bytes);

/// `value` with so many digits after the point; for reading only.
std::string format_fixed(double value, int digits);

/// "1 pit", "2 pits": the number and the word for it.
std::string counted(std::uint64_t count, std::string_view one, std::string_view many);

}  // namespace thalweg::cli
