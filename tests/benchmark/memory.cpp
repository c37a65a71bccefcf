/// benchmark_memory N KIND METHOD THREADS: prints the peak memory of this process in bytes a site, the input
/// included. KIND is a set of sets.hpp, with N = 0 for real terrain; METHOD is none (the input alone),
/// delaunay, cgal, flip, hull or best, the last three at order 8. One job a process, because a peak never
/// falls.
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "benchmark/sets.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/minimize.hpp"

#ifdef THALWEG_BENCH_PEERS
#include "benchmark/cgal_delaunay.hpp"
#endif

namespace {

using bench::SetOfSites;

constexpr std::pair<const char*, thalweg::Method> kMethods[] = {
    {"flip", thalweg::Method::flip}, {"hull", thalweg::Method::hull}, {"best", thalweg::Method::best}};

/// Number of sites.
std::size_t triangulate(const SetOfSites& set, unsigned threads) {
  const auto places = bench::make_places(set);
  const auto triangulation = thalweg::delaunay(places, {.threads = threads});
  if (!triangulation) throw std::runtime_error(triangulation.error().message);
  return places.size();
}

std::size_t minimize(const SetOfSites& set, thalweg::Method method, unsigned threads) {
  const auto terrain = bench::make_terrain(set);
  thalweg::MinimizeOptions options;
  options.method = method;
  options.threads = threads;
  const auto result = thalweg::minimize_pits(terrain, options);
  if (!result) throw std::runtime_error(result.error().message);
  return terrain.size();
}

#ifdef THALWEG_BENCH_PEERS
std::size_t triangulate_with_cgal(const SetOfSites& set) {
  std::size_t count = 0;
  const peers::CgalPoints points = [&] {
    const auto places = bench::make_places(set);
    count = places.size();
    return peers::CgalPoints(places);
  }();
  if (points.face_count() == 0) throw std::runtime_error("no triangles");
  return count;
}
#endif

std::size_t run(const SetOfSites& set, const std::string& method, unsigned threads) {
  if (method == "none") return bench::make_places(set).size();
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
    std::fputs("usage: benchmark_memory N KIND METHOD THREADS\n", stderr);
    return 2;
  }
  try {
    const SetOfSites set{argv[2], std::strtoull(argv[1], nullptr, 10)};
    const std::size_t sites = run(set, argv[3], static_cast<unsigned>(std::strtoul(argv[4], nullptr, 10)));
    rusage usage{};
    if (getrusage(RUSAGE_SELF, &usage) != 0) throw std::runtime_error("no getrusage");
    std::printf("%.1f\n", static_cast<double>(usage.ru_maxrss) * 1024 / static_cast<double>(sites));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "benchmark_memory: %s\n", error.what());
    return 1;
  }
  return 0;
}
