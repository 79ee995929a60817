#!/bin/bash
set -eu
platen=$(realpath "${1:-build/release/bin/platen}") # the program
out=${2:-$(mktemp -d)}                              # where results go
mkdir -p "$out"
cd "$out"

# A powder that is known, led through a die as a material point, with three unloadings; here, so that the example needs no data.
cat >truth.toml <<'CARD'
platen = 1
name = "excipient"
model = "dpc"
[parameters]
rho_r0 = 0.45
sigma_y = "9 MPa"
E = "520 MPa"
nu = 0.12
Gamma = "7.2 MPa"
Lambda = "1.1 MPa"
epsilon = 0.42
eta = 6.4
xi = 5.1
zeta = 5.6
omega = 6
xi_1 = 0.35
xi_2 = 0.5
CARD
awk 'BEGIN { print "eps_1,eps_2,eps_3"
  for (i = 1; i <= 600; ++i) { x = -i * 1e-3; print x ",0,0"
    if (i % 200 == 0) { for (k = 1; k <= 60; ++k) print x + k * 1e-4 ",0,0"; for (k = 59; k >= 0; --k) print x + k * 1e-4 ",0,0" } } }' >path.csv
"$platen" point truth.toml --path path.csv -o point >/dev/null
awk -F, '/^#/ { next } !head++ { for (i = 1; i <= NF; ++i) at[$i] = i; print "rho_r,axial_stress_MPa,radial_stress_MPa"; next }
  $at["eps_1"] < 0 { printf "%.8f,%.6f,%.6f\n", 0.45 * exp(-$at["eps_1"]), -$at["sigma_1_Pa"] / 1e6, -$at["sigma_2_Pa"] / 1e6 }' \
  point/point.csv >die.csv

# Tablets: uniaxial and diametral strength, which this surface would have.
awk 'BEGIN { print "rho_r,compressive_strength_MPa,tensile_strength_MPa"
  for (rho = 0.5; rho < 0.81; rho += 0.1) { x = rho - 0.45
    s = 9 * exp(6.4 * x); G = 7.2 * exp(5.6 * x); L = 1.1 * exp(6 * x); t = G / (L + s - (0.42 + 0.5 * x) * G); d = L * t
    printf "%g,%.6f,%.6f\n", rho, d / (1 - t / 3), d / (sqrt(13) - 2 * t / 3) } }' >tablets.csv

"$platen" compaction die.csv --strengths tablets.csv --rho_r0 0.45 --model dpc -o powder.toml
"$platen" materials powder.toml
