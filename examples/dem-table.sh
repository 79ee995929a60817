#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$(mktemp -d)} # where results go

mkdir -p "$out"
# Any law by its name and parameters, or a law card of `platen derive`, becomes a table.
"$platen" export table agarwal -p radius_m=1e-3 -p E_Pa=500e6 -p nu=0.3 -p sigma_y_Pa=1e6 \
  --overlap 1e-6:5e-4:200 -o "$out/agarwal.csv"
head -12 "$out/agarwal.csv"
