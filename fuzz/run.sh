#!/usr/bin/env bash
# fuzz/run.sh [SECONDS [SUBJECT ...]]: builds the fuzz targets, all unless some are named, with clang and sanitizers,
# and lets each search for SECONDS (60), as many at a time as there are cores, beginning with the corpora and with what
# earlier runs have found. Prints the executions of each; after the first finding, which is left in
# build-fuzz/findings, no more are begun and it ends with an error. What it needs it installs (Debian, as root).
#
#   THALWEG_FUZZ_SANITIZE=  without sanitizers, with the library's and the compiler's assertions: several times as
#                           many executions; what they find worth keeping is replayed by the next run with sanitizers
#   THALWEG_FUZZ_BUILD      an earlier build to use as it is configured, instead of build-fuzz
#   THALWEG_FUZZ_JOBS       how many at a time
set -euo pipefail
seconds=${1:-60}
shift || true
root=$(cd "$(dirname "$0")/.." && pwd)
sanitize=${THALWEG_FUZZ_SANITIZE-address,undefined}
results=$root/build-fuzz
export seconds root results

install_tools() {
  local packages=(clang cmake ninja-build libclang-rt-14-dev libgmp-dev libcli11-dev nlohmann-json3-dev)
  dpkg -s "${packages[@]}" >/dev/null 2>&1 && return
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
}

configure() {
  local flags=-O1
  if [[ -z $sanitize ]]; then flags="-O2 -D_GLIBCXX_ASSERTIONS"; fi
  cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE="$flags" \
    -DTHALWEG_FUZZERS=ON -DTHALWEG_SANITIZE="$sanitize" -DTHALWEG_BUILD_TESTS=OFF >/dev/null
}

# search TARGET: lets one search. Ends with 255 at a finding, which tells xargs to begin no more.
search() {
  local target=$1 subject log length=64
  subject=$(basename "$target" _fuzz)
  log=$results/$subject.log
  case $subject in readers | cli) length=256 ;; esac  # bytes a file, not points
  local seeds=("$root/tests/corpus")
  if [[ -d $root/fuzz/corpus/$subject ]]; then seeds+=("$root/fuzz/corpus/$subject"); fi
  mkdir -p "$results/corpus/$subject"
  # -entropic=0: its choice of the next input costs more than these inputs do.
  if ! "$target" -max_total_time="$seconds" -max_len=$length -entropic=0 -timeout=60 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="$results/findings/$subject-" "$results/corpus/$subject" "${seeds[@]}" >"$log" 2>&1; then
    tail -n 60 "$log"
    exit 255
  fi
  awk -v subject="$subject" '/number_of_executed_units/ { printf "%-12s %12d executions\n", subject, $2 }' "$log"
}
export -f search

build=${THALWEG_FUZZ_BUILD:-}
if [[ -z $build ]]; then
  build=$results/${sanitize:-none}
  install_tools
  configure
fi
targets=("${@/%/_fuzz}")
cmake --build "$build" --target "${targets[@]:-fuzzers}"
if (($# == 0)); then targets=("$build"/fuzz/*_fuzz); else targets=("${targets[@]/#/$build/fuzz/}"); fi

# Stacks of allocations and filled memory cost half of the time; a finding run again alone has them.
export ASAN_OPTIONS=malloc_context_size=0:quarantine_size_mb=8:max_malloc_fill_size=0
mkdir -p "$results/findings"
printf '%s\n' "${targets[@]}" | xargs -P "${THALWEG_FUZZ_JOBS:-$(nproc)}" -I{} bash -c 'search {}'
