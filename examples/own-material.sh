#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$(mktemp -d)} # where results go

# Material card to law.
"$platen" derive "$here/soft-granules.toml" -o "$out/granules" --elements 400

# Two of these particles, radius 0.5 mm, pressed together by 0.1 mm and pulled apart.
printf 'overlap_m\n2e-5\n5e-5\n1e-4\n9.8e-5\n9e-5\n' >"$out/path.csv"
"$platen" eval "$out/granules/law.toml" -p radius_m=0.5e-3 --path "$out/path.csv"
