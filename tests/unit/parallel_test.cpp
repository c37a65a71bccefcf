/// parallel_chunks: every item once, in whole chunks, whatever the number of threads; exceptions reach the
/// caller.
#include "kernel/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <set>
#include <thread>
#include <vector>

namespace {

using thalweg::detail::parallel_chunks;
using thalweg::detail::resolve_threads;

/// How often each item was met.
std::vector<int> visits(std::size_t count, std::size_t chunk, unsigned threads) {
  std::vector<int> met(count, 0);  // every item written by one thread only
  parallel_chunks(count, chunk, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      EXPECT_LT(begin, end);
      EXPECT_EQ(begin % chunk, 0u);
      EXPECT_EQ(end, std::min(begin + chunk, count));
      for (std::size_t i = begin; i < end; ++i) ++met[i];
    };
  });
  return met;
}

TEST(ParallelChunks, MeetEveryItemOnce) {
  for (const std::size_t count : {1u, 2u, 7u, 64u, 65u, 1000u}) {
    for (const std::size_t chunk : {1u, 2u, 64u, 5000u}) {
      for (const unsigned threads : {0u, 1u, 2u, 3u, 16u}) {
        EXPECT_EQ(visits(count, chunk, threads), std::vector<int>(count, 1));
      }
    }
  }
}

TEST(ParallelChunks, OfNothingCallNoWork) {
  for (const unsigned threads : {0u, 1u, 4u}) EXPECT_EQ(visits(0, 10, threads), std::vector<int>());
}

TEST(ParallelChunks, UseNoMoreThreadsThanChunks) {
  std::atomic<int> workers{0};
  parallel_chunks(3, 1, 64, [&] {
    ++workers;
    return [](std::size_t, std::size_t) {};
  });
  EXPECT_GE(workers, 1);
  EXPECT_LE(workers, 3);
}

TEST(ParallelChunks, WithOneThreadStayInTheCallingThreadAndInOrder) {
  std::vector<std::size_t> begins;
  std::set<std::thread::id> threads;
  parallel_chunks(100, 7, 1, [&] {
    return [&](std::size_t begin, std::size_t) {
      begins.push_back(begin);
      threads.insert(std::this_thread::get_id());
    };
  });
  EXPECT_EQ(begins.size(), 15u);
  EXPECT_TRUE(std::is_sorted(begins.begin(), begins.end()));
  EXPECT_EQ(threads, std::set{std::this_thread::get_id()});
}

TEST(ParallelChunks, MakeOneWorkerAThread) {
  std::mutex lock;
  std::set<std::thread::id> makers;
  std::atomic<int> workers{0};
  parallel_chunks(1000, 1, 4, [&] {
    ++workers;
    const std::lock_guard guard(lock);
    makers.insert(std::this_thread::get_id());
    return
        [scratch = std::vector<int>(10)](std::size_t begin, std::size_t) mutable { ++scratch[begin % 10]; };
  });
  EXPECT_EQ(static_cast<std::size_t>(workers), makers.size());
  EXPECT_LE(workers, 4);
}

TEST(ParallelChunks, PassOnAnExceptionAfterAllThreadsHaveStopped) {
  for (const unsigned threads : {1u, 2u, 8u}) {
    std::atomic<int> running{0};
    const auto run = [&] {
      parallel_chunks(100, 1, threads, [&] {
        return [&](std::size_t begin, std::size_t) {
          ++running;
          const bool fail = begin == 20;
          --running;
          if (fail) throw std::bad_alloc();
        };
      });
    };
    EXPECT_THROW(run(), std::bad_alloc);
    EXPECT_EQ(running, 0);
  }
}

TEST(ParallelChunks, PassOnAnExceptionOfMakeWorker) {
  const auto run = [] {
    parallel_chunks(100, 1, 4, []() -> void (*)(std::size_t, std::size_t) { throw std::bad_alloc(); });
  };
  EXPECT_THROW(run(), std::bad_alloc);
}

