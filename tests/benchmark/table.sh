#!/usr/bin/env bash
# tests/benchmark/table.sh BUILD_DIR [TABLE ...]
#
# Runs what the tables need, then prints them as Markdown; the same figures as JSON, and the plot of table d, are left
# in BUILD_DIR/tables. Without TABLE all of
#
#   a  Delaunay triangulation of every set, and CGAL's
#   b  flip, hull and best at order 8, as multiples of CGAL's Delaunay triangulation
#   c  growth by a factor of ten, and memory
#   d  time over the order
#   e  reading and writing
#   f  predicates
#
# SITES (1000000) and REPETITIONS (5) in the environment make it shorter; with PRINT_ONLY=1 nothing is run, and the
# figures of the last time are printed. THALWEG_DATA adds real terrain to table a, see sets.hpp. Needs the benchmarks,
# with CGAL for whatever is compared:
#
#   cmake -S . -B BUILD_DIR -DTHALWEG_BENCHMARKS=ON -DTHALWEG_BENCH_PEERS=ON
#   cmake --build BUILD_DIR -j"$(nproc)"
set -euo pipefail

usage() {
  echo "usage: $0 BUILD_DIR [a] [b] [c] [d] [e] [f]" >&2
  exit 2
}
[[ $# -ge 1 ]] || usage
build=$1
shift
for table in "$@"; do [[ $table == [a-f] ]] || usage; done
tables=("$@")
[[ $# -gt 0 ]] || tables=(a b c d e f)

here=$(dirname "$0")
programs=$build/tests/benchmark
results=$build/tables
sites=${SITES:-1000000}
repetitions=${REPETITIONS:-5}
many=${sites}0
few=$((sites / 10))
mkdir -p "$results"

# measure NAME PROGRAM FILTER: repetitions in random order, so that all jobs meet the same weather.
measure() {
  echo "$1: benchmark_$2 $3" >&2
  "$programs/benchmark_$2" --benchmark_filter="$3" --benchmark_repetitions="$repetitions" \
    --benchmark_enable_random_interleaving=true --benchmark_out="$results/$1.json" --benchmark_out_format=json \
    >"$results/$1.log" 2>&1 || {
    tail -n 5 "$results/$1.log" >&2
    exit 1
  }
}

# first_call N METHOD: a line "N METHOD BYTES MILLISECONDS", peak bytes a site and time of one call in a process of its own.
first_call() {
  local cost
  cost=$("$programs/benchmark_process" "$1" uniform "$2" 1) || return 0
  echo "$1 $2 $cost"
}

run_a() { measure a delaunay "^(delaunay|two_at_once|cgal)/([a-z_]+/$sites|[^/]+/all)(/threads:2)?$"; }
run_b() { measure b terrain "^((flip|hull|best)/uniform/$sites/k:8(/threads:2)?|cgal/uniform/$sites)$"; }
run_c() {
  measure c_delaunay delaunay "^(delaunay|cgal)/uniform/($sites|$many)(/threads:2)?$"
  measure c_hull terrain "^hull/uniform/($sites|$many)/k:8(/threads:2)?$"
  echo "c_process: benchmark_process" >&2
  for ((round = 0; round < repetitions; ++round)); do
    for method in delaunay hull cgal; do
      for n in "$sites" "$many"; do first_call "$n" "$method"; done
    done
  done >"$results/c_process.txt"
}
run_d() { measure d terrain "^(flip|hull|best)/uniform/($few|$sites)/k:[0-9]+$"; }
run_e() { measure e files "^(read|write)_(xyz|npy|tlw|ply)/(uniform|lidar)/$sites(/threads:2)?$"; }
run_f() { measure f predicates .; }

if [[ -z ${PRINT_ONLY:-} ]]; then
  for table in "${tables[@]}"; do "run_$table"; done
fi
PYTHONDONTWRITEBYTECODE=1 python3 "$here/tables.py" "$results" "$sites" "${tables[@]}"
