#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
here=$(cd "$(dirname "$0")" && pwd)
out=${2:-$(mktemp -d)} # where results go

"$platen" press "$here/unloading.toml" -o "$out/unloading"

# What each branch gave back: work at its start less work at its end, over the work spent to get there.
awk -F, '/^#/ { next } !columns++ { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  $at["branch"] == "unloading" { id = $at["branch_id"]; if (!(id in first)) { first[id] = $at["work_J"]; from[id] = $at["delta_bar"] }
                                 last[id] = $at["work_J"] }
  END { for (id = 1; id in first; ++id) printf "from delta_bar = %s: %.1f %% of the work comes back\n", from[id], 100 * (first[id] - last[id]) / first[id] }
' "$out/unloading/curve.csv"
