#include "benchmark/run.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace bench {
namespace {

using Times = std::vector<double>;

double median(Times times) {
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

struct Parts {
  std::string job, set;
};

/// JOB and SET/SITES of a name.
Parts parts_of(const std::string& name) {
  const std::size_t job = name.find('/');
  if (job == std::string::npos) return {name, {}};
  const std::size_t count = name.find('/', job + 1);
  const std::size_t end = count == std::string::npos ? count : name.find('/', count + 1);
  return {name.substr(0, job), name.substr(job + 1, end == std::string::npos ? end : end - job - 1)};
}

/// Reports as the command line asks for, and to stderr how everything compares with CGAL when all is done.
class RatioReporter : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override { return usual_.ReportContext(context); }

  void ReportRuns(const std::vector<Run>& runs) override {
    usual_.ReportRuns(runs);
    for (const Run& run : runs) note(run);
  }

  void Finalize() override {
    usual_.Finalize();
    for (const auto& [name, times] : times_) {
      const Parts parts = parts_of(name);
      const auto cgal = times_.find("cgal/" + parts.set);
      if (parts.job == "cgal" || cgal == times_.end()) continue;
      const double ratio = median(times) / median(cgal->second);
      std::fprintf(stderr, "%-56s %8.3f of CGAL's Delaunay time, 1 / %.2f\n", name.c_str(), ratio, 1 / ratio);
    }
  }

 private:
  /// Repetitions, or their median where only aggregates are reported.
  void note(const Run& run) {
    if (run.error_occurred) return;
    if (run.run_type == Run::RT_Aggregate && run.aggregate_name != "median") return;
    const std::string& name = run.run_name.function_name;
    const bool parallel = name.find("/threads:") != std::string::npos;
    times_[name].push_back(parallel ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime());
  }

  benchmark::BenchmarkReporter& usual_ = *benchmark::CreateDefaultDisplayReporter();  // never deleted
  std::map<std::string, Times> times_;
};

}  // namespace

double system_milliseconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1e3 * static_cast<double>(usage.ru_stime.tv_sec) +
         1e-3 * static_cast<double>(usage.ru_stime.tv_usec);
}

int run(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  return 0;
}

}  // namespace bench
