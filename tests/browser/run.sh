#!/bin/sh
# Opens reports of the command in a headless Chromium and looks at them: figures, hover, keyboard, both themes, 3D.
#
#     apt-get install -y chromium nodejs npm
#     tests/browser/run.sh [BUILD]             a build folder with the command; default: build
#
# Everything it makes, screenshots too, is in BUILD/browser. With LARGE=1 terrains of a million triangles and more are
# opened, too, which takes a few minutes. CHROMIUM names another browser of that kind.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "${1:-build}" && pwd)
mkdir -p "$build/browser"
if [ ! -d "$build/browser/node_modules/playwright-core" ]; then
  npm install --prefix "$build/browser" --no-fund --no-audit --no-save playwright-core@1.65.1
fi
export CHROMIUM="${CHROMIUM:-$(command -v chromium)}" THALWEG="$build/thalweg" WORK="$build/browser"
exec node --test --test-reporter=spec "$here/report.test.mjs"
