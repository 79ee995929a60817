#!/bin/bash
# CPU time of one contact in one step: pair_style platen beside LAMMPS's own contact styles, in the same LAMMPS.
#   bench/lammps/benchmark.sh [FOLDER OF THE PLUG-IN] [REPEATS]
# 32,768 spheres in a periodic box, on a simple cubic lattice pressed by 2 %, with random velocities, so that contacts
# load, unload and slide; the second 250 steps. First of equal radii (98,304 contacts), then each sphere of a radius of
# its own, up to 3 % larger or smaller, pressed by 4 %. The styles take turns, and the least time of each is given:
# LAMMPS's own wall time of "Pair", so leave the machine alone meanwhile. Each rank is bound to a core of its own; the
# processor and the binding are printed. Efficiency: of two ranks over one; ratio: of one rank to gran/hertz/history.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
plugin=$(realpath "${1:-$here/../../build/release/lammps}")
repeats=${2:-3}
lmp=${PLATEN_LMP:-lmp} # another LAMMPS, with the plug-in built for it
command -v "$lmp" >/dev/null || { echo "skipped: LAMMPS is not installed (./run lammps)"; exit 77; }
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

card() { printf 'platen = 1\nlaw = "%s"\n\n[parameters]\n%s\n' "$1" "$2" >"$out/$1.toml"; }
elastic=$'E_Pa = 1e8\nnu = 0.3\n'
card hertz "$elastic"
card similarity "${elastic}kappa_Pa = 1e6"$'\ninverse_m = 0.3'
card edmans-sinka "${elastic}sigma_ref_Pa = 1e6"$'\nk = 6.4\ndelta_t = 0.12\na = 2.4'
card wang "${elastic}phi_deg = 25"$'\nsigma_c_Pa = 1e6'
card agarwal "${elastic}sigma_y_Pa = 1e6"
card shahin "${elastic}kappa_Pa = 1e6"$'\ninverse_m = 0.3'
card thornton-ning "${elastic}p_y_Pa = 1.6e6"
card kogut-etsion "${elastic}sigma_y_Pa = 1e6"
card etsion-unloading "${elastic}sigma_y_Pa = 1e6"
card jackson-green "${elastic}sigma_y_Pa = 1e6"
card mdr "${elastic}sigma_y_Pa = 1e6"
card luding $'k_1_N_per_m = 4e3\nk_2_N_per_m = 2e4\nphi_f = 0.1'
card eepa "${elastic}lambda_p = 0.6"
card pressed "${elastic}sigma_ref_Pa = 1e6
delta_bar = [1e-4, 1e-3, 1e-2, 0.05, 0.1, 0.2, 0.35, 0.5]
F_bar = [5e-5, 1.4e-3, 0.035, 0.22, 0.48, 1.1, 2.2, 4]
a_bar = [0.009, 0.03, 0.13, 0.32, 0.46, 0.66, 0.85, 1]
unload_delta_bar = [0.1, 0.3, 0.5]
alpha = [1.4, 1.3, 1.25]
beta = [1.2, 1.5, 1.7]"

declare -A style=(
  [gran/hertz/history]='pair_style gran/hertz/history 7.3e7 NULL 0 NULL 0.3 0
pair_coeff * *'
  [granular]='pair_style granular
pair_coeff * * hertz/material 1e8 0 0.3 tangential mindlin NULL 0 0.3 damping velocity'
)
laws=(hertz similarity edmans-sinka wang agarwal shahin thornton-ning kogut-etsion etsion-unloading jackson-green mdr luding eepa
  pressed)
for law in "${laws[@]}"; do
  style[platen/$law]="include $plugin/platen.lmp
pair_style platen
pair_coeff * * $out/$law.toml friction 0.3"
done
style[platen/luding]=${style[platen/luding]/friction 0.3/} # knows no modulus, so no friction

input() { # STYLE SPREAD SPACING: random velocities make contacts load, unload, slide
  cat <<TEXT
units si
atom_style sphere
newton off
comm_modify vel yes
boundary p p p
lattice sc $3
region box block 0 32 0 32 0 32
create_box 1 box
create_atoms 1 box
variable diameter atom 2e-3*(1+$2*(2*random(0,1,13)-1))
set group all diameter v_diameter
set group all density 1500
variable vx atom ${speed}*(random(0,1,11)-0.5)
variable vy atom ${speed}*(random(0,1,12)-0.5)
variable vz atom ${speed}*(random(0,1,13)-0.5)
velocity all set v_vx v_vy v_vz
${style[$1]}
timestep ${dt}
neighbor 1e-4 bin
neigh_modify delay 0 every 1 check yes
fix move all nve/sphere
compute contacts all contact/atom
compute number all reduce sum c_contacts
variable contacts equal c_number/2
thermo_style custom step v_contacts ke
thermo 250
run 250
run 250
TEXT
}
speed=0.5 dt=4e-7

measure() { # STYLE RANKS SPREAD SPACING: contacts, ns a contact and step in Pair, over all ranks
  input "$1" "$3" "$4" >"$out/in"
  local run=(mpirun -n "$2" --map-by core --bind-to core --report-bindings
    "$lmp" -in "$out/in" -log "$out/log" -screen none)
  "${run[@]}" >"$out/screen" 2>&1 || { tail -n 5 "$out/screen" "$out/log" >&2; return 1; }
  awk -v ranks="$2" '
    $1 == "250" || $1 == "500" { contacts = $2 } $1 == "Pair" && $2 == "|" { pair = $5 }
    END { printf "%d %.1f\n", contacts, pair * ranks / (contacts * 250) * 1e9 }' "$out/log"
}

LC_ALL=C lscpu | grep -E '^(Model name|CPU\(s\)|Thread\(s\) per core|Core\(s\) per socket|Socket\(s\)):'
styles=(gran/hertz/history granular "${laws[@]/#/platen/}")
table() { # SPREAD SPACING
  local -A best
  for ((r = 0; r < repeats; ++r)); do
    for name in "${styles[@]}"; do
      for ranks in 1 2; do
        read -r contacts ns < <(measure "$name" "$ranks" "$1" "$2")
        old=${best[$name,$ranks]:-1e9}
        best[$name,$ranks]=$(awk -v a="$old" -v b="$ns" 'BEGIN { print b < a ? b : a }')
        best[$name,contacts]=$contacts
      done
    done
  done
  printf '%-28s %10s %12s %12s %12s %8s\n' style contacts 'ns, 1 rank' 'ns, 2 ranks' 'efficiency' 'ratio'
  for name in "${styles[@]}"; do
    awk -v name="$name" -v n="${best[$name,contacts]}" -v one="${best[$name,1]}" -v two="${best[$name,2]}" \
      -v host="${best[${styles[0]},1]}" \
      'BEGIN { printf "%-28s %10d %12s %12s %12.2f %8.2f\n", name, n, one, two, one / two, one / host }'
  done
}
echo 'equal radii'
table 0 1.96e-3
echo 'a radius of its own for each sphere'
table 0.01 1.92e-3
grep -o 'rank .*bound to.*' "$out/screen" # of the last run
