#!/bin/bash
# A driver of its own, the cross-entropy method (Rubinstein 1999) in awk: it asks what the particle says of two hundred sets of
# parameters, and draws the next ones about the best twenty.
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
out=${2:-$(mktemp -d)}                              # where results go
mkdir -p "$out"
cd "$out"

# A granule that is known, as an instrument would have seen it: kappa = 5 MPa, 1/m = 0.5.
"$platen" eval shahin -p radius_m=0.5e-3 -p E_Pa=3e8 -p nu=0.3 -p kappa_Pa=5e6 -p inverse_m=0.5 --against plane \
  --overlap 0:1e-4:120 2>/dev/null | awk -F, 'BEGIN { srand(1); print "travel_mm,force_N" }
    NR > 1 { printf "%.6f,%.6f\n", 2e3 * $1 + 0.01, $2 + 0.02 * (rand() + rand() + rand() - 1.5) }' >granule.csv
calibrate=("$platen" calibrate granule.csv --law shahin --nu 0.3 --E "0.3 GPa" --radius "0.5 mm")

found='6e6 0.6 2e6 0.2' # means and standard deviations of kappa_Pa and inverse_m
for round in 1 2 3 4 5 6; do
  awk -v found="$found" -v round=$round 'function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) }
    BEGIN { srand(round); split(found, f); print "kappa_Pa,inverse_m"
      for (i = 0; i < 200; ++i) print f[1] + f[3] * normal() "," f[2] + f[4] * normal() }' >asked.csv
  "${calibrate[@]}" --ask asked.csv --tell told.csv >/dev/null # kappa_Pa,inverse_m,deviance,R2,relative_l2
  found=$(tail -n +2 told.csv | grep -v ,inf, | sort -t, -g -k3 | head -20 | awk -F, '
    { k += $1; n += $2; kk += $1 * $1; nn += $2 * $2 }
    END { print k / NR, n / NR, 1.5 * sqrt(kk / NR - (k / NR) ^ 2), 1.5 * sqrt(nn / NR - (n / NR) ^ 2) }')
  echo "round $round: kappa_Pa and inverse_m, and how far the next are drawn: $found"
done
echo "by least squares:"
"${calibrate[@]}" | sed -n '2,3p'
awk -v found="$found" 'BEGIN { split(found, f); exit !(f[1] > 4.8e6 && f[1] < 5.2e6 && f[2] > 0.47 && f[2] < 0.53) }'
