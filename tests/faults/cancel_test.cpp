/// The caller asks to stop, in each of the calls of his progress function: the call ends soon with
/// ErrorCode::cancelled, or the answer was there already and is the right one.
#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <vector>

#include "support/failing_new.h"
#include "support/random.hpp"
#include "thalweg/thalweg.hpp"

namespace {

using thalweg::Method;
using thalweg::Point3;

std::vector<Point3> rough_ground(std::uint32_t count) {
  support::Random random(count);
  std::vector<Point3> points;
  for (std::uint32_t i = 0; i < count; ++i) {
    points.push_back({random.whole(0, 40), random.whole(0, 40), random.whole(0, 30)});
  }
  return points;
}

/// Runs with a wish to stop in the call of progress number `at`; how often it was called.
template <class Run>
long cancel_at(long at, thalweg::MinimizeOptions options, Run run) {
  std::atomic<bool> cancel = false;
  long calls = 0;
  options.cancel = &cancel;
  options.progress = [&](const char*, double) {
    if (calls++ == at) cancel = true;
  };
  run(options);
  return calls;
}

class Cancelling : public testing::TestWithParam<Method> {};

TEST_P(Cancelling, AtEveryProgress) {
  const auto points = rough_ground(300);
  const auto copy = points;
  for (const unsigned threads : {1u, 4u}) {
    thalweg::MinimizeOptions options;
    options.order = 5;
    options.method = GetParam();
    options.threads = threads;
    const auto whole = thalweg::minimize_pits(points, options);
    ASSERT_TRUE(whole);
    long at = 0, stopped = 0, calls = 0;
    do {
      const long live = live_allocations();
      calls = cancel_at(at, options, [&](const thalweg::MinimizeOptions& asked) {
        const auto result = thalweg::minimize_pits(points, asked);
        if (result) {
          EXPECT_TRUE(result->triangulation == whole->triangulation) << at;
        } else {
          EXPECT_EQ(result.error().code, thalweg::ErrorCode::cancelled) << at;
          ++stopped;
        }
      });
      EXPECT_EQ(live_allocations(), live) << at;
      EXPECT_EQ(std::memcmp(points.data(), copy.data(), points.size() * sizeof(Point3)), 0) << at;
      ++at;
    } while (calls >= at);  // the last time there is no such call
    EXPECT_GE(stopped, 3);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, Cancelling,
                         testing::Values(Method::delaunay, Method::flip, Method::hull, Method::best,
                                         Method::exact));

TEST(Cancelling, OfSweepsAtEveryProgress) {
  const auto points = rough_ground(200);
  long at = 0, calls = 0;
  do {
    const long live = live_allocations();
    calls = cancel_at(at, {.threads = 2}, [&](const thalweg::MinimizeOptions& asked) {
      const auto sweep = thalweg::sweep_pits(points, 0, 6, asked);
      if (sweep) {
        EXPECT_EQ(sweep->rows.size(), 7u);
      } else {
        EXPECT_EQ(sweep.error().code, thalweg::ErrorCode::cancelled);
      }
    });
    EXPECT_EQ(live_allocations(), live) << at;
    ++at;
  } while (calls >= at);
  EXPECT_GT(at, 7);
}

}  // namespace
