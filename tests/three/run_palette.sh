#!/bin/sh
# run_palette.sh PACKAGE: runs palette.mjs with the npm package in that folder, or prints why it
# cannot (77).
set -eu
here=$(dirname "$0")
skip() {
  echo "SKIPPED: $1"
  exit 77
}
command -v node >/dev/null || skip "node is not installed"
[ -d "$here/node_modules/three" ] || skip "three.js is not installed; run 'npm ci' in tests/three"
[ -f "$1/engine.mjs" ] || skip "the npm package is not built; run scripts/build-wasm"
exec node "$here/palette.mjs" "$1"
