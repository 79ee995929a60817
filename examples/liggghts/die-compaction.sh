#!/bin/bash
set -eu
here=$(cd "$(dirname "$0")" && pwd)
platen=$(realpath "${1:-build/release/bin/platen}") # the program; the plug-in lies beside it (./run liggghts)
out=${2:-$(mktemp -d)} # where results go
particles=${3:-2000}
plugin=$(dirname "$platen")/../liggghts/platen.so
command -v liggghts >/dev/null && [ -f "$plugin" ] || { echo "skipped: LIGGGHTS or the plug-in is missing (./run liggghts)"; exit 77; }
card=$here/../lammps/mcc-ph-200.toml
mkdir -p "$out"
cd "$out"

# Microcrystalline cellulose in a die, to 85 % packing and back.
dt=$("$platen" export lammps "$card" --radius 90e-6 --density 636 | awk '$1 == "timestep" { print $2 }')
settings=$(awk -v N="$particles" -v dt="$dt" 'BEGIN { R = 90e-6; die = 1.05 * N^(1/3) * R; v = 2
  solid = N * 4 / 3 * R^3 / die^2; start = solid / 0.28; end = solid / 0.85
  printf "-var die %.10g -var start %.10g -var press %d -var release %d", die, start, (start - end) / (v * dt), 0.1 * end / (v * dt) }')
w=$(awk -v N="$particles" 'BEGIN { print 1.2 * 1.05 * N^(1/3) * 90e-6 }') # wider than the die, inside the box
cat >punch.stl <<STL
solid punch
facet normal 0 0 -1
outer loop
vertex -$w -$w 0
vertex -$w $w 0
vertex $w $w 0
endloop
endfacet
facet normal 0 0 -1
outer loop
vertex -$w -$w 0
vertex $w $w 0
vertex $w -$w 0
endloop
endfacet
endsolid punch
STL
# shellcheck disable=SC2086
OMP_NUM_THREADS=1 LD_PRELOAD=$plugin liggghts -in "$here/die-compaction.liggghts" -log log.liggghts -var card "$card" -var dt "$dt" \
  -var particles "$particles" $settings >screen.txt 2>&1 || { tail -5 screen.txt >&2; exit 1; }
gnuplot <<TEXT
set terminal svg size 800,500 font 'sans,14' background rgb 'white'
set output 'compaction.svg'
set grid lc rgb '#dddddd'
set key left top; set xlabel 'packing'; set ylabel 'pressure of the punch [MPa]'; set xrange [0.5:0.9]; set yrange [0:]
plot 'compaction.txt' using 1:(\$2/1e6) with lines lw 2 title '$particles particles'
TEXT
awk '!/^#/ { if ($2 > p) { p = $2; q = $1 } last = $2 }
  END { printf "%d particles: %.1f MPa on the punch at packing %.3f\n", '"$particles"', p / 1e6, q
        exit !(q > 0.83 && q < 0.87 && p > 1e6 && p < 1e8 && last < 0.1 * p) }' compaction.txt
