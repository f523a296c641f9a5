#!/bin/sh
# run.sh POSED_CORNERS FILE_OR_FOLDER...: compares Pelt with three.js, or prints why it cannot (77).
set -eu
here=$(dirname "$0")
if ! command -v node >/dev/null; then
  echo "SKIPPED: node is not installed"
  exit 77
fi
if [ ! -d "$here/node_modules/three" ]; then
  echo "SKIPPED: three.js is not installed; run 'npm ci' in tests/three"
  exit 77
fi
for model in "$@"; do
  if [ ! -e "$model" ]; then
    echo "SKIPPED: $model is not there"
    exit 77
  fi
done
exec node "$here/compare.mjs" "$@"
