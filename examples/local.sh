#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$(mktemp -d)} # where results go

"$platen" press "$here/local.toml" -o "$out/local"
"$platen" fit "$out/local/curve.csv" --law wang -o "$out/local/law.toml" --picture "$out/local/curve.svg"
"$platen" eval "$out/local/law.toml" -p radius_m=0.1 --overlap 4e-6:8e-6:3
