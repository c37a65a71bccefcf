/// Puts rows of numbers and words together on their way to an OutputFile.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "io/number.hpp"
#include "io/output_file.hpp"

namespace thalweg::io {

/// A small buffer in front of an OutputFile into which numbers are printed in place. Empties itself when
/// destroyed.
class RowWriter {
 public:
  explicit RowWriter(OutputFile& output) noexcept : output_(output) {}
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;
  ~RowWriter() { flush(); }

  RowWriter& operator<<(char c) {
    make_room(1);
    buffer_[used_++] = c;
    return *this;
  }
  RowWriter& operator<<(std::string_view text) {
    if (text.size() > kSize) {
      flush();
      output_.write(text);
      return *this;
    }
    make_room(text.size());
    std::memcpy(buffer_.data() + used_, text.data(), text.size());
    used_ += text.size();
    return *this;
  }
  RowWriter& operator<<(const char* text) { return *this << std::string_view(text); }
  RowWriter& operator<<(double value) { return number(value); }
  template <std::unsigned_integral T>
  RowWriter& operator<<(T value) {
    return number(std::uint64_t{value});
  }

  /// The bytes of `value` as they are in memory. Requires: a little endian machine, or a swapped value.
  template <class T>
  RowWriter& raw(T value) {
    make_room(sizeof(T));
    std::memcpy(buffer_.data() + used_, &value, sizeof(T));
    used_ += sizeof(T);
    return *this;
  }

  /// Whether nothing written from now on will reach a file; loops stop early then.
  bool failed() const noexcept { return output_.error().has_value(); }

  void flush() {
    output_.write({buffer_.data(), used_});
    used_ = 0;
  }

 private:
  static constexpr std::size_t kSize = 1 << 14;

  template <class T>
  RowWriter& number(T value) {
    make_room(kNumberSize);
    char* const start = buffer_.data() + used_;
    used_ += static_cast<std::size_t>(put_number(start, value) - start);
    return *this;
  }
  void make_room(std::size_t count) {
    if (count > kSize - used_) flush();
  }

  OutputFile& output_;
  std::array<char, kSize> buffer_;
  std::size_t used_ = 0;
};

}  // namespace thalweg::io
