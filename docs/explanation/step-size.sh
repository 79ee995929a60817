#!/bin/sh
# Draws the step-size study of step-size.md with the program itself, and prints its table.
# Usage: docs/explanation/step-size.sh PLATEN_PROGRAM
set -eu
platen=$1
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
stress() { # SCHEME STEPS CARD PATH...: the three principal stresses at the end
  scheme=$1 steps=$2 card=$3
  shift 3
  "$platen" point "$card" --path "$@" --steps "$steps" --moduli "$scheme" | tail -1 | cut -d, -f5-7
}
study() { # NAME CARD PATH...
  name=$1
  shift
  reference=$(stress implicit 10000 "$@")
  for steps in 5 10 20 40 80 160 320 640 1280; do
    echo "$steps,$reference,$(stress implicit $steps "$@"),$(stress after-step $steps "$@")"
  done | awk -F, '{ size = sqrt($2^2 + $3^2 + $4^2)
      print $1, sqrt(($5 - $2)^2 + ($6 - $3)^2 + ($7 - $4)^2) / size, sqrt(($8 - $2)^2 + ($9 - $3)^2 + ($10 - $4)^2) / size }' \
    > "$work/$name"
  awk -v name="$name" '$1 == 20 { i = $2; a = $3 } $1 == 160 { printf "| %s | %.2g | %.2g | %.0f | %.2f | %.2f |\n",
      name, i, a, a / i, log(i / $2) / log(8), log(a / $3) / log(8) }' "$work/$name"
}
echo '| path | implicit | after the step | ratio | order, implicit | order, after |'
echo '|---|---|---|---|---|---|'
study base base-case uniaxial-strain --strain -0.3
study mcc mcc-ph-200 uniaxial-strain --strain -0.3
study lactose lactose-dt uniaxial-strain --strain -0.3
study shear base-case shear --compaction 0.15 --strain 0.02
gnuplot -e "set terminal svg size 800,420 font 'Helvetica, Arial, sans-serif,13' background rgb 'white'; set output 'step-size.svg';
  set logscale xy; set format y '10^{%L}'; set xlabel 'steps'; set ylabel 'relative error of the stress'; set grid; set key outside right Left reverse samplen 2;
  set xrange [4:1700]; set xtics (5, 10, 20, 40, 80, 160, 320, 640, 1280);
  plot '$work/base' using 1:3 with linespoints lw 2 pt 6 lc rgb '#d55e00' title 'base case, after the step',
       '' using 1:2 with linespoints lw 2 pt 7 lc rgb '#0072b2' title 'base case, implicit',
       '$work/lactose' using 1:3 with linespoints lw 1.2 pt 4 lc rgb '#d55e00' title 'Lactose DT, after the step',
       '' using 1:2 with linespoints lw 1.2 pt 5 lc rgb '#0072b2' title 'Lactose DT, implicit',
       '$work/shear' using 1:3 with linespoints lw 1.2 dt 2 pt 8 lc rgb '#d55e00' title 'shear, after the step',
       '' using 1:2 with linespoints lw 1.2 dt 2 pt 9 lc rgb '#0072b2' title 'shear, implicit'"
