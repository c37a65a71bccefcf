/// A text in blocks of whole lines, so that a file of any size is read in bounded memory.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "io/input_file.hpp"
#include "thalweg/result.hpp"

namespace thalweg::io {

class LineBlocks {
 public:
  /// Blocks of about this size, from where `input` stands; larger only where a line is. Requires: `input`
  /// outlives it.
  LineBlocks(InputFile& input, std::size_t block_size);

  /// The next lines, with the end of the last one unless the text ends without; empty at its end. It is valid
  /// until the next call.
  Result<std::string_view> next();

 private:
  void enlarge();

  InputFile& input_;
  std::size_t capacity_;
  std::unique_ptr<char[]> buffer_;
  std::size_t used_ = 0;   // bytes in the buffer
  std::size_t given_ = 0;  // of them, those of the block last returned
};

}  // namespace thalweg::io
