/// Time and memory: what a run takes, and what one would take.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "thalweg/minimize.hpp"

namespace thalweg::cli {

/// Seconds since it was made or last asked.
class Stopwatch {
 public:
  double lap() noexcept;
  double total() const noexcept;

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

/// The most memory this process ever had.
std::uint64_t peak_memory_bytes() noexcept;

/// The memory of this machine; 0 if unknown.
std::uint64_t machine_memory_bytes() noexcept;

/// About how much memory `thalweg build` needs at its peak for so many points: the program itself, the points
/// as they are read, and what the method makes of each: sites in order, the Delaunay triangulation, its copy
/// that is changed, and for flip the queue of edges besides; and what a report gathers of both terrains when
/// that is done, if there is to be one. `exact` searches in memory of its own only where `best` leaves a gap;
/// that is not counted, nor is a --counter other than crawl.
std::uint64_t estimate_build_memory(std::uint64_t points, Method method, bool report) noexcept;

/// Nothing, or why `points` points must not be built under --max-memory `limit`, and what to do.
std::optional<std::string> over_limit(std::uint64_t points, Method method, bool report,
                                      std::optional<std::uint64_t> limit);

/// The number of threads that --threads stands for.
unsigned thread_count(unsigned asked) noexcept;

}  // namespace thalweg::cli
