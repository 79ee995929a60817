#!/bin/sh
# A law of one's own, outside the tree: the C interface built with PLATEN_OWN_LAWS runs it like the others, force and
# unloading, and lists its parameters. The program and the plug-in take it by the CMake option of the same name.
# Usage: own_law.sh C++_COMPILER SOURCE_FOLDER
set -eu
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/main.c" <<'C'
#include <platen_law.h>
#include <stdio.h>
int main(void) {
  char why[300] = "";
  double state[2] = {0, 0};
  platen_law* law = platen_law_new("square-spring", "", "radius_m=1e-3 k_Pa=1e8", why, sizeof why);
  if (!law) return puts(why), 1;
  double up = platen_law_evaluate(law, state, 1e-4).force_N;   /* k gamma^2/R = 1000 N */
  double down = platen_law_evaluate(law, state, 8e-5).force_N; /* (1 - 3 * 0.2)^2 of it */
  printf("%.5f %.5f\n", up, down);
  platen_law_free(law);
  law = platen_law_new("square-spring", "", "radius_m=1e-3", why, sizeof why);
  return puts(why), law != NULL;
}
C
"$1" -std=c++20 -O1 -I"$2/include" "-DPLATEN_OWN_LAWS=\"$here/law/own_law.hpp\"" -c "$2/src/capi/platen_law.cpp" -o "$work/law.o"
"$1" -x c -I"$2/include" -c "$work/main.c" -o "$work/main.o"
"$1" "$work/main.o" "$work/law.o" -o "$work/main"
"$work/main" >"$work/said"
awk 'NR == 1 { u = $1 / 1000 - 1; d = $2 / 160 - 1; exit !(u * u < 1e-8 && d * d < 1e-6) }' "$work/said" && grep -q 'k_Pa is missing' "$work/said" ||
  { cat "$work/said"; exit 1; }
