/// The heuristics from points in memory to a reported terrain, merging of duplicates and Delaunay
/// triangulation included; and all useful pairs of a Delaunay triangulation that is there.
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "benchmark/cgal_benchmark.hpp"
#include "benchmark/run.hpp"
#include "thalweg/circle_count.hpp"
#include "thalweg/delaunay.hpp"
#include "thalweg/minimize.hpp"
#include "thalweg/useful_order.hpp"

namespace {

using bench::SetOfSites;
using thalweg::Method;

constexpr std::pair<Method, const char*> kMethods[] = {
    {Method::flip, "flip"}, {Method::hull, "hull"}, {Method::best, "best"}};

/// Counters: pits_before and pits, a sanity check of what was timed, and those of bench::repeat.
void minimize(benchmark::State& state, const SetOfSites& set, const thalweg::MinimizeOptions& options) {
  const auto points = bench::terrain(set);
  thalweg::PitCount before, after;
  bench::repeat(state, [&] {
    const auto result = thalweg::minimize_pits(points, options);
    if (!result) throw std::runtime_error(result.error().message);
    before = result->delaunay_pits;
    after = result->pits;
  });
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
  state.counters["pits_before"] = before.total;
  state.counters["pits"] = after.total;
}

void add_method(const SetOfSites& set, Method method, const char* name, unsigned order, unsigned threads) {
  thalweg::MinimizeOptions options;
  options.order = order;
  options.method = method;
  options.threads = threads;
  bench::add(bench::name_of(name, set, {order, threads}),
             [=](benchmark::State& state) { minimize(state, set, options); });
}

/// Counter: pairs.
void add_useful_pairs(const SetOfSites& set, unsigned order, unsigned threads) {
  bench::add(bench::name_of("useful_pairs", set, {order, threads}), [=](benchmark::State& state) {
    const auto points = bench::places(set);
    const auto mesh = thalweg::delaunay(points);
    if (!mesh) return state.SkipWithError(mesh.error().message.c_str());
    const thalweg::DelaunayGraph graph(points, *mesh);
    std::size_t pairs = 0;
    for (auto _ : state) pairs = thalweg::useful_pairs(graph, order, threads).size();
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
    state.counters["pairs"] = static_cast<double>(pairs);
  });
}

/// The order of the README for every set, and all of 1 .. 32 where sites are uniform.
std::vector<unsigned> orders_for(const SetOfSites& set) {
  if (set.name == "uniform") return {1, 2, 4, 8, 16, 32};
  return {8};
}

}  // namespace

int main(int argc, char** argv) {
  for (const SetOfSites& set : bench::all_sets(10'000'000)) {
    const bool huge = set.count > 1'000'000;
    for (const unsigned order : orders_for(set)) {
      for (const unsigned threads : {1u, 2u}) {
        for (const auto& [method, name] : kMethods) {
          if (!huge || (method == Method::hull && order == 8)) add_method(set, method, name, order, threads);
        }
        if (!huge) add_useful_pairs(set, order, threads);
      }
    }
    bench::add_cgal(set);
  }
  return bench::run(argc, argv);
}
