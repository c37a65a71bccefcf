/// Array: memory that is not zeroed, of operator new or in huge pages by its size; and pages that are kept.
#include "thalweg/array.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <fstream>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "kernel/cut_short.hpp"
#include "kernel/huge_pages.hpp"

namespace {

using thalweg::detail::Array;
using thalweg::detail::can_map_huge_pages;
using thalweg::detail::KeptPages;
using thalweg::detail::kHugePage;

constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();

TEST(Array, HoldsWhatIsWrittenWhateverItsSize) {
  const std::size_t huge = kHugePage / sizeof(std::uint32_t);
  const std::size_t least = thalweg::detail::kLeastOfHugePage / sizeof(std::uint32_t);
  for (const std::size_t size : {std::size_t{1}, std::size_t{1000}, least - 1, least, huge - 1, huge,
                                 huge + 1, huge + least - 1, huge + least, 40 * huge + 7}) {
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

/// Bytes of this process as Linux counts them; 0 if it does not say.
struct ProcessBytes {
  std::size_t addresses = 0, resident = 0;
};
ProcessBytes process_bytes() {
  std::ifstream file("/proc/self/statm");
  ProcessBytes pages;
  file >> pages.addresses >> pages.resident;
  return {pages.addresses * 4096, pages.resident * 4096};
}

TEST(Array, IsCutShortWhereItIs) {
  for (const std::size_t count : {std::size_t{10}, std::size_t{100'000}, std::size_t{6'000'000}}) {
    Array<std::uint32_t> array(count);
    std::iota(array.begin(), array.end(), 0u);
    const std::uint32_t* const data = array.data();
    const std::size_t before = process_bytes().resident;
    thalweg::detail::cut_short(array, count / 2);
    ASSERT_EQ(array.size(), count / 2);
    std::uint64_t sum = 0;
    for (const std::uint32_t value : array) sum += value;
    EXPECT_EQ(sum, std::uint64_t{count / 2} * (count / 2 - 1) / 2);
    if (can_map_huge_pages() && count > 1'000'000) {
      EXPECT_EQ(array.data(), data);
      EXPECT_LT(process_bytes().resident + count, before);  // a quarter is gone, where a half is due
    }
    array.resize(count, 7u);  // a vector like any other
    EXPECT_EQ(array[count / 2 - 1], count / 2 - 1);
    EXPECT_EQ(array[count / 2], 7u);
    EXPECT_EQ(array.back(), 7u);
    thalweg::detail::cut_short(array, 0);
    EXPECT_TRUE(array.empty());
  }
}

TEST(Array, IsNotMovedWhereThereIsNothingToGiveBack) {
  if (!can_map_huge_pages()) return;
  Array<std::uint8_t> array(kHugePage + 50'000, std::uint8_t{1});
  const std::uint8_t* const data = array.data();
  thalweg::detail::cut_short(array, kHugePage + 10);
  EXPECT_EQ(array.data(), data);
}

TEST(Array, LeavesNoAddressesBehind) {
  if (!can_map_huge_pages()) return;
  const std::size_t before = process_bytes().addresses;
  for (std::size_t i = 0; i < 1000; ++i) {
    const std::size_t bytes = kHugePage + i * 4096;
    thalweg::detail::deallocate_array(thalweg::detail::allocate_array(bytes, 1), bytes, 1);
  }
  EXPECT_LT(process_bytes().addresses, before + 100 * kHugePage);
}

/// An array of so many bytes, all of them `value`.
Array<std::uint8_t> filled(std::size_t bytes, std::uint8_t value) {
  return Array<std::uint8_t>(bytes, value);
}

TEST(KeptPages, ServeWhatIsAskedForNext) {
  if (!can_map_huge_pages()) return;
  const KeptPages outer;
  const void* first = nullptr;
  {
    const Array<std::uint8_t> array = filled(4 * kHugePage, 1);
    first = array.data();
  }
  const KeptPages inner;
  const Array<std::uint8_t> a = filled(kHugePage + kHugePage / 2, 2), b = filled(2 * kHugePage, 3);
  EXPECT_EQ(a.data(), first);
  EXPECT_EQ(b.data(), a.data() + 2 * kHugePage);
}

TEST(KeptPages, ServeArraysOfAnySizeInAnyOrder) {
  if (!can_map_huge_pages()) return;
  std::minstd_rand random(5);
  for (int round = 0; round < 5; ++round) {
    std::vector<Array<std::uint8_t>> survivors;
    {
      const KeptPages pages;
      std::vector<Array<std::uint8_t>> arrays(6);
      for (std::uint8_t i = 0; i < 100; ++i) {
        Array<std::uint8_t>& array = arrays[random() % arrays.size()];
        const std::size_t bytes = 1 + random() % (random() % 4 == 0 ? 5 * kHugePage : kHugePage / 4);
        if (random() % 2 == 0) array = Array<std::uint8_t>();
        array = filled(bytes, i);
        for (const auto& other : arrays)
          ASSERT_TRUE(other.empty() ||
                      (other.front() == other.back() && other.front() == other[other.size() / 2]));
      }
      survivors.push_back(std::move(arrays[0]));
      survivors.push_back(std::move(arrays[3]));
    }
    for (const auto& array : survivors)
      ASSERT_EQ(array, filled(array.size(), array.empty() ? std::uint8_t{0} : array.front()));
  }
}

TEST(Array, RefusesMoreThanThereCanBe) {
  EXPECT_THROW(thalweg::detail::allocate_array(kMost / 8 + 1, 8), std::bad_array_new_length);
  if (!can_map_huge_pages()) return;  // the address sanitizer's operator new does not throw
  EXPECT_THROW(thalweg::detail::allocate_array(kMost / 2 + 1, 1), std::bad_alloc);
  EXPECT_THROW(thalweg::detail::allocate_array(kMost / 4, 1), std::bad_alloc);
}

}  // namespace
