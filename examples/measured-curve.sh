#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$(mktemp -d)} # where results go

# A measured curve has two columns; here they are cut from a press, so that the example needs no data.
"$platen" derive mcc-ph-200 -o "$out/press" --elements 400 --unload_from none >/dev/null
awk -F, '/^#/ { next } !columns++ { for (i = 1; i <= NF; ++i) at[$i] = i; print "delta_m,force_N"; next }
  { print $at["delta_m"] "," $at["force_N"] }' "$out/press/curve.csv" >"$out/measured.csv"

"$platen" fit "$out/measured.csv" --law edmans-sinka --radius_m 1e-3 --sigma_ref_Pa 8.61e6 --picture "$out/fit.svg"