TEST(ParallelChunks, GiveOutNoMoreWorkAfterAnException) {
  std::size_t met = 0;
  const auto run = [&] {
    parallel_chunks(100, 1, 1, [&] {
      return [&](std::size_t begin, std::size_t) {
        ++met;
        if (begin == 3) throw std::bad_alloc();
      };
    });
  };
  EXPECT_THROW(run(), std::bad_alloc);
  EXPECT_EQ(met, 4u);
}

TEST(PartsOf, AreNoMoreThanThreadsAndNoneIsTooSmall) {
  using thalweg::detail::parts_of;
  EXPECT_EQ(parts_of(0, 10, 4), 1u);
  EXPECT_EQ(parts_of(9, 10, 4), 1u);
  EXPECT_EQ(parts_of(20, 10, 4), 2u);
  EXPECT_EQ(parts_of(39, 10, 4), 3u);
  EXPECT_EQ(parts_of(1000, 10, 4), 4u);
  EXPECT_EQ(parts_of(1000, 10, 0), std::min(100u, resolve_threads(0)));
}

TEST(ParallelParts, AreConsecutiveAndEqual) {
  for (const std::size_t count : {0u, 5u, 64u, 1000u}) {
    for (const std::size_t parts : {1u, 3u, 5u, 8u}) {
      std::vector<std::size_t> begins(parts), ends(parts);
      thalweg::detail::parallel_parts(count, parts, [&](std::size_t i, std::size_t begin, std::size_t end) {
        begins[i] = begin;
        ends[i] = end;
      });
      EXPECT_EQ(begins.front(), 0u);
      EXPECT_EQ(ends.back(), count);
      for (std::size_t i = 0; i < parts; ++i) {
        if (i > 0) {
          EXPECT_EQ(begins[i], ends[i - 1]);
        }
        EXPECT_GE(ends[i] - begins[i], count / parts);
        EXPECT_LE(ends[i] - begins[i], count / parts + 1);
        for (std::size_t item = begins[i]; item < ends[i]; ++item)
          EXPECT_EQ(thalweg::detail::part_with(item, count, parts), i);
      }
    }
  }
}

TEST(ParallelBoth, CallEachOnceWithOneThreadInOrder) {
  for (const unsigned threads : {0u, 1u, 2u, 8u}) {
    int first = 0, second = 0;  // each written by one thread only
    thalweg::detail::parallel_both(
        threads, [&] { ++first; }, [&] { second += threads == 1 ? 1 + first : 2; });
    EXPECT_EQ(first, 1);
    EXPECT_EQ(second, 2);
  }
}

TEST(ParallelBoth, PassOnAnExceptionOfEither) {
  for (const unsigned threads : {1u, 2u}) {
    const auto fail = [] { throw std::bad_alloc(); };
    EXPECT_THROW(thalweg::detail::parallel_both(threads, fail, [] {}), std::bad_alloc);
    EXPECT_THROW(thalweg::detail::parallel_both(
                     threads, [] {}, fail),
                 std::bad_alloc);
  }
}

TEST(ResolveThreads, ZeroStandsForTheMachine) {
  EXPECT_GE(resolve_threads(0), 1u);
  EXPECT_EQ(resolve_threads(1), 1u);
  EXPECT_EQ(resolve_threads(37), 37u);
}

TEST(ParallelFor, TakesEveryIndexOnce) {
  for (const std::size_t count : {0u, 1u, 65535u, 65536u, 200001u}) {
    for (const unsigned threads : {1u, 2u, 3u, 7u}) {
      std::vector<int> taken(count, 0);
      thalweg::detail::parallel_for(count, threads, [&](std::size_t i) { ++taken[i]; });
      EXPECT_EQ(static_cast<std::size_t>(std::count(taken.begin(), taken.end(), 1)), count);
    }
  }
}

}  // namespace
