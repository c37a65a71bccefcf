/// What a failed property of the heuristics looks like: few points, to be pasted into a test.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <string>

#include "support/cloud.hpp"
#include "thalweg/thalweg.hpp"

namespace {

/// False, and four points show it: three around a lower one.
void no_pit_is_inside() {
  const support::Cloud cloud = *support::clouds(40);
  const auto terrain = thalweg::minimize_pits(cloud.points, {.method = thalweg::Method::delaunay});
  RC_ASSERT(terrain->pits.interior == 0u);
}

TEST(Clouds, FailuresShrinkToAFewPointsToPaste) {
  const rc::detail::TestResult result = rc::detail::checkTestable(no_pit_is_inside);
  rc::detail::FailureResult failure;
  ASSERT_TRUE(result.match(failure));
  ASSERT_EQ(failure.counterExample.size(), 1u);
  const std::string& shown = failure.counterExample[0].second;
  EXPECT_TRUE(shown.starts_with("const std::vector<thalweg::Point3> points = {{")) << shown;
  EXPECT_TRUE(shown.ends_with("}};")) << shown;
  EXPECT_LE(std::count(shown.begin(), shown.end(), '{') - 1, 6) << shown;
}

}  // namespace
