#!/usr/bin/env bash
# tests/platforms/run.sh [NAME ...]
#
# Builds the command by both compilers, at every level of optimisation, with every instruction of this machine, with
# fused multiply-add and for 32-bit x86 with SSE2, and compares all answers byte for byte: see compare.sh. Or only the
# builds of these names. The first is what the others are compared with. Builds stay in build-platforms, or in the
# folder THALWEG_PLATFORMS; needs g++, g++-multilib and clang, and qemu-user where the kernel runs no 32-bit programs.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
folder=${THALWEG_PLATFORMS:-$root/build-platforms}
launcher=$(command -v ccache || true)

declare -A flags=(
  [O0]="-O0" [O1]="-O1" [O2]="-O2" [O3]="-O3"
  [native]="-O3 -march=native" [fma]="-O2 -mfma" [32]="-O2 -m32 -msse2 -mfpmath=sse"
)
names=("$@")
if [[ $# == 0 ]]; then
  for compiler in g++ clang++; do
    for variant in O3 O2 O1 O0 native fma 32; do names+=("$compiler-$variant"); done
  done
fi

# runnable COMMAND: itself, or a script beside it that emulates it.
runnable() {
  if "$1" --version >/dev/null 2>&1; then
    echo "$1"
  else
    printf '#!/bin/sh\nexec qemu-i386 "%s" "$@"\n' "$1" >"$1-emulated"
    chmod +x "$1-emulated"
    echo "$1-emulated"
  fi
}

commands=()
for name in "${names[@]}"; do
  variant=${name##*-}
  [[ ${flags[$variant]:-} ]] || {
    echo "$name: no such build; one of g++ or clang++, a hyphen, and one of: ${!flags[*]}" >&2
    exit 2
  }
  echo "building $name"
  cmake -S "$root" -B "$folder/$name" -G Ninja -DCMAKE_CXX_COMPILER="${name%-*}" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" \
    -DCMAKE_CXX_FLAGS_RELEASE="${flags[$variant]} -DNDEBUG" -DCMAKE_BUILD_TYPE=Release -DTHALWEG_BUILD_TESTS=OFF >/dev/null
  cmake --build "$folder/$name" --target thalweg_cli >"$folder/$name/log" || {
    tail -n 20 "$folder/$name/log" >&2
    exit 1
  }
  commands+=("$(runnable "$folder/$name/thalweg")")
done
if [[ ${#commands[@]} -gt 1 ]]; then "$root/tests/platforms/compare.sh" "${commands[@]}"; fi
