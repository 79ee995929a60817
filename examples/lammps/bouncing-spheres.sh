#!/bin/bash
set -eu
here=$(cd "$(dirname "$0")" && pwd)
platen=$(realpath "${1:-build/release/bin/platen}") # the program; the plug-in lies beside it (./run lammps)
out=${2:-$(mktemp -d)} # where results go
. "$here/common.sh"

# Restitution over velocity from plasticity alone. For the law of Thornton & Ning it has a closed form (Powder Technol. 99
# (1998) 154), the line. Microcrystalline cellulose as derived by Platen loses less.
cat > thornton-ning.toml <<CARD
platen = 1
law = "thornton-ning"
[parameters]
E_Pa = 10e9
nu = 0.3
p_y_Pa = 1e8
CARD
restitution() { # CARD DENSITY: speed and restitution of each sphere
  lammps bouncing-spheres.lmp -var card "$1" -var density "$2" >&2
  awk '/^ITEM/ { rows = /ITEM: ATOMS/; frame += rows; next } !rows { next }
    frame == 1 { v[$1] = -$2 } frame == 2 { print v[$1], $2 / v[$1] }' speeds.txt
}
restitution thornton-ning.toml 1500 > thornton-ning.txt
restitution "$here/mcc-ph-200.toml" 636 > mcc.txt
closed_form='V = 1.56 * sqrt(1e8^5 / ((10e9 / (1 - 0.3^2))^4 * 1500)) # yield velocity
r(v) = v > V ? V / v : 1.0
e(v) = sqrt(6 * sqrt(3) / 5) * sqrt(1 - r(v)**2 / 6) * (r(v) / (r(v) + 2 * sqrt(1.2 - r(v)**2 / 5)))**0.25'
picture bouncing-spheres "${closed_form//^/**}
set logscale x; set xlabel 'velocity of impact [m/s]'; set ylabel 'coefficient of restitution'; set yrange [0:1.05]
plot [0.01:10] e(x) lw 2 title 'Thornton and Ning, closed form', 'thornton-ning.txt' with points pt 6 title 'LAMMPS, law thornton-ning', \
  'mcc.txt' with points pt 7 ps 0.6 title 'LAMMPS, MCC PH-200'"
awk 'function e(v, r) { r = v > V ? V / v : 1; return sqrt(6 * sqrt(3) / 5 * (1 - r^2 / 6)) * (r / (r + 2 * sqrt(1.2 - r^2 / 5)))^0.25 }
  BEGIN { V = 1.56 * sqrt(1e8^5 / ((10e9 / (1 - 0.3^2))^4 * 1500)) }
  { d = $2 / e($1) - 1; if (d < 0) d = -d; if (d > most) most = d }
  END { printf "largest difference from the closed form: %.1e\n", most; exit !(NR == 25 && most < 0.01) }' thornton-ning.txt
