/// CGAL's Delaunay triangulation as a benchmark, `cgal/SET/SITES`, in the executables that compare with it.
#pragma once

#include "benchmark/sets.hpp"

namespace bench {

/// Adds it; does nothing without -DTHALWEG_BENCH_PEERS=ON.
void add_cgal(const SetOfSites& set);

}  // namespace bench
