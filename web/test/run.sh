#!/bin/bash
# Builds the explorer and tests it in Chromium beside the program. web/test/run.sh PLATEN_BINARY
set -eu -o pipefail
[ $# = 1 ] || { echo "usage: web/test/run.sh PLATEN_BINARY" >&2; exit 2; }
PLATEN=$(realpath "$1")
export PLATEN
cd "$(dirname "$0")"
export PLATEN_CATALOGUE=${PLATEN_CATALOGUE:-$(realpath ../../catalogue)}
export PLATEN_PAGE=${PLATEN_PAGE:-$(realpath ../..)/build/web/page}
../build.sh "$PLATEN_PAGE" laws.wasm
export PLATEN_LAWS=$(realpath ../..)/build/web/laws.wasm
[ -d node_modules/playwright-core ] || npm ci --silent --no-audit --no-fund
node --test --test-reporter=spec link.test.mjs explorer.test.mjs laws.test.mjs
