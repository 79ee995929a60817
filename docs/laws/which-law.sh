#!/bin/sh
# Presses five materials, compares the laws with them and writes pictures, tables into which-law.md, and all of it as which-law.csv.
# Usage: docs/laws/which-law.sh PLATEN_PROGRAM [ELEMENTS]
set -eu
platen=$(realpath "$1")
elements=${2:-2500}
cd "$(dirname "$0")"
export OPENBLAS_NUM_THREADS=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat > "$work/stiff-metal.toml" <<'TOML'
platen = 1
name = "von Mises, E/sigma_y = 1000"
model = "von-mises"
[parameters]
sigma_y_Pa = 100e6
E_bar = 1000
nu = 0.3
TOML
echo "material,range of delta/R,rank,law,force %,radius %,stiffness %,lost work %,in range" > "$work/which-law.csv"
count=0
press() { # NAME MATERIAL DELTA_BAR_MAX UNLOAD_FROM
  count=$((count + 1))
  echo "which-law: pressing $2 ($count of 5)" >&2
  cat > "$work/$1-case.toml" <<TOML
platen = 1
experiment = "simple"
material = "$2"
radius_m = 1e-3
[path]
delta_bar_max = $3
unload_from = $4
[mesh]
elements = $elements
TOML
  "$platen" press "$work/$1-case.toml" -o "$work/$1" > "$work/log" 2>&1 || { cat "$work/log" >&2; exit 3; }
  cp "$work/$1/curve.csv" "$work/$1.csv"
}
# Springs that meet the press at one turning point: its force, and its part of the work that is lost.
springs() { # NAME DELTA_BAR POISSONS_RATIO
  awk -F, -v at="$2" -v nu="$3" '
    /^#/ { next }
    !d { for (i = 1; i <= NF; ++i) c[$i] = i; d = 1; next }
    { x = $c["delta_m"]; F = $c["force_N"]; id = $c["branch_id"] }
    $c["branch"] == "loading" { if ($c["delta_bar"] <= at * (1 + 1e-9)) { W += (x - x0) * (F + F0) / 2; x0 = x; F0 = F }; next }
    $c["branch"] == "unloading" && $c["delta_bar"] <= at * (1 + 1e-9) {
      if (!b) { if ($c["delta_bar"] < 0.9 * at) next; b = id; x1 = x0; F1 = F0 }
      if (id == b) { back += (x1 - x) * (F1 + F) / 2; x1 = x; F1 = F } }
    END {
      part = back / W; R = 1e-3; low = 0; high = 1
      for (i = 0; i < 60; ++i) { l = (low + high) / 2; g = l^(2 / 3)
        if (((1 - g * l) - 2.5 * l * (1 - g)) / (1 - l) > part) low = l; else high = l }
      k = F0 / x0
      printf "luding,k_1_N_per_m=%.5g,k_2_N_per_m=%.5g,phi_f=%.4g,label=luding (calibrated)\n", k, k / part, x0 * (1 - part) / (2 * R)
      printf "eepa,E_Pa=%.5g,lambda_p=%.4g,label=eepa (calibrated)\n", F0 / x0^1.5 * 0.75 / sqrt(R) * (1 - nu * nu), l
    }' "$work/$1.csv"
}
# The tables of `compare`, one for each range: all of it as rows of which-law.csv; for the page the force of each range side by
# side, and radius and lost work of the last, in the order of the force in the middle one. In parentheses: beyond the law's validity.
columns() { # NAME
  awk -v name="$1" -v csv="$work/which-law.csv" '
    / ≤ / { range[++ranges] = $NF; head = $0; gsub(/ /, "", head); next }
    !/^[|] [0-9]/ { next }
    { split($0, c, / *[|] */); law = c[3]
      printf "%s,%s,%s,%s,%s,%s,%s,%s,%s\n", name, head, c[2], law, c[4], c[5], c[6], c[7] == "–" ? "" : c[7], c[8] >> csv
      force[ranges, law] = c[8] == "yes" ? c[4] : "(" c[4] ")"
      radius[law] = c[5]; work[law] = c[7]
      if (ranges == 2) order[++laws] = law }
    END {
      printf "| law or curve | force %%: δ/R ≤ %s | to %s | to %s | radius %% | lost work %% |\n|---|---|---|---|---|---|\n", range[1], range[2], range[3]
      for (i = 1; i <= laws; ++i) {
        law = order[i]
        printf "| %s | %s | %s | %s | %s | %s |\n", law, force[1, law], force[2, law], force[3, law], radius[law], work[law] } }' "$work/$1.table"
}
put() { # NAME: between the marks of the page
  columns "$1" > "$work/$1.columns"
  awk -v name="$1" -v file="$work/$1.columns" '
    $0 == "<!-- " name " -->" { print; print ""; while ((getline line < file) > 0) print line; print ""; skip = 1; next }
    $0 == "<!-- end -->" { skip = 0 }
    !skip' which-law.md > "$work/page" && cp "$work/page" which-law.md
}
compare() { # NAME MATERIAL RANGES NU CALIBRATE_AT WORDS_OF_-p LAWS...
  name=$1 material=$2 ranges=$3 nu=$4 at=$5 common=$6
  shift 6
  cd "$work"
  "$platen" fit "$name.csv" --law edmans-sinka -o "$name-fit.toml" > log 2>&1 || { cat log >&2; exit 3; }
  springs "$name" "$at" "$nu" > calibrated
  set -- "$@" "$name-fit.toml,label=edmans-sinka (fitted here)" "$(sed -n 1p calibrated)" "$(sed -n 2p calibrated)"
  "$platen" predict "$material" -o "$name-predicted.toml" > log 2>&1 &&
    set -- "$@" "$name-predicted.toml,label=predicted"
  # shellcheck disable=SC2086
  "$platen" compare "$name.csv" "$@" --material "$material" $common --ranges "$ranges" -o "$name.svg" --table table 2> log ||
    { cat log >&2; exit 3; }
  sed '1,2d' table > "$name.table"
  cd - > /dev/null
  cp "$work/$name.svg" "which-law-$name.svg"
  put "$name"
}
tn() { printf 'thornton-ning,p_y_Pa=%s,label=thornton-ning (p_y = %s σ_y)' "$1" "$2"; }

