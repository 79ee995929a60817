#!/bin/bash
set -eu
here=$(cd "$(dirname "$0")" && pwd)
platen=$(realpath "${1:-build/release/bin/platen}") # the program; the plug-in lies beside it (./run lammps)
out=${2:-$(mktemp -d)} # where results go
. "$here/common.sh"

# Load, unload, reload: what LAMMPS computes on the curve that `platen eval` gives.
lammps two-spheres.lmp -var card "$here/mcc-ph-200.toml"
{ echo overlap_m; awk '/^[^#]/ && $1 > 0 { print $1 }' contact.txt; } > path.csv
"$platen" eval "$here/mcc-ph-200.toml" -p radius_m=1e-3 --path path.csv | tail -n +2 | tr , ' ' > eval.txt
picture two-spheres 'set xlabel "overlap γ [mm]"; set ylabel "force F [N]"; set key left top; set xrange [0:]
  plot "eval.txt" using ($1*1e3):2 with lines lw 2 title "platen eval", "contact.txt" every 6 using ($1*1e3):2 with points pt 6 ps 0.8 title "LAMMPS, pair\\_style platen"'
paste <(awk '/^[^#]/ && $1 > 0 { print $2 }' contact.txt) <(cut -d' ' -f2 eval.txt) |
  awk '{ d = $1 - $2; if (d < 0) d = -d; if (d > most) most = d; if ($2 > top) top = $2 }
    END { printf "largest difference of force: %.1e of %.4g N\n", most / top, top; exit !(NR > 300 && most < 1e-5 * top) }'
