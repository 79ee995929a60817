#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
out=${2:-$(mktemp -d)} # where results go
mkdir -p "$out"

# Two steel beads of 9.53 and 12.7 mm in diameter (Wang et al., Fig. 6). A small contact of one material depends on the radii
# by 1/R1 + 1/R2 alone: press a sphere of R = 2 R1 R2/(R1 + R2), fit, and give both radii to the law.
cat > "$out/case.toml" <<CARD
platen = 1
experiment = "local"
radius_m = 5.445e-3

[material]
platen = 1
name = "SS 302, properties assumed"
model = "von-mises"
[material.parameters]
E_Pa = 193e9
nu = 0.29
sigma_y_Pa = 1030e6

[path]
force_max_N = 500
unload_from_N = [250, 500]
[mesh]
edges = 10
CARD
"$platen" press "$out/case.toml" -o "$out/beads"
"$platen" fit "$out/beads/curve.csv" --law wang -o "$out/law.toml" --picture "$out/curve.svg"
"$platen" eval "$out/law.toml" -p radius_m=4.765e-3 -p radius2_m=6.35e-3 --overlap 0:20e-6:5
