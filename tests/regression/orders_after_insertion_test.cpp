/// Flips, and then insertions among what they made: the orders of faces that flips had counted are no longer
/// true.
#include <gtest/gtest.h>

#include "support/run.hpp"

namespace {

TEST(Regression, OrdersAreCountedAgainAfterInsertions) {
  const support::Cloud cloud{{{32767, 6004, 8},
                              {-17734, -24065, 8},
                              {-32651, -32768, 0},
                              {-32704, -30198, 10},
                              {-21248, -32630, 2},
                              {-29989, 23515, 0},
                              {-31605, 4096, 6},
                              {-32768, -5771, 14},
                              {-30208, -32768, 10},
                              {17907, 29553, 11},
                              {23360, -29637, 3},
                              {29683, 29440, 0}}};
  for (const auto method : {thalweg::Method::best, thalweg::Method::exact}) {
    EXPECT_EQ(support::find_lie(cloud, support::minimize(cloud, method, 7), 7), std::nullopt);
  }
}

}  // namespace
