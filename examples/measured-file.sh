#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$(mktemp -d)} # where results go
mkdir -p "$out"

# A file as a testing machine writes it: Latin-1, semicolons, decimal commas; preload, hold, unloading.
raw=$here/../tests/data/measured/s01_zwick_de.csv
"$platen" import "$raw" -o "$out/curve.csv"
"$platen" calibrate "$raw" --law shahin --nu 0.3 -o "$out/law.toml" --picture "$out/fit.svg"
"$platen" eval "$out/law.toml" -p radius_m=0.5e-3 --against plane --overlap 0:1e-4:5
