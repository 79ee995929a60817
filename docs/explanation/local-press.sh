#!/bin/sh
# Draws local-press.svg with the program itself: the contact pressure of Wang et al. section 3.4 at 100 N.
# Usage: docs/explanation/local-press.sh PLATEN_PROGRAM
set -eu
platen=$1
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
pressed() { # NAME MATERIAL
  cat > "$work/case.toml" <<CARD
platen = 1
experiment = "local"
material = "$2"
radius_m = 0.1
[path]
force_max_N = 100
[output]
fields_at_N = [100]
CARD
  "$platen" press "$work/case.toml" -o "$work/$1" > /dev/null
  grep -v -e '^#' -e radius "$work/$1/profile-100.csv" | awk -F, '{ print $1 * 1e3, $2 / 1e6 }' > "$work/$1.txt"
}
pressed dp sandstone-wang-3-4
pressed mc sandstone-wang-3-4-mohr-coulomb
pressed vm sandstone-wang-3-4-von-mises
# Hertz: a^3 = 3 F R (1 - nu^2)/(4 E), p0 = 3 F/(2 pi a^2)
gnuplot -e "set terminal svg size 800,420 font 'Helvetica, Arial, sans-serif,13' background rgb 'white'; set output 'local-press.svg';
  a = (0.75 * 100 * 0.1 * (1 - 0.38**2) / 10e9)**(1.0 / 3); p0 = 1.5 * 100 / (pi * a**2); set samples 2000;
  set xlabel 'distance from the axis (mm)'; set ylabel 'contact pressure (MPa)'; set grid; set key right Left reverse samplen 2;
  set xrange [0:1.6]; set yrange [0:70];
  plot p0 / 1e6 * sqrt(1 - (x * 1e-3 / a)**2) with lines lw 1.2 dt 2 lc rgb '#22303c' title 'Hertz',
       '$work/dp.txt' with lines lw 2 lc rgb '#0072b2' title 'Drucker-Prager',
       '$work/mc.txt' with lines lw 2 lc rgb '#d55e00' title 'Mohr-Coulomb',
       '$work/vm.txt' with lines lw 2 lc rgb '#009e73' title 'von Mises'"
