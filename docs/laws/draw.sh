#!/bin/sh
# Draws the curves of these pages with the library itself. Usage: docs/laws/draw.sh PLATEN_PROGRAM
set -eu
platen=$(realpath "$1")
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
draw() { # NAME END_OVERLAP PARAMETERS...: up to the end, down, and up again to a little more
  law=$1 name=$(basename "$1" .toml) end=$2
  [ "$name" != card ] || name=pressed
  shift 2
  awk -v e="$end" 'BEGIN { print "overlap_m"; n = 150
    for (i = 1; i <= n; ++i) print 0.9 * e * i / n
    for (i = n; i >= 0; --i) print 0.9 * e * i / n
    for (i = 1; i <= n; ++i) print e * i / n }' > "$work/path.csv"
  "$platen" eval "$law" "$@" --path "$work/path.csv" -o "$work/$name.csv" 2> "$work/warnings" || cat "$work/warnings"
  gnuplot -e "set terminal svg size 560,360 dynamic rounded font 'Helvetica, Arial, sans-serif,13' background rgb 'white';
    set output '$name.svg'; set datafile separator ','; unset key; set border 3 lc rgb '#1f2933';
    set tics nomirror out scale 0.5 tc rgb '#1f2933'; set grid lc rgb '#e3e7eb' lt 1 lw 1;
    set xlabel 'overlap of the centres (mm)'; set ylabel 'force (N)';
    plot '$work/$name.csv' every ::1 using (1e3*\$1):2 with lines lw 2.5 lc rgb '#0072b2' title '$name'" # a title, or the file's path would be written into the drawing
}
draw hertz 2e-5 -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3
draw similarity 6e-5 -p radius_m=1e-3 -p E_Pa=2e9 -p nu=0.3 -p kappa_Pa=1e7 -p inverse_m=0.3
draw edmans-sinka 1e-3 -p radius_m=1e-3 -p sigma_ref_Pa=8.61e6 -p E_Pa=4.417e8 -p nu=0.1472 -p k=4.2 -p delta_t=0.09 -p a=3.5
draw wang 1.2e-5 -p radius_m=0.1 -p E_Pa=1e10 -p nu=0.15 -p phi_deg=25 -p sigma_c_Pa=15e6
draw agarwal 1e-3 -p radius_m=1e-3 -p E_Pa=5e8 -p nu=0.3 -p sigma_y_Pa=1e6
draw shahin 1e-3 -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3 -p kappa_Pa=1e6 -p inverse_m=0.3
metal="-p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3"
draw thornton-ning 2e-5 $metal -p p_y_Pa=2e7
draw kogut-etsion 2e-5 $metal -p sigma_y_Pa=1e7
draw etsion-unloading 2e-5 $metal -p sigma_y_Pa=1e7
draw jackson-green 4e-5 $metal -p sigma_y_Pa=1e7
draw mdr 2e-4 $metal -p sigma_y_Pa=1e7
draw luding 1e-4 -p radius_m=1e-3 -p k_1_N_per_m=1e5 -p k_2_N_per_m=5e5 -p phi_f=0.1
draw eepa 1e-4 $metal -p lambda_p=0.6
"$platen" predict base-case -o "$work/card.toml" >/dev/null # a card of the law pressed
draw "$work/card.toml" 1e-3 -p radius_m=1e-3
