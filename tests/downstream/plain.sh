#!/bin/bash
# plain.sh PROGRAM PLAIN: a build that factorises each tangent in double precision, without LAPACK and for any processor
# (-DPLATEN_PLAIN=ON), gives the same curves: forces within 5e-5 of the largest, as closely as Newton solves; and the same
# predictions: the six digits of the card but the last.
set -u
platen=$(realpath "$1") plain=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

# same NAME: presses NAME.toml both ways
same() {
  "$platen" press "$1.toml" -o "$1" >"$1.said" 2>&1 && "$plain" press "$1.toml" -o "$1-plain" >>"$1.said" 2>&1 ||
    { echo "FAILED: $1: $(tail -n 1 "$1.said")"; failures=$((failures + 1)); return; }
  awk -F, -v name="$1" '
    FNR == 1 { ++file; column = 0 }
    !column { for (i = 1; i <= NF; ++i) if ($i == "force_N") column = i; next }
    /^#/ { next }
    file == 1 { force[FNR] = $column; if ($column > most) most = $column; ++rows }
    file == 2 { ++others; off = force[FNR] - $column; if (off < 0) off = -off; if (off > worst) worst = off }
    END { printf "%s: %d points, forces within %.1e of the largest\n", name, rows, worst / most
          exit !(rows > 10 && rows == others && worst <= 5e-5 * most) }' "$1/curve.csv" "$1-plain/curve.csv" ||
    { echo "FAILED: $1"; failures=$((failures + 1)); }
}

case_of() { # EXPERIMENT MATERIAL TO ELEMENTS
  printf '%s\n' 'platen = 1' "experiment = \"$1\"" "material = \"$2\"" 'radius_m = 1e-3' '[path]' "delta_bar_max = $3" '[mesh]' \
    "elements = $4"
}
case_of simple von-mises-100 0.1 400 >metal.toml
case_of simple base-case 0.1 400 >granule.toml
case_of die von-mises-100 0.02 600 >die.toml
for name in metal granule die; do same $name; done

# predicted MATERIAL: the law card of both, number by number
predicted() {
  "$platen" predict "$1" --quick -o fast.toml >said 2>&1 && "$plain" predict "$1" --quick -o plain.toml >>said 2>&1 ||
    { echo "FAILED: predict $1: $(tail -n 1 said)"; failures=$((failures + 1)); return; }
  paste -d '\n' <(grep -oE '[-+]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?' fast.toml) <(grep -oE '[-+]?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?' plain.toml) |
    awk -v name="$1" 'NR % 2 { fast = $1; next }
      { ++numbers; off = fast - $1; if (off < 0) off = -off; size = fast < 0 ? -fast : fast; if (off > worst * size) worst = off / size }
      END { printf "predict %s: %d numbers, within %.1e\n", name, numbers, worst; exit !(numbers > 10 && worst <= 1.01e-5) }' ||
    { echo "FAILED: predict $1"; failures=$((failures + 1)); }
}
for name in base-case von-mises-100 wang-type-1; do predicted $name; done
exit $((failures > 0))
