/// A binary file through a window of bounded size.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "io/input_file.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

class ByteWindow {
 public:
  /// Begins after the first `start` bytes. Requires: they are loaded; `input` outlives it.
  ByteWindow(InputFile& input, std::size_t start);

  /// What is in the window: the next `least` bytes or more, fewer only at the end of the file. Valid until
  /// the next call.
  Result<std::string_view> peek(std::size_t least);

  /// Passes over bytes. Requires: that many in the window.
  void advance(std::size_t count) noexcept { first_ += count; }

 private:
  InputFile& input_;
  std::size_t capacity_ = 0;
  std::unique_ptr<char[]> buffer_;
  std::size_t first_ = 0;  // the window is [first_, last_) of the buffer
  std::size_t last_ = 0;
};

}  // namespace thalweg::io
