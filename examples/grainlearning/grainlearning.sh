#!/bin/bash
# GrainLearning (PyPI) finds kappa and 1/m of twelve granules, two of them broken. GRAINLEARNING_PYTHON: a Python that has it.
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$(mktemp -d)} # where results go
python=${GRAINLEARNING_PYTHON:-python3}
"$python" -c 'import grainlearning' 2>/dev/null || { echo "$python has no grainlearning: nothing was run"; exit 77; }
mkdir -p "$out"
cd "$out"
"$python" -W ignore "$here/calibrate.py" "$platen" "$here/../../tests/data/measured/s07_batch_long.csv" | tee found.txt
# The truth is kappa = 4.2 MPa, 1/m = 0.55.
awk '/^kappa_Pa/ { k = $3 } /^inverse_m/ { n = $3 } END { exit !(k > 4e6 && k < 4.4e6 && n > 0.52 && n < 0.58) }' found.txt