press soft von-mises-100 0.5 '[0.05, 0.2, 0.5]'
compare soft von-mises-100 0.01,0.1 0.3 0.2 "" hertz agarwal jackson-green kogut-etsion etsion-unloading mdr \
  "$(tn 1.6e8 1.6)" "$(tn 2.8e8 2.8)" "similarity,kappa_Pa=1e8,inverse_m=0,label=similarity" "shahin,kappa_Pa=1e8,inverse_m=0,label=shahin"
press stiff "$work/stiff-metal.toml" 0.5 '[0.05, 0.2, 0.5]'
compare stiff "$work/stiff-metal.toml" 0.01,0.1 0.3 0.2 "" hertz agarwal jackson-green kogut-etsion etsion-unloading mdr \
  "$(tn 1.6e8 1.6)" "$(tn 2.8e8 2.8)" "similarity,kappa_Pa=1e8,inverse_m=0,label=similarity" "shahin,kappa_Pa=1e8,inverse_m=0,label=shahin"
press hardening lead-hollomon 0.5 '[0.05, 0.2, 0.5]'
compare hardening lead-hollomon 0.01,0.1 0.435 0.2 "-p sigma_y_Pa=11.18e6" hertz agarwal jackson-green kogut-etsion etsion-unloading mdr \
  "$(tn 17.9e6 1.6)" "$(tn 31.3e6 2.8)" similarity shahin
press porous base-case 0.5 '[0.05, 0.2, 0.5]'
compare porous base-case 0.01,0.1 0.3 0.2 "" hertz agarwal jackson-green kogut-etsion etsion-unloading mdr \
  "$(tn 2.4e8 1.6)" "$(tn 4.2e8 2.8)" "similarity,kappa_Pa=1.5e8,inverse_m=0,label=similarity" "shahin,kappa_Pa=1.5e8,inverse_m=0,label=shahin"
press sandstone wang-type-1 0.1 '[0.02, 0.05, 0.1]'
compare sandstone wang-type-1 0.001,0.01 0.15 0.05 "-p phi_deg=25" hertz wang agarwal jackson-green kogut-etsion etsion-unloading mdr \
  "$(tn 2.4e7 1.6)" "$(tn 4.2e7 2.8)" "similarity,kappa_Pa=15e6,inverse_m=0,label=similarity" "shahin,kappa_Pa=15e6,inverse_m=0,label=shahin"
cp "$work/which-law.csv" which-law.csv
echo "which-law: docs/laws/which-law.md, which-law.csv and the pictures" >&2
