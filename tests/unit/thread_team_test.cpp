/// ThreadTeam: work shared among threads that are kept, also by work that is shared itself.
#include "kernel/thread_team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <ctime>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

#include "kernel/parallel.hpp"

namespace {

using thalweg::detail::parallel_chunks;
using thalweg::detail::TeamScope;
using thalweg::detail::ThreadTeam;

/// The threads that work was done on.
class Threads {
 public:
  void note() {
    const std::lock_guard guard(lock_);
    ids_.insert(std::this_thread::get_id());
  }
  const std::set<std::thread::id>& ids() const { return ids_; }

 private:
  std::mutex lock_;
  std::set<std::thread::id> ids_;
};

/// Waits until so many have come, so that they must be different threads.
class Meeting {
 public:
  explicit Meeting(int members) : missing_(members) {}
  void join() {
    --missing_;
    while (missing_ > 0) std::this_thread::yield();
  }

 private:
  std::atomic<int> missing_;
};

TEST(ThreadTeam, RunsInAsManyThreadsAtOnceAsAreAskedFor) {
  ThreadTeam team(4);
  Meeting meeting(4);
  Threads threads;
  const auto run = [&] {
    meeting.join();
    threads.note();
  };
  team.share(run, 3);
  EXPECT_EQ(threads.ids().size(), 4u);
  EXPECT_EQ(threads.ids().count(std::this_thread::get_id()), 1u);
}

TEST(ThreadTeam, KeepsItsThreads) {
  ThreadTeam team(3);
  Threads threads;
  for (int i = 0; i < 50; ++i) {
    Meeting meeting(3);
    const auto run = [&] {
      meeting.join();
      threads.note();
    };
    team.share(run, 2);
  }
  EXPECT_EQ(threads.ids().size(), 3u);
}

TEST(ThreadTeam, HasNoMoreThreadsThanItMay) {
  for (const unsigned most : {0u, 1u, 2u, 5u}) {
    ThreadTeam team(most);
    Threads threads;
    std::atomic<int> calls{0};
    for (int i = 0; i < 20; ++i) {
      const auto run = [&] {
        ++calls;
        threads.note();
      };
      team.share(run, 40);
    }
    EXPECT_LE(threads.ids().size(), std::max(most, 1u));
    EXPECT_GE(calls, 20);
  }
}

/// Looking for work ends. The bound is a hundred times what two helpers may look for.
TEST(ThreadTeam, SleepsWhereThereIsNoWork) {
  ThreadTeam team(3);
  Meeting meeting(3);
  const auto run = [&] { meeting.join(); };
  team.share(run, 2);
  const std::clock_t before = std::clock();
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_LT(std::clock() - before, CLOCKS_PER_SEC / 25);
  Meeting again(3);
  const auto run_again = [&] { again.join(); };
  team.share(run_again, 2);
}

/// Who has work of its own to share waits only for those who have begun it.
TEST(ThreadTeam, SharesWithinWhatIsShared) {
  ThreadTeam team(3);
  for (int i = 0; i < 200; ++i) {
    std::atomic<int> outer{0}, inner{0};
    const auto deep = [&] { ++inner; };
    const auto run = [&] {
      ++outer;
      team.share(deep, 2);
    };
    team.share(run, 2);
    EXPECT_GE(outer, 1);
    EXPECT_LE(outer, 3);
    EXPECT_GE(inner, outer);
    EXPECT_LE(inner, 3 * outer);
  }
}

TEST(TeamScope, IsTheOuterOneWithinAnother) {
  const TeamScope outer(3);
  const TeamScope inner(8);
  EXPECT_EQ(&outer.team(), &inner.team());
  std::thread([&] {
    const TeamScope other(2);
    EXPECT_NE(&other.team(), &outer.team());
  }).join();
}

TEST(TeamScope, EndsWithItsScope) {
  for (int i = 0; i < 3; ++i) {
    const TeamScope scope(2);
    Meeting meeting(2);
    const auto run = [&] { meeting.join(); };
    scope.team().share(run, 1);
  }
}

/// Chunks in chunks in chunks, each item once, on no more threads than the outermost scope has.
TEST(TeamScope, HoldsForChunksWithinChunks) {
  const TeamScope scope(4);
  Threads threads;
  std::vector<std::atomic<int>> met(8 * 8 * 8);
  parallel_chunks(8, 1, 4, [&] {
    return [&](std::size_t i, std::size_t) {
      parallel_chunks(8, 1, 4, [&, i] {
        return [&, i](std::size_t j, std::size_t) {
          parallel_chunks(8, 1, 4, [&, i, j] {
            return [&, i, j](std::size_t k, std::size_t) {
              threads.note();
              ++met[(i * 8 + j) * 8 + k];
            };
          });
        };
      });
    };
  });
  for (const auto& count : met) EXPECT_EQ(count, 1);
  EXPECT_LE(threads.ids().size(), 4u);
}

}  // namespace
