#!/bin/sh
# Installs the laws into an empty folder and builds ten-line programs in C++, C and Fortran against them, by find_package,
# by pkg-config, and with the source included in their project; all must print the force of equation (6):
# pi R^2 sigma_ref k delta_t exp(a (0.2 - delta_t)) = 15.026167 N, on loading (1).
# Usage: find_package.sh CMAKE BUILD_FOLDER
set -eu
cmake=$1
here=$(cd "$(dirname "$0")" && pwd)/law
source=$(cd "$here/../../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$cmake" --install "$2" --prefix "$work/prefix" --component law >"$work/log"

judge() { # HOW PROGRAM
  got=$("$2")
  echo "$got" | awk '{ d = $1 / 15.026167 - 1; exit !(d * d < 1e-10 && $2 == 1) }' || # to 1e-5: it comes from a table
    { echo "$1 printed '$got'"; exit 1; }
}
build() { # NAME OPTIONS...
  name=$1
  shift
  "$cmake" -G Ninja -S "$here" -B "$work/$name" "$@" >>"$work/log" 2>&1 &&
    "$cmake" --build "$work/$name" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  judge "$name" "$work/$name/ten_lines"
}
for language in CXX C; do
  build "$language" -DLANGUAGE=$language -DCMAKE_PREFIX_PATH="$work/prefix"
done

# Included: targets, and nothing else.
build included -DLANGUAGE=CXX -DPLATEN_SOURCE="$source"
grep -q 'includer: 14 0 , no tests' "$work/log" || { echo 'the source changed the project that includes it:'; grep includer: "$work/log"; exit 1; }
"$cmake" --install "$work/included" --prefix "$work/empty" >>"$work/log"
[ ! -e "$work/empty" ] || { echo 'included, it installs:'; find "$work/empty" -type f; exit 1; }

command -v pkg-config >/dev/null || exit 0
flags() { PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name platen.pc)") pkg-config "$@" platen; }
cc "$here/ten_lines.c" $(flags --cflags --libs) -o "$work/by_pkg_config"
judge pkg-config "$work/by_pkg_config"

fortran=$(command -v gfortran || command -v gfortran-12) || exit 0
"$fortran" -std=f2008 -J "$work" "$work/prefix/include/platen_law.f90" "$here/ten_lines.f90" $(flags --libs) -o "$work/fortran"
judge Fortran "$work/fortran"
