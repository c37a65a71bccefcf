#!/usr/bin/env bash
# fuzz/run.sh [SECONDS]: builds every fuzz target with clang and sanitizers, and lets each search for SECONDS
# (60), beginning with the corpora. Prints the executions of each; ends with 1 at the first finding, which is
# left in build-fuzz/findings. What it needs it installs (Debian, as root).
set -euo pipefail
seconds=${1:-60}
root=$(cd "$(dirname "$0")/.." && pwd)
build=${THALWEG_FUZZ_BUILD:-$root/build-fuzz}

packages=(clang cmake ninja-build libclang-rt-14-dev libgmp-dev)
if ! dpkg -s "${packages[@]}" >/dev/null 2>&1; then
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends "${packages[@]}" >/dev/null
fi

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_CXX_FLAGS_RELEASE=-O1 \
  -DTHALWEG_FUZZERS=ON -DTHALWEG_SANITIZE=address,undefined -DTHALWEG_BUILD_TESTS=OFF -DTHALWEG_BUILD_CLI=OFF \
  >/dev/null
cmake --build "$build" --target fuzzers

mkdir -p "$build/findings"
for target in "$build"/fuzz/*_fuzz; do
  subject=$(basename "$target" _fuzz)
  found=$build/corpus/$subject
  mkdir -p "$found"
  seeds=("$root/tests/corpus")
  if [[ -d $root/fuzz/corpus/$subject ]]; then seeds+=("$root/fuzz/corpus/$subject"); fi
  if ! "$target" -max_total_time="$seconds" -max_len=1024 -timeout=60 -print_final_stats=1 -verbosity=0 \
    -artifact_prefix="$build/findings/$subject-" "$found" "${seeds[@]}" >"$build/$subject.log" 2>&1; then
    tail -n 40 "$build/$subject.log"
    exit 1
  fi
  awk -v subject="$subject" '/number_of_executed_units/ { printf "%-12s %12d executions\n", subject, $2 }' \
    "$build/$subject.log"
done
