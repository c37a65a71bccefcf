/// PageChoice: huge pages while they are at hand, small ones where these cost less.
#include "kernel/page_choice.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <initializer_list>
#include <numeric>
#include <vector>

namespace {

using thalweg::detail::kHugePage;
using thalweg::detail::PageChoice;
using Duration = PageChoice::Duration;

constexpr Duration kCleared = PageChoice::kAtHand / 5;
constexpr Duration kFound = PageChoice::kAtHand * 6;

/// A system with so many huge pages at hand; all others have to be found.
struct System {
  std::size_t at_hand;
  Duration small = PageChoice::kAtHand / 2;
  PageChoice choice = {};
  std::vector<std::size_t> touched = {};  ///< numbers of huge pages, of the last memory
  std::size_t small_timed = 0;

  std::size_t huge_bytes(std::size_t bytes) {
    touched.clear();
    return choice.huge_bytes(
        bytes,
        [&](std::size_t at) {
          EXPECT_EQ(at % kHugePage, 0u);
          EXPECT_LE(at + kHugePage, bytes);
          touched.push_back(at / kHugePage);
          if (at_hand == 0) return kFound;
          --at_hand;
          return kCleared;
        },
        [&] {
          ++small_timed;
          return small;
        });
  }
};

std::vector<std::size_t> first_numbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

TEST(PageChoice, TriesTheFirstPageAndAllOfLongMemory) {
  System system{1'000'000};
  for (const std::size_t bytes : {kHugePage, 2 * kHugePage + 4096, PageChoice::kLong - 4096}) {
    EXPECT_EQ(system.huge_bytes(bytes), bytes);
    EXPECT_EQ(system.touched, first_numbers(1));
  }
  for (const std::size_t rest : {std::size_t{0}, std::size_t{4096}, kHugePage - 4096}) {
    EXPECT_EQ(system.huge_bytes(PageChoice::kLong + rest), PageChoice::kLong + rest);
    EXPECT_EQ(system.touched, first_numbers(PageChoice::kLong / kHugePage));
  }
  EXPECT_EQ(system.small_timed, 0u);
}

TEST(PageChoice, TouchesNothingOfLessThanAHugePage) {
  System system{0};
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{4096}, kHugePage - 1}) {
    EXPECT_EQ(system.huge_bytes(bytes), bytes);
    EXPECT_TRUE(system.touched.empty());
  }
}

TEST(PageChoice, EndsWithTheFirstPageThatHadToBeFound) {
  for (const std::size_t at_hand : std::initializer_list<std::size_t>{0, 1, 31, 39}) {
    System system{at_hand};
    EXPECT_EQ(system.huge_bytes(PageChoice::kLong + 8 * kHugePage), (at_hand + 1) * kHugePage);
    EXPECT_EQ(system.touched, first_numbers(at_hand + 1));
    EXPECT_EQ(system.small_timed, 1u);
  }
}

TEST(PageChoice, TakesSmallPagesInARowBeforeItTriesAgain) {
  System system{0};
  EXPECT_EQ(system.huge_bytes(4 * kHugePage), kHugePage);
  system.at_hand = 1000;
  for (std::size_t taken = 0; taken < PageChoice::kSmallInARow; taken += PageChoice::kSmallInARow / 4) {
    EXPECT_EQ(system.huge_bytes(PageChoice::kSmallInARow / 4), 0u);
    EXPECT_TRUE(system.touched.empty());
  }
  EXPECT_EQ(system.huge_bytes(PageChoice::kLong), PageChoice::kLong);
}

TEST(PageChoice, LongMemoryEndsTheRow) {
  System system{0};
  EXPECT_EQ(system.huge_bytes(kHugePage), kHugePage);
  EXPECT_EQ(system.huge_bytes(10 * PageChoice::kSmallInARow), 0u);
  EXPECT_EQ(system.huge_bytes(3 * kHugePage), kHugePage);
}

TEST(PageChoice, TakesHugePagesWhereSmallOnesAreNoCheaper) {
  System system{0, kFound};
  EXPECT_EQ(system.huge_bytes(PageChoice::kLong), PageChoice::kLong);
  EXPECT_EQ(system.touched, first_numbers(1));
  EXPECT_EQ(system.small_timed, 1u);
  EXPECT_EQ(system.huge_bytes(PageChoice::kLong), PageChoice::kLong);
}

}  // namespace
