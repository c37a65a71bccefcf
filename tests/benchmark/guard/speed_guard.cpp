/// speed_guard JOB: one fixed job on one thread, for run.sh to count its instructions; without JOB, the names
/// of all. Only what `guarded_job` does is counted: the points are made before, and results are freed after.
///
/// Flip and hull are called below the public interface, from Delaunay triangulation to the last change:
/// minimize_pits explains every pit that is left, which at this size takes several times as long. `best` is
/// all of minimize_pits.
#include <array>
#include <cstdio>
#include <cstring>
#include <optional>
#include <vector>

#include "benchmark/sets.hpp"
#include "support/surface.hpp"
#include "terrain/exits.hpp"
#include "terrain/flip.hpp"
#include "terrain/hull.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/minimize.hpp"

namespace {

constexpr unsigned kOrder = 8;

struct Input {
  std::vector<thalweg::Point2> places;
  std::vector<thalweg::Point3> terrain;
};

/// What a job leaves, kept until it has been counted.
struct Output {
  std::optional<thalweg::Result<thalweg::Triangulation>> triangulation;
  std::optional<thalweg::detail::Outcome> outcome;
  std::optional<thalweg::Result<thalweg::Minimized>> minimized;
};

void delaunay(const Input& input, Output& output) {
  output.triangulation.emplace(thalweg::delaunay(input.places, {.threads = 1}));
}

void hull(const Input& input, Output& output) {
  const auto surface = support::surface_of(input.terrain);
  const auto exits = thalweg::detail::find_exits(surface, kOrder, 1, nullptr);
  output.outcome.emplace(thalweg::detail::insert_hulls(surface, exits, kOrder, {}));
}

void flip(const Input& input, Output& output) {
  output.outcome.emplace(thalweg::detail::flip_pits(support::surface_of(input.terrain), kOrder, {}));
}

void best(const Input& input, Output& output) {
  thalweg::MinimizeOptions options;
  options.order = kOrder;
  options.threads = 1;
  output.minimized.emplace(thalweg::minimize_pits(input.terrain, options));
}

struct Job {
  const char* name;
  const char* set;
  std::size_t sites;
  void (*run)(const Input&, Output&);
};

/// Sets that no function of libm has a part in, since those differ in the last bit.
constexpr std::array<Job, 5> kJobs = {{{"delaunay_uniform", "uniform", 20000, delaunay},
                                       {"delaunay_grid", "grid", 150 * 150, delaunay},
                                       {"hull", "uniform", 20000, hull},
                                       {"flip", "uniform", 20000, flip},
                                       {"best", "uniform", 20000, best}}};

}  // namespace

/// Known by this name to the tool that counts.
extern "C" [[gnu::noinline]] void guarded_job(const Job& job, const Input& input, Output& output) {
  job.run(input, output);
}

int main(int argc, char** argv) {
  if (argc != 2) {
    for (const Job& job : kJobs) std::puts(job.name);
    return argc == 1 ? 0 : 2;
  }
  for (const Job& job : kJobs) {
    if (std::strcmp(argv[1], job.name) != 0) continue;
    const bench::SetOfSites set{job.set, job.sites};
    const Input input{bench::make_places(set), bench::make_terrain(set)};
    Output output;
    guarded_job(job, input, output);
    const bool failed =
        (output.triangulation && !*output.triangulation) || (output.minimized && !*output.minimized);
    return failed ? 1 : 0;
  }
  return 2;
}
