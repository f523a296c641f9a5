#!/bin/sh
# run.sh PACKAGE: tests the npm package in that folder, or prints why it cannot (77; a failure in
# CI). The environment has the paths of the command and the files (CMakeLists.txt).
set -eu
here=$(dirname "$0")
skip() {
  echo "SKIPPED: $1"
  [ -z "${CI:-}" ] || exit 1
  exit 77
}
command -v node >/dev/null || skip "node is not installed"
[ -f "$1/engine.mjs" ] || skip "the npm package is not built; run scripts/build-wasm"
[ -d "$here/node_modules/meshoptimizer" ] ||
  skip "meshoptimizer is not installed; run 'npm ci' in tests/wasm"
PELT_WASM_PACKAGE=$(cd "$1" && pwd)
export PELT_WASM_PACKAGE
exec node --test "$here"/*.test.mjs
