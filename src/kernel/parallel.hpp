/// Work shared among threads whose result cannot depend on how it was shared: every item writes to a place of
/// its own.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>

#include "kernel/thread_team.hpp"

namespace thalweg::detail {

/// The number of threads that `asked` stands for: itself, or for 0 the machine's. Returns at least 1.
inline unsigned resolve_threads(unsigned asked) noexcept {
  return asked != 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

/// Calls work(begin, end) for consecutive chunks of [0, count), each chunk in one thread; `work` is made anew
/// by make_worker() in every thread, so that it can own scratch memory. The calling thread takes part; the
/// others are those of its TeamScope, or else made for this. Exceptions (std::bad_alloc) reach the caller
/// after all threads have stopped.
template <class MakeWorker>
void parallel_chunks(std::size_t count, std::size_t chunk, unsigned threads, MakeWorker&& make_worker) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_lock;
  const auto run = [&] {
    try {
      auto work = make_worker();
      for (std::size_t begin; (begin = next.fetch_add(chunk)) < count;) {
        work(begin, std::min(begin + chunk, count));
      }
    } catch (...) {
      next.store(count);
      const std::lock_guard guard(failure_lock);
      failure = std::current_exception();
    }
  };
  const std::size_t chunks = (count + chunk - 1) / chunk;
  const auto workers = static_cast<unsigned>(std::min<std::size_t>(resolve_threads(threads), chunks));
  if (workers > 1) {
    TeamScope(workers).team().share(run, workers - 1);
  } else {
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

/// Calls first() and second(), at the same time where there are two threads. Neither may read what the other
/// writes.
template <class First, class Second>
void parallel_both(unsigned threads, const First& first, const Second& second) {
  parallel_chunks(2, 1, threads, [&] {
    return [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) i == 0 ? first() : second();
    };
  });
}

/// How many of `threads` are worth having for `count` items, of which a thread should have `least` or more.
inline std::size_t parts_of(std::size_t count, std::size_t least, unsigned threads) noexcept {
  return std::clamp<std::size_t>(count / least, 1, resolve_threads(threads));
}

/// Calls task(i, begin, end) for `parts` equal parts of [0, count), each in a thread of its own if possible.
template <class Task>
void parallel_parts(std::size_t count, std::size_t parts, Task&& task) {
  parallel_chunks(parts, 1, static_cast<unsigned>(parts), [&] {
    return [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) task(i, count * i / parts, count * (i + 1) / parts);
    };
  });
}

/// Which of the `parts` of parallel_parts has an item.
inline std::size_t part_with(std::size_t item, std::size_t count, std::size_t parts) noexcept {
  return ((item + 1) * parts - 1) / count;
}

/// Calls task(i) for every i below `count`, in parts on several threads where there are many. For tasks of a
/// few instructions, whose data lies where i does.
template <class Task>
void parallel_for(std::size_t count, unsigned threads, Task&& task) {
  constexpr std::size_t kLeast = 1u << 16;
  parallel_parts(count, parts_of(count, kLeast, threads),
                 [&](std::size_t, std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) task(i);
                 });
}

}  // namespace thalweg::detail
