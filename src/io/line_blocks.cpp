#include "io/line_blocks.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace thalweg::io {

LineBlocks::LineBlocks(InputFile& input, std::size_t block_size)
    : input_(input),
      // One byte more than there is, so that the end shows without another round.
      capacity_(static_cast<std::size_t>(std::min<std::uint64_t>(
          block_size, std::max<std::uint64_t>(input.unread().value_or(block_size), 1) + 1))),
      buffer_(std::make_unique_for_overwrite<char[]>(capacity_)) {}

void LineBlocks::enlarge() {
  auto larger = std::make_unique_for_overwrite<char[]>(2 * capacity_);
  std::memcpy(larger.get(), buffer_.get(), used_);
  buffer_ = std::move(larger);
  capacity_ *= 2;
}

Result<std::string_view> LineBlocks::next() {
  used_ -= given_;
  std::memmove(buffer_.get(), buffer_.get() + given_, used_);
  for (std::size_t searched = 0;; enlarge()) {
    const Result<std::size_t> count = input_.read(buffer_.get() + used_, capacity_ - used_);
    if (!count) return count.error();
    used_ += *count;
    if (used_ < capacity_) return std::string_view(buffer_.get(), given_ = used_);  // the end of the file
    const std::string_view fresh(buffer_.get() + searched, used_ - searched);
    const std::size_t newline = fresh.rfind('\n');
    if (newline != std::string_view::npos)
      return std::string_view(buffer_.get(), given_ = searched + newline + 1);
    searched = used_;
  }
}

}  // namespace thalweg::io
