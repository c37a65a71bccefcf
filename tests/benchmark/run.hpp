/// What all benchmark executables share: names, registration and a main that prints ratios.
///
/// Names are JOB/SET/SITES[/k:K][/threads:T], one thread if none is given: delaunay/uniform/1000000,
/// best/jacksboro_fault.asc/all/k:8/threads:2. Compare CPU time of one thread, and real time of more.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "benchmark/sets.hpp"

namespace bench {

/// What a job is asked beside its set; nothing is one thread, and a job that knows no order.
struct Choices {
  std::optional<unsigned> order = {};
  unsigned threads = 1;
};

inline std::string name_of(const std::string& job, const SetOfSites& set, const Choices& choices = {}) {
  std::string name = job + "/" + set.label();
  if (choices.order) name += "/k:" + std::to_string(*choices.order);
  if (choices.threads != 1) name += "/threads:" + std::to_string(choices.threads);
  return name;
}

/// Adds a benchmark that calls function(state). What it throws, of a file that cannot be read for example, is
/// its error and not the end of the run. Times are in milliseconds unless it is told otherwise.
template <class Function>
benchmark::internal::Benchmark* add(const std::string& name, Function function) {
  const auto guarded = [function = std::move(function)](benchmark::State& state) {
    try {
      function(state);
    } catch (const std::exception& error) {
      state.SkipWithError(error.what());
    }
  };
  return benchmark::RegisterBenchmark(name.c_str(), guarded)->Unit(benchmark::kMillisecond);
}

/// Milliseconds that the system has spent on all threads of this process so far.
double system_milliseconds();

/// Calls job() as often as the benchmark asks. Counter: system_ms, the part of its CPU time in which the
/// system worked for it, which is the clearing of memory that is touched for the first time.
template <class Job>
void repeat(benchmark::State& state, const Job& job) {
  const double before = system_milliseconds();
  for (auto _ : state) job();
  state.counters["system_ms"] =
      (system_milliseconds() - before) /
      static_cast<double>(std::max<benchmark::IterationCount>(1, state.iterations()));
}

/// Runs what was added and the command line asks for. Where CGAL was run on a set too, prints for every other
/// job how its time compares with CGAL's Delaunay triangulation. Returns what main should.
int run(int argc, char** argv);

}  // namespace bench
