#!/bin/bash
set -eu
here=$(cd "$(dirname "$0")" && pwd)
platen=$(realpath "${1:-build/release/bin/platen}") # the program; the plug-in lies beside it (./run lammps)
out=${2:-$(mktemp -d)} # where results go
layers=${3:-24}
. "$here/common.sh"

# The law of Wang et al. for the sandstone of their section 3.3, and the time step that Platen states for it.
cat > sandstone.toml <<CARD
platen = 1
law = "wang"
[parameters]
E_Pa = 10e9
nu = 0.3 # the rock has 0.38; the law was made for 0.1 to 0.3
phi_deg = 27.8
sigma_c_Pa = 6.72e6
CARD
"$platen" export lammps sandstone.toml --radius 5e-3 --density 2300 --delta-bar 4e-4 >lines.lmp
lammps sandstone-column.lmp -var card sandstone.toml -var dt "$(awk '$1 == "timestep" { print $2 }' lines.lmp)" -var layers "$layers"
picture weight "set key top center horizontal; set xlabel 'time [s]'; set ylabel 'part of the weight'; set yrange [0:1.5]
plot 'weight.txt' using 1:2 with lines lw 2 title 'ground', '' using 1:3 with lines lw 2 title 'wall, by friction', \
  '' using 1:(\$2+\$3) with lines lw 1 dt 2 title 'both'"
awk '/^ITEM/ { rows = /ITEM: ATOMS/; next } rows && $4^2 < $6^2 { print $3 * 1e3, $5 * 1e3, sqrt($6^2 - $4^2) * 1e3 }' settled.dump >settled.txt
picture settled "set size ratio -1; unset key; set xlabel 'x [mm]'; set ylabel 'z [mm]'; set style fill solid 0.4 border lc rgb '#7a5230'
plot 'settled.txt' with circles lc rgb '#c9a26b'" 500,700
awk '!/^#/ { t[++n] = $1; ground[n] = $2; tube[n] = $3; if ($4 > a) a = $4 }
  END { for (i = n; i > n - 100; --i) { g += ground[i] / 100; w += tube[i] / 100 }
        printf "the ground carries %.3f, the wall %.3f of the weight; largest a/R %.4f\n", g, w, a
        exit !(g + w > 0.98 && g + w < 1.02) }' weight.txt
