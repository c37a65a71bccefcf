#include "io/byte_window.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

namespace thalweg::io {

ByteWindow::ByteWindow(InputFile& input, std::size_t start) : input_(input) {
  input.seek(start);
  const std::uint64_t unread = input.unread().value_or(InputFile::kFirstLoad);
  capacity_ = static_cast<std::size_t>(std::min<std::uint64_t>(InputFile::kFirstLoad, unread + 1));
  buffer_ = std::make_unique_for_overwrite<char[]>(capacity_);
}

Result<std::string_view> ByteWindow::peek(std::size_t least) {
  if (last_ - first_ < least) {
    const std::size_t kept = last_ - first_;
    if (least > capacity_) {
      auto larger = std::make_unique_for_overwrite<char[]>(least);
      std::memcpy(larger.get(), buffer_.get() + first_, kept);
      buffer_ = std::move(larger);
      capacity_ = least;
    } else {
      std::memmove(buffer_.get(), buffer_.get() + first_, kept);
    }
    const Result<std::size_t> count = input_.read(buffer_.get() + kept, capacity_ - kept);
    if (!count) return count.error();
    first_ = 0;
    last_ = kept + *count;
  }
  return std::string_view(buffer_.get() + first_, last_ - first_);
}

}  // namespace thalweg::io
