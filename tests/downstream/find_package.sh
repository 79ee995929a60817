#!/bin/sh
# Installs the laws into an empty folder and builds a ten-line C++ and a ten-line C program against them; both must
# print the force of equation (6): pi R^2 sigma_ref k delta_t exp(a (0.2 - delta_t)) = 15.026167 N, on loading (1).
# Usage: find_package.sh CMAKE BUILD_FOLDER
set -eu
here=$(dirname "$0")/law
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" --install "$2" --prefix "$work/prefix" --component law > "$work/log"
for language in CXX C; do
  "$1" -G Ninja -S "$here" -B "$work/$language" -DLANGUAGE=$language -DCMAKE_PREFIX_PATH="$work/prefix" >> "$work/log" 2>&1 &&
    "$1" --build "$work/$language" >> "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  got=$("$work/$language/ten_lines")
  echo "$got" | awk '{ d = $1 / 15.026167 - 1; exit !(d * d < 1e-10 && $2 == 1) }' || # to 1e-5: it comes from a table
    { echo "$language printed '$got'"; exit 1; }
done
