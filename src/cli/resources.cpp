/// Time and memory.
#include "cli/resources.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <thread>

#include "cli/text.hpp"

namespace thalweg::cli {

double Stopwatch::lap() noexcept {
  const Clock::time_point now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - last_).count();
  last_ = now;
  return seconds;
}

double Stopwatch::total() const noexcept {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

std::uint64_t peak_memory_bytes() noexcept {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

std::uint64_t machine_memory_bytes() noexcept {
  const long pages = sysconf(_SC_PHYS_PAGES);
  const long size = sysconf(_SC_PAGESIZE);
  if (pages <= 0 || size <= 0) return 0;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(size);
}

std::uint64_t estimate_build_memory(std::uint64_t points, Method method, bool report) noexcept {
  // Measured, by the peak memory that --json reports.
  constexpr std::uint64_t kFixed = std::uint64_t{16} << 20;
  constexpr std::uint64_t kInput = 24;  // a point: three doubles
  constexpr std::uint64_t kBest = 170;  // and delaunay, hull, exact
  constexpr std::uint64_t kFlip = 308;
  constexpr std::uint64_t kReport = 440;  // after the method, whose own memory is free again
  const std::uint64_t build = method == Method::flip ? kFlip : kBest;
  // What arrays leave empty of their huge pages, measured too: less for few points, whose arrays have none.
  const std::uint64_t most_empty = std::uint64_t{method == Method::flip ? 44u : 18u} << 20;
  const std::uint64_t empty = std::min(most_empty, 2 * points * build);
  return kFixed + empty + points * (kInput + (report ? std::max(build, kReport) : build));
}

std::optional<std::string> over_limit(std::uint64_t points, Method method, bool report,
                                      std::optional<std::uint64_t> limit) {
  const std::uint64_t needed = estimate_build_memory(points, method, report);
  if (!limit || needed <= *limit) return std::nullopt;
  return counted(points, "point needs", "points need") + " about " + format_bytes(needed) +
         ", and --max-memory allows " + format_bytes(*limit) +
         ": allow more, or cut the points into tiles that overlap";
}

unsigned thread_count(unsigned asked) noexcept {
  return asked != 0 ? asked : std::max(1u, std::thread::hardware_concurrency());
}

}  // namespace thalweg::cli
