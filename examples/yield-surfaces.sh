#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
out=${2:-$(mktemp -d)} # where results go

# One grain with three yield surfaces of equal uniaxial strength (Wang et al., section 3.4), 100 N. Pressure beside Hertz:
# pressure.svg of each; docs/explanation/grains-of-rock.md says why they differ.
mkdir -p "$out"
for material in sandstone-wang-3-4 sandstone-wang-3-4-mohr-coulomb sandstone-wang-3-4-von-mises; do
  cat > "$out/case.toml" <<CARD
platen = 1
experiment = "local"
material = "$material"
radius_m = 0.1
[path]
force_max_N = 100
[mesh]
edges = 10
[output]
fields_at_N = [100]
CARD
  "$platen" press "$out/case.toml" -o "$out/$material"
done
