#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
out=${2:-$(mktemp -d)} # where results go
mkdir -p "$out"

# One plastic ball, three confinements. For results leave out [mesh] (5,000 elements, minutes instead of seconds), and [path]
# of die and hydrostatic: they then go to zero porosity.
card() {
  printf 'platen = 1\nexperiment = "%s"\nmaterial = "von-mises-100"\nradius_m = 5e-3\n[mesh]\nelements = 300\n[path]\n%s\n' \
    "$1" "$2" >"$out/$1.toml"
}
card die 'delta_bar_max = 0.1
unload_from = [0.1]
[output]
fields_at = [0.1]'
card hydrostatic 'delta_bar_max = 0.1'
# Along z to 0.05, then along x to 0.04 with z held, then both back; no planes along y.
card triaxial 'delta_bar = [0.05, 0.05, 0.03]
delta_bar_x = [0.0, 0.04, 0.02]'
for experiment in die hydrostatic triaxial; do
  "$platen" press "$out/$experiment.toml" -o "$out/$experiment"
done
