/// Counting sites in circles, as benchmarks: circle_count/... and voronoi_count/...
#pragma once

#include "benchmark/sets.hpp"

namespace bench {

void add_circle_count(const SetOfSites& set, unsigned order);
void add_voronoi_count(const SetOfSites& set, unsigned order);

}  // namespace bench
