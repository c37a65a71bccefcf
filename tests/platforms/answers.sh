#!/usr/bin/env bash
# tests/platforms/answers.sh COMMAND FOLDER [--quick]
#
# Runs the thalweg COMMAND on the degenerate corpus and on terrains of its own making, every method, every format, in
# FOLDER, and lists the hash of everything it said and wrote, with the exit codes, in FOLDER/answers. What depends on
# the moment is taken out first: times and peak memory. --quick: a fifth of the runs.
set -euo pipefail

[[ $# -eq 2 || ($# -eq 3 && $3 == --quick) ]] || {
  sed -n 's/^# \{0,1\}//; 2,6p' "$0" >&2
  exit 2
}
command=$(realpath "$1")
here=$(cd "$(dirname "$0")/.." && pwd)
"$command" --version >/dev/null  # if it does not even start, nothing is worth comparing
mkdir -p "$2"
cd "$2"
methods="delaunay flip hull best exact"
[[ ${3:-} ]] && methods="flip best"
export command here methods quick=${3:-}

# say NAME WORD ...: one run of the command; its code and both streams are answers.
say() {
  local name=$1 code=0
  shift
  "$command" "$@" >"$name.out" 2>"$name.err" </dev/null || code=$?
  echo "$code" >"$name.code"
}

# build_all POINTS ORDER: with each method, into each format.
build_all() {
  local method outputs
  for method in $methods; do
    outputs=()
    for suffix in ply obj 2dm tlw npy; do outputs+=(-o "$method.$suffix"); done
    say "$method" build "$1" -k "$2" -m "$method" --threads 2 "${outputs[@]}" --pits "$method.geojson" \
      --json "$method.json"
  done
}

# terrain POINTS ORDER: everything that can be asked of points.
terrain() {
  build_all "$1" "$2"
  say page build "$1" -k "$2" -o page.ply --to ply-ascii --report page.html --sweep
  say cells voronoi "$1" -k 3 -o cells.svg -o cells.geojson --query "$1" -o nearest.csv
  [[ -z $quick ]] || return 0
  say sweep sweep "$1" -k 0..5 -o sweep.csv
  say edges edges "$1" -k 3 -o edges.csv
  say info info "$1" --json info.json
  for suffix in ply obj 2dm tlw; do say "check_$suffix" check "flip.$suffix" -k "$2" --points "$1"; done
  say report report hull.obj -o report.html -o report.svg --layers shading,cells,flow,edges,changes,pits
  say voronoi build "$1" -k "$2" -m flip --counter voronoi -o voronoi.ply
  for policy in highest mean first last; do say "$policy" build "$1" --duplicates "$policy" -o "$policy.ply"; done
}

# large POINTS: enough for the work to be split among threads.
large() {
  for method in delaunay flip hull best; do say "$method" build "$1" -m "$method" --threads 3 -o "$method.ply"; done
}

# job "NAME FUNCTION WORD ...": that function, in a folder of that name.
job() {
  local name function words
  read -r name function words <<<"$1"
  mkdir "$name"  # a name for each: no job may see what another one wrote
  cd "$name"
  # shellcheck disable=SC2086 # the words are separate
  $function $words
  find . -name '*.json' -exec sed -i '/"seconds": {/,/}/d; /"peak_memory_bytes"/d' {} +
  find . -name '*.err' -exec sed -i '/^  time /d' {} +
}
export -f say build_all terrain large job

generated() {
  mkdir generated
  cd generated
  local kind
  for kind in fractal ridge plateau grid lidar; do say $kind generate $kind -n 1500 --seed 3 -o $kind.xyz; done
  say ring generate ring -n 648 --seed 3 -o ring.xyz
  say theorem1 generate theorem1 -n 5 --seed 3 -o theorem1.xyz
  say corollary2 generate corollary2 -n 3 --seed 3 -o corollary2.xyz
  say sample sample "$here/data/jacksboro_fault.asc" -n 1500 --seed 3 -o sample.xyz
  [[ $quick ]] || say large generate fractal -n 200000 --seed 3 -o large.npy
  cd ..
}

jobs() {
  local file
  for file in "$here"/corpus/*.txt; do echo "corpus_$(basename "$file" .txt) terrain $file 3"; done
  for file in generated/*.xyz; do echo "$(basename "$file" .xyz) terrain ../$file 8"; done
  [[ $quick ]] || echo "large large ../generated/large.npy"
}

generated
jobs | xargs -d '\n' -P "$(nproc)" -I '{}' bash -euo pipefail -c 'job "{}"'
find . -type f ! -name answers -print0 | sort -z | xargs -0 sha256sum >answers
