/// Runs a few independent tasks at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace thalweg::io {

/// The number of threads that `asked` stands for: itself, or for 0 the machine's. Returns at least 1.
inline unsigned resolve_threads(unsigned asked) noexcept {
  return asked != 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

/// Calls task(i) for every i < count, each on a thread of its own as far as the system grants them, the rest
/// here. What a task throws (std::bad_alloc) is thrown again once all have ended.
template <class Task>
void run_all(std::size_t count, Task&& task) {
  std::vector<std::exception_ptr> thrown(count);
  const auto guarded = [&](std::size_t i) {
    try {
      task(i);
    } catch (...) {
      thrown[i] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  threads.reserve(count);
  std::size_t started = 1;
  try {
    for (; started < count; ++started) threads.emplace_back(guarded, started);
  } catch (const std::system_error&) {  // no more threads to be had: the work is done here instead
  } catch (const std::bad_alloc&) {     // the same for want of memory
  }
  if (count > 0) guarded(0);
  for (std::size_t i = started; i < count; ++i) guarded(i);
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
}

}  // namespace thalweg::io
