/// Array: memory that is not zeroed, small and of the size for which large pages are asked.
#include "thalweg/array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>

namespace {

using thalweg::detail::Array;

TEST(Array, HoldsWhatIsWrittenWhateverItsSize) {
  for (const std::size_t size : {std::size_t{1}, std::size_t{1000}, (std::size_t{4} << 20) + 7,
                                 (std::size_t{8} << 20), (std::size_t{9} << 20) + 1}) {
    Array<std::uint32_t> array(size);
    std::iota(array.begin(), array.end(), 0u);
    std::uint64_t sum = 0;
    for (const std::uint32_t value : array) sum += value;
    EXPECT_EQ(sum, std::uint64_t{size} * (size - 1) / 2);
  }
}

TEST(Array, RefusesMoreThanThereCanBe) {
  EXPECT_THROW(thalweg::detail::allocate_array(std::numeric_limits<std::size_t>::max() / 8 + 1, 8),
               std::bad_array_new_length);
}

}  // namespace
