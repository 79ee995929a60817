#!/bin/bash
set -eu
here=$(cd "$(dirname "$0")" && pwd)
platen=$(realpath "${1:-build/release/bin/platen}") # the program; the plug-in lies beside it (./run lammps)
out=${2:-$(mktemp -d)} # where results go
particles=${3:-2000}
. "$here/common.sh"

# Microcrystalline cellulose in a die, to 90 % packing and back: pressure over density, and slices of the bed.
"$platen" export lammps "$here/mcc-ph-200.toml" --radius 90e-6 --density 636 >lines.lmp
lammps die-compaction.lmp -var card "$here/mcc-ph-200.toml" -var dt "$(awk '$1 == "timestep" { print $2 }' lines.lmp)" -var particles "$particles"
picture compaction "set key left top; set xlabel 'packing'; set ylabel 'pressure [MPa]'; set xtics nomirror
set x2label 'true relative density (solid over space)'; set x2tics 0.04; set xrange [0.5:0.95]; set x2range [0.2:0.38]; set yrange [0:]
plot 'compaction.txt' using 1:(\$4/1e6) with lines lw 2 title 'upper punch', '' using 1:(\$5/1e6) with lines lw 2 title 'lower punch'"

slice() { # DUMP: x, z [mm] and radius of the circles that the plane y = 0 cuts
  awk '/^ITEM/ { rows = /ITEM: ATOMS/; frames += rows; next } frames > 1 { exit }
    rows && $4^2 < $6^2 { print $3 * 1e3, $5 * 1e3, sqrt($6^2 - $4^2) * 1e3 }' "$1"
}
for state in bed pressed released; do slice $state.dump >$state.txt; done
picture slices "set multiplot layout 1,3; set size ratio -1; unset key; set xlabel 'x [mm]'; set ylabel 'z [mm]'; set yrange [0:]
set style fill transparent solid 0.35 border lc rgb '#1f4e79'; set offsets 0.1, 0.1, 0.1, 0
stats 'bed.txt' using 2 nooutput; set yrange [0:STATS_max]
set title 'start'; plot 'bed.txt' with circles lc rgb '#6fa8dc'
set title 'pressed'; plot 'pressed.txt' with circles lc rgb '#6fa8dc'
set title 'released'; plot 'released.txt' with circles lc rgb '#6fa8dc'" 1000,450
awk '!/^#/ { if ($4 > p) { p = $4; q = $1 } last = $1 }
  END { printf "%d particles: %.1f MPa on the upper punch at packing %.3f; it leaves the compact at %.3f\n", '"$particles"', p / 1e6, q, last
        exit !(q > 0.88 && q < 0.92 && p > 1e6 && p < 1e8 && last < q) }' compaction.txt
