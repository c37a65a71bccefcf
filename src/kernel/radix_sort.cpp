/// A radix sort from the lowest digit up.
#include "kernel/radix_sort.hpp"

#include <array>
#include <utility>
#include <vector>

#include "kernel/parallel.hpp"

namespace thalweg::detail {
namespace {

/// Fewer rows than these a thread are not worth one.
constexpr std::size_t kThreadRows = 1u << 16;

constexpr std::uint32_t kDigitBits = 11;
constexpr std::uint32_t kDigits = 1u << kDigitBits;
constexpr std::uint32_t kPasses = 3;

std::uint32_t digit(KeyedRow k, std::uint32_t pass) {
  return static_cast<std::uint32_t>(k >> (32 + kDigitBits * pass)) % kDigits;
}

/// One pass of a stable radix sort. Every part counts its digits, learns from all counts where its elements
/// go, and moves them: the result is that of one part.
void radix_pass(const Array<KeyedRow>& from, Array<KeyedRow>& to, std::uint32_t pass, std::size_t parts) {
  std::vector<std::array<std::uint32_t, kDigits>> counts(parts);
  parallel_parts(from.size(), parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) ++counts[part][digit(from[i], pass)];
  });
  std::uint32_t place = 0;
  for (std::size_t d = 0; d < kDigits; ++d) {
    for (auto& count : counts) place += std::exchange(count[d], place);
  }
  parallel_parts(from.size(), parts, [&](std::size_t part, std::size_t begin, std::size_t end) {
    auto& next = counts[part];
    for (std::size_t i = begin; i < end; ++i) to[next[digit(from[i], pass)]++] = from[i];
  });
}

}  // namespace

void radix_sort(Array<KeyedRow>& keyed, unsigned threads) {
  if (keyed.size() < 4 * kDigits) {
    std::sort(keyed.begin(), keyed.end());
    return;
  }
  const std::size_t parts = parts_of(keyed.size(), kThreadRows, threads);
  Array<KeyedRow> other(keyed.size());
  for (std::uint32_t pass = 0; pass < kPasses; ++pass) {
    radix_pass(keyed, other, pass, parts);
    keyed.swap(other);
  }
}

}  // namespace thalweg::detail
