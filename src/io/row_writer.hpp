/// Puts rows of numbers and words together on their way to an OutputFile.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "io/number.hpp"
#include "io/output_file.hpp"
#include "io/parallel.hpp"

namespace thalweg::io {

/// What can be appended to a row. A Sink has `char* room(n)`, where at least n bytes may be put, and
/// `advance(end)` for those that were.
template <class Sink>
class RowPrinter {
 public:
  Sink& operator<<(char c) {
    char* const at = sink().room(1);
    *at = c;
    sink().advance(at + 1);
    return sink();
  }
  Sink& operator<<(std::string_view text) {
    char* const at = sink().room(text.size());
    if (!text.empty()) std::memcpy(at, text.data(), text.size());
    sink().advance(at + text.size());
    return sink();
  }
  Sink& operator<<(const char* text) { return *this << std::string_view(text); }
  Sink& operator<<(double value) { return number(value); }
  template <std::unsigned_integral T>
  Sink& operator<<(T value) {
    return number(std::uint64_t{value});
  }

  /// The bytes of `value` as they are in memory. Requires: a little endian machine, or a swapped value.
  template <class T>
  Sink& raw(T value) {
    char* const at = sink().room(sizeof(T));
    std::memcpy(at, &value, sizeof(T));
    sink().advance(at + sizeof(T));
    return sink();
  }

 private:
  Sink& sink() { return static_cast<Sink&>(*this); }
  template <class T>
  Sink& number(T value) {
    sink().advance(put_number(sink().room(kNumberSize), value));
    return sink();
  }
};

/// Rows in memory.
class RowText : public RowPrinter<RowText> {
 public:
  std::string_view text() const noexcept { return {buffer_.get(), used_}; }
  void clear() noexcept { used_ = 0; }

  char* room(std::size_t count) {
    if (count > capacity_ - used_) enlarge(count);
    return buffer_.get() + used_;
  }
  void advance(const char* end) noexcept { used_ = static_cast<std::size_t>(end - buffer_.get()); }

 private:
  void enlarge(std::size_t count) {
    const std::size_t capacity = std::max(2 * capacity_, used_ + count + 4096);
    auto larger = std::make_unique_for_overwrite<char[]>(capacity);
    if (used_ > 0) std::memcpy(larger.get(), buffer_.get(), used_);
    buffer_ = std::move(larger);
    capacity_ = capacity;
  }

  std::unique_ptr<char[]> buffer_;
  std::size_t capacity_ = 0;
  std::size_t used_ = 0;
};

/// A small buffer in front of an OutputFile into which numbers are printed in place. Empties itself when
/// destroyed.
class RowWriter : public RowPrinter<RowWriter> {
 public:
  explicit RowWriter(OutputFile& output) noexcept : output_(output) {}
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;
  ~RowWriter() { flush(); }

  /// Whether nothing written from now on will reach a file; loops stop early then.
  bool failed() const noexcept { return output_.error().has_value(); }

  void flush() {
    output_.write({buffer_.data(), used_});
    used_ = 0;
  }

  char* room(std::size_t count) {
    if (count > kSize - used_) flush();
    if (count <= kSize) return buffer_.data() + used_;
    large_.resize(count);
    return large_.data();
  }
  void advance(const char* end) {
    if (!large_.empty()) {
      output_.write({large_.data(), large_.size()});
      large_.clear();
    } else {
      used_ = static_cast<std::size_t>(end - buffer_.data());
    }
  }

  /// Calls row(RowText&, i) for every i below `count` and writes what it prints, in that order. Rows are
  /// printed in blocks by all threads of the output at once, so that memory stays bounded; the bytes do not
  /// depend on it.
  template <class Row>
  void rows(std::size_t count, const Row& row) {
    constexpr std::size_t kBlock = 8192;
    flush();
    const std::size_t blocks = (count + kBlock - 1) / kBlock;
    std::vector<RowText> texts(std::min<std::size_t>(output_.threads(), blocks));
    for (std::size_t first = 0; first < count && !failed(); first += texts.size() * kBlock) {
      const std::size_t here = std::min(texts.size(), (count - first + kBlock - 1) / kBlock);
      run_all(here, [&](std::size_t t) {
        texts[t].clear();
        const std::size_t begin = first + t * kBlock;
        for (std::size_t i = begin; i < std::min(begin + kBlock, count); ++i) row(texts[t], i);
      });
      for (std::size_t t = 0; t < here; ++t) output_.write(texts[t].text());
    }
  }

 private:
  static constexpr std::size_t kSize = 1 << 14;

  OutputFile& output_;
  std::array<char, kSize> buffer_;
  std::size_t used_ = 0;
  std::vector<char> large_;  // one text that the buffer cannot hold
};

}  // namespace thalweg::io
