#!/bin/sh
# Makes tests/browser/report.png, the first picture of the README, in few colours. Needs what run.sh needs, and pngquant.
#
#     tests/browser/picture.sh [BUILD]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${1:-build}" && pwd)
export CHROMIUM="${CHROMIUM:-$(command -v chromium)}" THALWEG="$build/thalweg" WORK="$build/browser"
node "$here/picture.mjs"
pngquant --force --speed 1 --strip --output "$here/report.png" 128 "$build/browser/picture.png"
