#!/usr/bin/env bash
# tests/platforms/compare.sh [--quick] COMMAND COMMAND ...
#
# Asks each of these builds of the command the same, and compares all they say and write with what the first one does.
# Ends with 1 if a byte differs; then the answers stay where the last line says.
set -euo pipefail

quick=
if [[ ${1:-} == --quick ]]; then
  quick=$1
  shift
fi
[[ $# -ge 2 ]] || {
  sed -n 's/^# \{0,1\}//; 2,5p' "$0" >&2
  exit 2
}
scratch=$(mktemp -d)
bad=
for i in $(seq $#); do
  # shellcheck disable=SC2086 # nothing, or one word
  "$(dirname "$0")/answers.sh" "${!i}" "$scratch/$i" $quick
  if diff "$scratch/1/answers" "$scratch/$i/answers" >"$scratch/$i/differences"; then
    echo "${!i}: $(wc -l <"$scratch/$i/answers") answers$([[ $i == 1 ]] || echo ", the same")"
    [[ $i == 1 ]] || rm -rf "${scratch:?}/$i"
  else
    bad=1
    echo "${!i}: $(grep -c '^>' "$scratch/$i/differences") of $(wc -l <"$scratch/$i/answers") answers differ:"
    sed -n 's/^> [0-9a-f]*/   /p' "$scratch/$i/differences" | head -n 20
  fi
done
if [[ $bad ]]; then
  echo "the answers are in $scratch"
  exit 1
fi
rm -rf "$scratch"
