/// benchmark_process N KIND METHOD THREADS: prints what one call costs in a process of its own: the peak
/// memory of the process in bytes a site, the input included, and the milliseconds of the call. KIND is a set
/// of sets.hpp, with N = 0 for real terrain; METHOD is none (the input alone), delaunay, cgal, flip, hull or
/// best, the last three at order 8. One call a process, because a peak never falls, and because memory that a
/// call before has given back may cost the next one nothing.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "benchmark/sets.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/minimize.hpp"

#ifdef THALWEG_BENCH_PEERS
#include "benchmark/cgal_delaunay.hpp"
#endif

namespace {

using bench::SetOfSites;

struct Cost {
  std::size_t sites;
  double milliseconds;
};

constexpr std::pair<const char*, thalweg::Method> kMethods[] = {
    {"flip", thalweg::Method::flip}, {"hull", thalweg::Method::hull}, {"best", thalweg::Method::best}};

/// Milliseconds of call(). It begins when a few seconds have passed, in which a hypervisor may take back what
/// another process has just freed: small and large sets are to meet memory in the same state.
template <class Call>
double timed(const Call& call) {
  using Clock = std::chrono::steady_clock;
  std::this_thread::sleep_for(std::chrono::seconds(5));
  const auto start = Clock::now();
  call();
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Cost triangulate(const SetOfSites& set, unsigned threads) {
  const auto places = bench::make_places(set);
  const double milliseconds = timed([&] {
    const auto triangulation = thalweg::delaunay(places, {.threads = threads});
    if (!triangulation) throw std::runtime_error(triangulation.error().message);
  });
  return {places.size(), milliseconds};
}

Cost minimize(const SetOfSites& set, thalweg::Method method, unsigned threads) {
  const auto terrain = bench::make_terrain(set);
  thalweg::MinimizeOptions options;
  options.method = method;
  options.threads = threads;
  const double milliseconds = timed([&] {
    const auto result = thalweg::minimize_pits(terrain, options);
    if (!result) throw std::runtime_error(result.error().message);
  });
  return {terrain.size(), milliseconds};
}

#ifdef THALWEG_BENCH_PEERS
Cost triangulate_with_cgal(const SetOfSites& set) {
  std::size_t count = 0;
  const peers::CgalPoints points = [&] {
    const auto places = bench::make_places(set);
    count = places.size();
    return peers::CgalPoints(places);
  }();
  const double milliseconds = timed([&] {
    if (points.face_count() == 0) throw std::runtime_error("no triangles");
  });
  return {count, milliseconds};
}
#endif

Cost run(const SetOfSites& set, const std::string& method, unsigned threads) {
  if (method == "none") return {bench::make_places(set).size(), 0};
  if (method == "delaunay") return triangulate(set, threads);
#ifdef THALWEG_BENCH_PEERS
  if (method == "cgal") return triangulate_with_cgal(set);
#endif
  for (const auto& [name, known] : kMethods) {
    if (method == name) return minimize(set, known, threads);
  }
  throw std::runtime_error("no method " + method);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    std::fputs("usage: benchmark_process N KIND METHOD THREADS\n", stderr);
    return 2;
  }
  try {
    const SetOfSites set{argv[2], std::strtoull(argv[1], nullptr, 10)};
    const Cost cost = run(set, argv[3], static_cast<unsigned>(std::strtoul(argv[4], nullptr, 10)));
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) throw std::runtime_error("no getrusage");
    const double bytes = static_cast<double>(usage.ru_maxrss) * 1024 / static_cast<double>(cost.sites);
    std::printf("%.1f %.1f\n", bytes, cost.milliseconds);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_process: %s\n", error.what());
    return 1;
  }
  return 0;
}
