#!/usr/bin/env bash
# tests/benchmark/guard/run.sh BUILD_DIR [--update]
#
# Counts the instructions of the fixed jobs of speed_guard with callgrind, and compares them with expected.txt. Fails
# if a job takes over 3 % more, and also if it takes over 3 % less: then --update writes what was counted, so that what
# was gained is kept. First: cmake --build BUILD_DIR --target speed_guard
#
# Instructions, not seconds: the same on a busy machine and on another one. They depend on the compiler, so the figures
# are those of g++ 12 on Debian 12, x86-64, in an ordinary Release build; elsewhere nothing is compared. The variants
# of memcpy, memset and libm that the C library would choose by processor are switched off, since the processor
# that valgrind shows to a program follows that of the machine.
set -euo pipefail

tolerance=3 # percent

usage() {
  echo "usage: $0 BUILD_DIR [--update]" >&2
  exit 2
}
[[ $# -eq 1 || ($# -eq 2 && $2 == --update) ]] || usage
build=$1
update=${2:-}
expected=$(dirname "$0")/expected.txt
guard=$build/tests/benchmark/guard/speed_guard

skip() {
  echo "speed guard: skipped, $1; the stored figures are of g++ 12 on Debian 12, x86-64, Release"
  exit 0
}
fail() {
  echo "speed guard: $1" >&2
  exit 1
}

# cached NAME: a variable of the build folder.
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

check_build() {
  [[ -f $build/CMakeCache.txt ]] || fail "$build is no build folder of CMake"
  local macros type
  macros=$("$(cached CMAKE_CXX_COMPILER)" -dM -E -x c++ /dev/null)
  if grep -q __clang__ <<<"$macros" || ! grep -q '__GNUC__ 12$' <<<"$macros"; then skip "another compiler"; fi
  grep -q '__x86_64__ 1$' <<<"$macros" || skip "another architecture"
  [[ $(. /etc/os-release && echo "$ID $VERSION_ID") == "debian 12" ]] || skip "another system"
  type=$(cached CMAKE_BUILD_TYPE)
  [[ -z $type || $type == Release ]] || skip "a build of type $type"
  [[ $(cached CMAKE_CXX_FLAGS_RELEASE) == "-O3 -DNDEBUG" && -z $(cached CMAKE_CXX_FLAGS) ]] ||
    skip "compiler flags of your own"
  [[ -z $(cached THALWEG_SANITIZE) && $(cached THALWEG_FUZZERS) != ON ]] || skip "an instrumented build"
  [[ -x $guard ]] || fail "no $guard: cmake --build $build --target speed_guard"
  command -v valgrind >/dev/null || fail "no valgrind: apt-get install -y valgrind"
}

# count JOB: the instructions of the job alone; the profile is left for callgrind_annotate.
count() {
  local plain=-AVX512F,-AVX512VL,-AVX2,-AVX,-FMA,-FMA4,-BMI1,-BMI2,-MOVBE,-ERMS,-FSRM,-SSSE3,-SSE4_1,-SSE4_2
  plain+=,-AVX_Fast_Unaligned_Load
  LD_BIND_NOW=1 GLIBC_TUNABLES=glibc.cpu.hwcaps=$plain:glibc.cpu.x86_non_temporal_threshold=0xf000000 \
    valgrind --tool=callgrind --toggle-collect=guarded_job --callgrind-out-file="$guard.$1.callgrind" "$guard" "$1" \
    2>"$guard.$1.log" || fail "$1 does not run: $(tail -n 3 "$guard.$1.log")"
  sed -n 's/^.*Collected : \([0-9]*\)$/\1/p' "$guard.$1.log"
}

check_build
jobs=$("$guard")
results=
for job in $jobs; do
  counted=$(count "$job")
  results+="$job $counted"$'\n'
done

if [[ $update ]]; then
  {
    echo "# Instructions of each job, written by run.sh --update: g++ 12, Debian 12, x86-64, Release."
    printf '%s' "$results"
  } >"$expected"
  cat "$expected"
  exit 0
fi

awk -v tolerance="$tolerance" -v stored="$expected" '
  BEGIN { printf "%-20s %15s %15s %9s\n", "job", "expected", "counted", "change" }
  /^#/ { next }
  FILENAME == stored { expected[$1] = $2; next }
  !($1 in expected) { printf "%-20s %15s %15d %9s  new: --update\n", $1, "-", $2, ""; bad = 1; next }
  {
    change = 100 * ($2 / expected[$1] - 1)
    verdict = change > tolerance ? "SLOWER" : change < -tolerance ? "faster: --update" : ""
    if (verdict != "") bad = 1
    printf "%-20s %15d %15d %+8.2f%%  %s\n", $1, expected[$1], $2, change, verdict
    delete expected[$1]
  }
  END {
    for (job in expected) { printf "%-20s %15d %15s %9s  gone: --update\n", job, expected[job], "-", ""; bad = 1 }
    exit bad
  }
' "$expected" - < <(printf '%s' "$results") ||
  fail "beyond $tolerance %: find the cause with callgrind_annotate $guard.JOB.callgrind, or accept with --update"
