/// Array: memory that is not zeroed, of operator new or in huge pages by its size.
#include "thalweg/array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "kernel/huge_pages.hpp"

namespace {

using thalweg::detail::Array;
using thalweg::detail::can_map_huge_pages;
using thalweg::detail::kHugePage;

constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();

TEST(Array, HoldsWhatIsWrittenWhateverItsSize) {
  const std::size_t huge = kHugePage / sizeof(std::uint32_t);
  const std::size_t least = thalweg::detail::kLeastOfHugePage / sizeof(std::uint32_t);
  for (const std::size_t size : {std::size_t{1}, std::size_t{1000}, least - 1, least, huge - 1, huge, huge + 1,
                                 huge + least - 1, huge + least, 40 * huge + 7}) {
    Array<std::uint32_t> array(size);
    std::iota(array.begin(), array.end(), 0u);
    std::uint64_t sum = 0;
    for (const std::uint32_t value : array) sum += value;
    EXPECT_EQ(sum, std::uint64_t{size} * (size - 1) / 2);
    if (can_map_huge_pages() && size >= least) {
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(array.data()) % kHugePage, 0u);
    }
  }
}

TEST(Array, GrowsFromSmallToLarge) {
  Array<std::uint64_t> array;
  for (std::uint64_t i = 0; i < 1'000'000; ++i) array.push_back(i * i);
  for (std::uint64_t i = 0; i < 1'000'000; ++i) ASSERT_EQ(array[i], i * i);
  array.resize(3);
  array.shrink_to_fit();
  EXPECT_EQ(array, (Array<std::uint64_t>{0, 1, 4}));
}

TEST(Array, LargeOnesAreApart) {
  std::vector<Array<std::uint8_t>> arrays;
  for (std::uint8_t i = 0; i < 20; ++i) arrays.emplace_back(kHugePage + 100'000u * i, i);
  for (std::size_t i = 0; i < arrays.size(); i += 2) arrays[i] = Array<std::uint8_t>();
  for (std::uint8_t i = 1; i < 20; i += 2) {
    EXPECT_EQ(arrays[i], Array<std::uint8_t>(kHugePage + 100'000u * i, i));
  }
}

TEST(Array, RefusesMoreThanThereCanBe) {
  EXPECT_THROW(thalweg::detail::allocate_array(kMost / 8 + 1, 8), std::bad_array_new_length);
  if (!can_map_huge_pages()) return;  // the address sanitizer's operator new does not throw
  EXPECT_THROW(thalweg::detail::allocate_array(kMost / 2 + 1, 1), std::bad_alloc);
  EXPECT_THROW(thalweg::detail::allocate_array(kMost / 4, 1), std::bad_alloc);
}

}  // namespace
