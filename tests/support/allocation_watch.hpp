/// Notes the largest single request for memory made through operator new by the executable it is linked into.
#pragma once

#include <cstddef>

namespace thalweg::test {

/// Starts over.
void reset_largest_allocation() noexcept;

/// Bytes of the largest request since.
std::size_t largest_allocation() noexcept;

}  // namespace thalweg::test
