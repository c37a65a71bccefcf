/// A lake of the Delaunay triangulation that the result cuts in two: its parts are ways out for each other.
#include <gtest/gtest.h>

#include "support/run.hpp"

namespace {

TEST(Regression, PartsOfASplitLakeKnowOfEachOther) {
  const support::Cloud cloud{{{1, 7, 1}, {11, 2, 0}, {9, 0, 0}, {10, 1, 1}, {3, 0, 1}, {6, 6, 0}, {0, 7, 0}}};
  for (const auto method : {thalweg::Method::best, thalweg::Method::exact}) {
    EXPECT_EQ(support::find_wrong_reason(cloud, support::minimize(cloud, method, 3), 3), std::nullopt);
  }
}

}  // namespace
