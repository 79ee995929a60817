#!/bin/bash
# Makes the explorer: a folder of static files. web/build.sh OUT_DIR [MORE...], more being files that the Makefile knows
set -eu -o pipefail
[ $# -gt 0 ] || { echo "usage: web/build.sh OUT_DIR [MORE...]" >&2; exit 2; }
mkdir -p "$1" && out=$(realpath "$1")
shift
cd "$(dirname "$0")/.."
for tool in python3 node make wasm-opt; do
  command -v $tool >/dev/null || { echo "web/build.sh: $tool is missing; Debian has it in: python3-venv nodejs make binaryen" >&2; exit 5; }
done
build=${PLATEN_WEB_BUILD:-build/web}
ziglang=$(sed -n 's/^ziglang==//p' constraints.txt) # its clang, libc++ and wasi-libc
venv=build/venv
if [ -z "${ZIG:-}" ]; then
  [ -x $venv/bin/python ] || python3 -m venv $venv
  $venv/bin/python -c "import importlib.metadata as m; assert m.version('ziglang') == '$ziglang'" 2>/dev/null ||
    $venv/bin/python -m pip install --quiet "ziglang==$ziglang"
  ZIG=$($venv/bin/python -c 'import os, ziglang; print(os.path.join(os.path.dirname(ziglang.__file__), "zig"))')
fi
version=$(sed -n 's/^project(platen VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
make --no-print-directory -s -j "${PLATEN_JOBS:-$(nproc)}" -f web/Makefile BUILD="$build" ZIG="$ZIG" VERSION="$version" \
  "$build/explorer.wasm" "${@/#/$build/}"
rm -rf "${out:?}"/*
cp web/page/* "$build/explorer.wasm" "$out"
node web/catalogue.mjs catalogue "$out"
# What the page keeps, under a name that changes with it; the zones once they were asked for.
files=$(cd "$out" && ls | grep -v -e service-worker.js -e zones.gz | sed 's/.*/"&"/' | paste -sd,)
key=$(cd "$out" && cat * | sha256sum | cut -c1-12)
sed -i "s|'VERSION'|'platen-explorer-$key'|; s|= FILES|= [\"./\",$files]|" "$out/service-worker.js"
