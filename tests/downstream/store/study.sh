# For the tests of the store: studies of quick runs, and their tables without times.
untimed() { sed 's/,[^,]*,[^,]*$//' "$1"; } # cpu_s and wall_s are the last columns
factor() { # NAME FIRST COUNT STEP
  echo "\"$1\" = { values = [$(seq -s ', ' "$2" "$4" "$(awk "BEGIN { print $2 + ($3 - 0.5) * $4 }")")] }"
}
study() { # COUNT COUNT COUNT: of the levels of three factors
  cat <<'T'
platen = 1
name = "quick"
[case]
platen = 1
experiment = "simple"
material = "base-case"
radius_m = 1e-3
[case.path]
delta_bar_max = 0.1
[design]
kind = "factorial"
[factors]
T
  factor material.E_bar 50 "$1" 1
  factor material.Gamma_bar 0.5 "$2" 0.01
  factor material.zeta 5 "$3" 0.01
}
