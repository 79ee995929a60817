#!/bin/bash
# command_line.sh PROGRAM: what the program answers, and with which exit code (0, 2, 3, 4).
set -u
platen=$1
pools=$(realpath "$(dirname "$0")/../../catalogue/pools")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

# answers CODE TEXT COMMAND...: the exit code, and a text that standard output or error contains
answers() {
  local code=$1 text=$2 got
  shift 2
  "$@" >answer 2>&1 </dev/null
  got=$?
  if [ $got -ne "$code" ] || ! grep -qF -- "$text" answer; then
    failures=$((failures + 1))
    echo "FAILED: $*"
    echo "  wanted exit $code and the text: $text"
    echo "  got exit $got and:"
    sed 's/^/    /' answer
  fi
}

has() { [ -e "$1" ] || { failures=$((failures + 1)); echo "FAILED: $1 is missing"; }; }
has_not() { [ ! -e "$1" ] || { failures=$((failures + 1)); echo "FAILED: $1 is there"; }; }

material() { # [KEY VALUE]...: a card with some lines replaced
  local card
  card=$(printf '%s\n' 'platen = 1' 'name = "granule"' 'model = "vmdc"' '[parameters]' 'rho_r0 = 0.7' \
    'sigma_y_Pa = 150e6' 'nu = 0.3' 'E_bar = 100' 'Gamma_bar = 1' 'Lambda_bar = 0.01' 'epsilon = 0.7' 'eta = 10' \
    'xi = 7.5' 'zeta = 10' 'omega = 10' 'xi_1 = 0.4' 'xi_2 = 1.5')
  while [ $# -gt 0 ]; do
    card=$(printf '%s\n' "$card" | sed "s|^$1 =.*|$2|")
    shift 2
  done
  printf '%s\n' "$card" >material.toml
}

case_card() { # MATERIAL LINES...
  printf '%s\n' 'platen = 1' 'experiment = "simple"' "material = \"$1\"" 'radius_m = 1e-3' "${@:2}" >case.toml
}

# --- help ---
answers 0 'platen derive' "$platen"
answers 0 'platen 0.' "$platen" --version
for command in materials point press fit derive import calibrate compaction convert predict reproduce; do answers 0 'Example:' "$platen" $command --help; done
for command in design run status export submit merge check surrogate; do answers 0 'Example:' "$platen" study $command --help; done
answers 0 '| `only` |' "$platen" study design --keys
answers 2 'STUDY.toml is required' "$platen" study design
cat >candidates.toml <<'CARD'
platen = 1
name = "candidates"
case = { platen = 1, experiment = "simple", material = "von-mises-100", radius_m = 1e-3 }
[design]
kind = "latin-hypercube"
runs = 40
[factors]
"material.E_bar" = { min = 3, max = 2000, scale = "log" }
[fit]
laws = ["edmans-sinka"]
CARD
answers 0 '3 presses' "$platen" study refine candidates.toml --surrogate "$pools/von-mises" --target 1e-5 --most 3
answers 0 '3  table' "$platen" study design candidates-refined.toml
answers 0 'nothing to press' "$platen" study refine candidates.toml --surrogate "$pools/von-mises" --target 0.05
answers 2 'the surrogate of vmdc' "$platen" study refine candidates.toml --surrogate "$pools/powders"
answers 2 'that is the study itself' "$platen" study refine candidates.toml --surrogate "$pools/von-mises" --target 1e-5 -o candidates.toml
answers 0 'Gamma_bar' "$platen" study sobol base-case --within 0.1 -o sobol.svg
has sobol.svg
answers 2 'it locks' "$platen" study sobol dical-emcompress
answers 0 'mcc-ph-200' "$platen" materials
answers 0 'sigma_y_Pa' "$platen" materials mcc-ph-200
answers 0 '"model": "vmdc"' "$platen" materials mcc-ph-200 --json

# --- predict ---
answers 0 'verdict        inside' "$platen" predict base-case --law edmans-sinka -o predicted.toml
has predicted.toml
answers 0 '"verdict": "inside"' "$platen" predict von-mises-100 --law edmans-sinka --json -o predicted.toml
answers 0 'verdict        inside' "$platen" predict --E_Pa 2e9 --nu 0.25 --sigma_y_Pa 2e7 --law edmans-sinka -o predicted.toml
answers 2 'E_bar = 10000 is not in 3 to 2000; ' "$platen" predict --E_Pa 1e9 --nu 0.3 --sigma_y_Pa 1e5 -o outside.toml
has_not outside.toml
answers 0 'warning: extrapolated' "$platen" predict --E_Pa 1e9 --nu 0.3 --sigma_y_Pa 1e5 --law edmans-sinka --extrapolate -o outside.toml
answers 2 '--sigma_y_Pa is required' "$platen" predict --E_Pa 1e9 --nu 0.3
answers 2 'not both' "$platen" predict base-case --nu 0.3
answers 0 'sigma_y = hardness/2.8 = 7e+08 Pa' "$platen" predict --E_Pa 2e11 --nu 0.3 --hardness_Pa 1.96e9 -o predicted.toml
answers 2 'partly elastic' "$platen" predict --E_Pa 2e9 --nu 0.3 --hardness_Pa 2e8
answers 0 'Lambda_bar = 0.00' "$platen" predict --strain_index 0.011 --bonding_index 0.008 --hardness_Pa 3e8 --relative_density 0.9 -o predicted.toml
answers 2 'platen derive outside-material.toml' "$platen" predict --E_Pa 1e9 --nu 0.3 --sigma_y_Pa 1e5 --material-card outside-material.toml -o outside.toml
answers 0 'E_Pa' cat outside-material.toml
answers 0 'verdict' "$platen" predict --strain_index 0.011 --bonding_index 0.008 --hardness_Pa 3e8 --relative_density 0.9 --material-card granule.toml -o predicted.toml
answers 0 'verdict' "$platen" predict granule.toml --quick -o again.toml
answers 2 'is the card of this material' "$platen" predict base-case --material-card granule.toml
answers 2 '--relative_density is required' "$platen" predict --strain_index 0.011 --bonding_index 0.008 --hardness_Pa 3e8
answers 2 'no material beside' "$platen" predict base-case --strain_index 0.011
answers 0 'sigma_y = P_y/3 = 2.5e+07 Pa' "$platen" predict --E_Pa 5e9 --nu 0.3 --heckel_Pa 75e6 -o predicted.toml
answers 2 'spring back' "$platen" predict --E_Pa 5e9 --nu 0.3 --heckel_Pa 6e8
answers 0 'sigma_y = 1.958' "$platen" predict --E_Pa 2e9 --nu 0.3 --crush_force_N 26.6 --crush_overlap_m 1e-4 --radius_m 1e-3 -o predicted.toml
answers 2 'more than E allows' "$platen" predict --E_Pa 2e9 --nu 0.3 --crush_force_N 1e4 --crush_overlap_m 1e-4 --radius_m 1e-3
answers 2 '--crush_overlap_m is required' "$platen" predict --E_Pa 2e9 --nu 0.3 --crush_force_N 10
answers 2 'each says the yield stress' "$platen" predict --E_Pa 2e9 --nu 0.3 --sigma_y_Pa 2e7 --hardness_Pa 6e7
answers 2 'nu' "$platen" predict --E_Pa 1e9 --nu 0.6 --sigma_y_Pa 1e5
answers 0 'law wang from 162 grains' "$platen" predict wang-type-1 -o rock.toml
answers 0 'variant = "fitted"' cat rock.toml
answers 2 'it is wang that is predicted' "$platen" predict wang-type-1 --law pressed -o rock.toml
answers 2 'nu = 0.38 is not in 0.1 to 0.3' "$platen" predict sandstone-wang-3-4 -o outside.toml
answers 2 'nu = 0.435 is not in 0.2' "$platen" predict lead-ludwik
answers 2 "did you mean 'pressed'?" "$platen" predict base-case --law presed

# --- the command line ---
answers 2 "did you mean 'derive'?" "$platen" deriv
answers 2 'CURVE.csv' "$platen" fit
answers 2 'CASE.toml' "$platen" press
answers 2 '--no-such' "$platen" derive base-case --no-such
answers 2 "did you mean 'base-case'?" "$platen" materials base-cas
answers 2 'radius_m' "$platen" derive base-case --radius_m -1
answers 2 '(0, 0.5]' "$platen" derive base-case --delta_bar_max 0.6
answers 2 "'x' is not a number" "$platen" derive base-case --unload_from 0.1,x
answers 2 'each greater than the one before' "$platen" derive base-case --unload_from 0.3,0.1
answers 2 'beyond delta_bar_max = 0.2' "$platen" derive base-case --delta_bar_max 0.2 --unload_from 0.1,0.3
answers 2 '8 branches at most' "$platen" derive base-case --unload_from .1,.15,.2,.25,.3,.35,.4,.45,.5
answers 2 "did you mean 'hertz-like'?" "$platen" derive base-case --variant hertzlike
has_not out

# --- a material point ---
answers 0 'step,eps_1' "$platen" point base-case --path isotropic
answers 0 'results in' "$platen" point lead-ludwik --path triaxial --strain 0.5 -o walk
has walk/point.csv
has walk/surface.svg
answers 0 'compaction' "$platen" point mcc-ph-200 --model dpc --path uniaxial-strain --strain -0.1
printf 'eps_1,eps_2,eps_3\n0,0,0\n-0.01,0,0\n-0.01,0.02,0\n' >strains.csv
answers 0 'shear' "$platen" point sandstone-wang-3-4 --path strains.csv
answers 2 "did you mean 'triaxial'?" "$platen" point base-case --path triaxal
answers 2 '[-3, 3]' "$platen" point base-case --path shear --strain 9
answers 2 '[1, 1000000]' "$platen" point base-case --path shear --steps 0
answers 2 'implicit or after-step' "$platen" point base-case --path shear --moduli explicit
answers 2 'cannot be run as' "$platen" point lead-ludwik --model dpc --path shear
printf 'eps_1,eps_2,eps_3\n' >strains.csv
answers 2 'no row' "$platen" point base-case --path strains.csv

# --- cards ---
answers 2 'there is no such file' "$platen" derive missing.toml -o out
printf 'platen = 1\nname = "x\n' >material.toml
answers 2 'line 2' "$platen" derive material.toml -o out
material sigma_y_Pa 'sigmay_Pa = 150e6'
answers 2 "did you mean 'sigma_y_Pa'?" "$platen" derive material.toml -o out
material E_bar 'E_MPa = 100'
answers 2 'write E_Pa = 1e8' "$platen" derive material.toml -o out
material E_bar 'E_Pa = "stiff"'
answers 2 'is text; it must be a number > 0' "$platen" derive material.toml -o out
for wrong in 'E_bar = 0:> 0' 'nu = 0.5:[0, 0.5)' 'nu = -0.1:[0, 0.5)' 'epsilon = 0:> 0' 'epsilon = -0.0783:> 0' \
  'rho_r0 = 0:(0, 1]' 'rho_r0 = 1.1:(0, 1]'; do
  line=${wrong%%:*}
  material "${line%% *}" "$line"
  answers 2 "${wrong#*:}" "$platen" derive material.toml -o out
  grep -qF "material.toml, line" answer && grep -qF "$line" answer || {
    failures=$((failures + 1))
    echo "FAILED: file, line, key and value of '$line' are not named: $(cat answer)"
  }
done
case_card base-case '[path]' 'delta_bar_max = 0.51'
answers 2 '(0, 0.5]' "$platen" press case.toml -o out
case_card base-case '[path]' 'delta_bar_max = 0'
answers 2 '(0, 0.5]' "$platen" press case.toml -o out
case_card base-case '[path]' 'delta_bar_max = 0.9'
sed -i 's/"simple"/"die"/' case.toml
answers 2 'leaves the cell 0.273 of the volume' "$platen" press case.toml -o out
sed -i 's/"die"/"dye"/' case.toml
answers 2 "did you mean 'die'" "$platen" press case.toml -o out
has_not out

# --- small contacts ---
printf 'platen = 1\nexperiment = "local"\nmaterial = "wang-type-1"\nradius_m = 0.1\n[path]\nforce_max_N = -1\n' >local.toml
answers 2 'force_max_N = -1 is not allowed' "$platen" press local.toml -o out
has_not out
answers 0 'depth of first yield' "$platen" laws wang -p radius_m=0.1 -p E_Pa=10e9 -p nu=0.15 -p phi_deg=25 -p sigma_c_Pa=15e6
answers 2 'one uniaxial strength' "$platen" derive base-case --law wang -o out
answers 2 "did you mean 'wang'?" "$platen" derive wang-type-1 --law wangs -o out
answers 2 '--elements is not for --law wang' "$platen" derive wang-type-1 --law wang --elements 100 -o out
answers 2 'the load ends before first yield' "$platen" derive wang-type-1 --law wang --delta_bar_max 1e-6 -o out
answers 2 '--force_max_N is for --law wang' "$platen" derive base-case --force_max_N 3 -o out
has_not out
printf 'delta_m,force_N\n0,0\n1e-5,1\n' >curve.csv
answers 2 '--sigma_c_Pa' "$platen" fit curve.csv --radius_m 1e-3 --E_Pa 1e9 --nu 0.3 --law wang

# --- curves ---
printf 'delta_m,force_N\n0,0\n1e-5,oops\n' >curve.csv
answers 2 'line 3, column force_N' "$platen" fit curve.csv --radius_m 1e-3 --law edmans-sinka
printf 'delta_m,force_N\n0,0\n1e-5,1\n' >curve.csv
answers 2 '--radius_m' "$platen" fit curve.csv --law edmans-sinka
answers 2 "did you mean 'edmans-sinka'?" "$platen" fit curve.csv --radius_m 1e-3 --law edmans-sink
awk 'BEGIN { print "delta_m,force_N"; for (i = 0; i <= 50; ++i) print i * 1e-5 "," i * i * 1e-3 }' >curve.csv
answers 0 'relative L2' "$platen" fit curve.csv --radius_m 1e-3 --law edmans-sinka
answers 2 '--E_Pa' "$platen" fit curve.csv --radius_m 1e-3 --law edmans-sinka -o law.toml
has_not law.toml
answers 4 'cannot be written' "$platen" fit curve.csv --radius_m 1e-3 --E_Pa 1e9 --nu 0.3 --law edmans-sinka \
  -o no/such/folder/law.toml

# --- output ---
case_card von-mises-100 '[path]' 'delta_bar_max = 0.02' '[mesh]' 'elements = 200' '[output]' 'fields_at = [0.02]'
touch file
answers 4 'name another with -o' "$platen" press case.toml -o file/out
if [ "$(id -u)" -ne 0 ]; then
  mkdir locked && chmod a-w locked
  answers 4 'name another with -o' "$platen" press case.toml -o locked
fi
answers 0 'results in out' "$platen" press case.toml -o out
for name in case.toml curve.csv summary.json zones.svg; do has out/$name; done
for name in fields.pvd fields-0.02.vtu; do has out/$name; done
answers 0 'relative L2' "$platen" fit out/curve.csv --law edmans-sinka -o law.toml
has law.toml
sed -i 's/^nu = 0.3$/&\ntensile_strength_Pa = 2e7/' out/case.toml
answers 0 'it reaches the tensile strength, 2e+07 Pa, at delta_bar = 0.0' "$platen" press out/case.toml -o strong
grep -qF '"tensile_strength_Pa": 20000000.0' strong/summary.json || { failures=$((failures + 1)); echo 'FAILED: summary.json has no strength'; }

# --- derive: five branches unless told otherwise; the law card unloads by them ---
answers 0 'fits best: relative L2' "$platen" derive von-mises-100 -o derived --delta_bar_max 0.1 --elements 200 --variant best
grep -qF 'unload_delta_bar = [0.02, 0.04, 0.06, 0.08, 0.1]' derived/edmans-sinka.toml ||
  { failures=$((failures + 1)); echo "FAILED: $(cat derived/edmans-sinka.toml)"; }
grep -qF 'law = "pressed"' derived/law.toml || { failures=$((failures + 1)); echo "FAILED: $(cat derived/law.toml)"; }
answers 0 'true' "$platen" eval derived/law.toml -p radius_m=1e-3 --overlap 1e-5
answers 0 'worst point' "$platen" fit derived/curve.csv --law pressed -o again.toml
for card in again.toml derived/law.toml; do sed -n "/parameters/,/validity/p" $card >$card.parameters; done
cmp -s again.toml.parameters derived/law.toml.parameters || { failures=$((failures + 1)); echo "FAILED: fit and derive write two laws"; }
grep -qF 'unload_R2 = [0.99' derived/edmans-sinka.toml ||
  { failures=$((failures + 1)); echo "FAILED: $(cat derived/edmans-sinka.toml)"; }
grep -qF 'law = "pressed"' derived/law.toml || { failures=$((failures + 1)); echo "FAILED: $(cat derived/law.toml)"; }
answers 0 'true' "$platen" eval derived/law.toml -p radius_m=1e-3 --overlap 1e-5
answers 0 'worst point' "$platen" fit derived/curve.csv --law pressed -o again.toml
for card in again.toml derived/law.toml; do sed -n "/parameters/,/validity/p" $card >$card.parameters; done
cmp -s again.toml.parameters derived/law.toml.parameters || { failures=$((failures + 1)); echo "FAILED: fit and derive write two laws"; }
has_not derived/fields.pvd
answers 0 ',unloading,' "$platen" eval derived/law.toml -p radius_m=1e-3 --path <(printf 'overlap_m\n1e-4\n9.9e-5\n')
answers 0 'unload_R2' "$platen" fit derived/curve.csv --law edmans-sinka --json
sed 's/^# E_Pa = .*//' derived/curve.csv >without.csv
answers 0 'give --E_Pa and --nu' "$platen" fit without.csv --law edmans-sinka
# --- laws of large deformation: their coefficients, each replaceable ---
answers 0 'sides move by gamma_s/R' "$platen" fit derived/curve.csv --law agarwal -o agarwal.toml
answers 0 '"not_fitted"' "$platen" fit derived/curve.csv --law agarwal --json
answers 0 ',loading,' "$platen" eval agarwal.toml -p radius_m=1e-3 --overlap 1e-5:1e-4:3
answers 2 'H_max = 0.5 is not in (1.1, inf)' "$platen" eval agarwal.toml -p radius_m=1e-3 -p H_max=0.5 --overlap 1e-5:1e-4:3
answers 2 'platen compare draws' "$platen" fit derived/curve.csv --law agarwal --picture a.svg
answers 2 'give --inverse_m' "$platen" fit derived/curve.csv --law shahin
answers 2 'in [0, 1]' "$platen" fit derived/curve.csv --law shahin --inverse_m 2
answers 0 'E/kappa = 100' "$platen" fit derived/curve.csv --law shahin --inverse_m 0 -o shahin.toml
answers 0 ',loading,' "$platen" eval shahin.toml -p radius_m=1e-3 --overlap 1e-5:1e-4:3
answers 0 'law card' "$platen" derive von-mises-100 -o derived --delta_bar_max 0.1 --elements 200 --unload_from none
grep -q 'alpha' derived/law.toml && { failures=$((failures + 1)); echo "FAILED: $(cat derived/law.toml)"; }
answers 0 'results in again' "$platen" press out/case.toml -o again
cmp -s out/curve.csv again/curve.csv || { failures=$((failures + 1)); echo 'FAILED: out/case.toml gives another curve'; }

# --- laws: each answer against a number from outside ---
answers 0 'edmans-sinka' "$platen" laws
answers 0 'sigma_c_Pa' "$platen" laws wang
answers 0 'F_y      9.0560' "$platen" laws wang -p radius_m=0.1 -p E_Pa=1e10 -p nu=0.15 -p phi_deg=25 -p sigma_c_Pa=15e6
answers 2 "did you mean 'wang'" "$platen" laws wan
answers 0 ',loading,0,true' "$platen" eval hertz -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-6:3
answers 0 'warning: 1 of 2 points are outside' "$platen" eval hertz -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-3:2
answers 2 'known are: hertz, similarity' "$platen" eval hertzz --overlap 0:1:3
for E in 1e9 5e10; do
  printf '%s\n' 'platen = 1' 'law = "hertz"' '[parameters]' "E_Pa = $E" 'nu = 0.3' >"hertz-$E.toml"
done
radii=(-p radius_m=1e-3 -p radius2_m=2e-3)
answers 0 "$("$platen" eval hertz -p E_Pa=1e9 -p nu=0.3 -p E2_Pa=5e10 -p nu2=0.3 "${radii[@]}" --overlap 1e-6 | tail -n 1)" \
  "$platen" eval hertz-1e9.toml --with hertz-5e10.toml "${radii[@]}" --overlap 1e-6
answers 2 'radius_m is missing' "$platen" eval hertz-1e9.toml --with hertz-5e10.toml --overlap 1e-6
answers 2 'E_Pa has no place beside --with' "$platen" eval hertz-1e9.toml --with hertz-5e10.toml -p radius_m=1 -p E_Pa=1e9 --overlap 1e-6
for wrong in 'against = "plane"' 'E2_Pa = 1e10' 'radius2_m = 1'; do # of a second body: which of the two would it be?
  (cat hertz-1e9.toml && echo "$wrong") >of-a-pair.toml
  answers 2 'of-a-pair.toml: the card is for' "$platen" eval hertz-5e10.toml --with of-a-pair.toml "${radii[@]}" --overlap 1e-6
done
answers 2 'nothere.toml: there is no such file' "$platen" eval hertz-1e9.toml --with nothere.toml -p radius_m=1 --overlap 1e-6
answers 0 '1e-6,0.0163814' "$platen" eval hertz -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3 --overlap 1e-6 --exact
granule=(edmans-sinka -p radius_m=1e-3 -p nu=0.2 -p sigma_ref_Pa=1e7 -p Gamma_bar=1)
answers 0 '1e-4,6.125' "$platen" eval "${granule[@]}" -p E_Pa=1e9 --overlap 1e-4
answers 2 'Appendix A holds for E_Pa/sigma_ref_Pa from 4.5 to 500' "$platen" eval "${granule[@]}" -p E_Pa=1e10 --overlap 1e-4
answers 2 'write -p radius_m=1' "$platen" eval hertz -p radius=1 --overlap 0:1:3
answers 2 'nu = 0.5 is not in [0, 0.5)' "$platen" eval hertz -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.5 --overlap 0:1:3
answers 0 'unloading_exponent' "$platen" export table hertz -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3 --overlap 1e-7:1e-6:3

# --- laws, used without care ---
hertz=(hertz -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3)
for range in 0:1e-6:1 0:1e-6:0 0:1e-6:-3 0:1e-6:2.5 0:1e-6:1e9 0:1e-6:nan; do
  answers 2 'whole number from 2 to 1e7' "$platen" eval "${hertz[@]}" --overlap $range
  answers 2 'whole number from 2 to 1e7' "$platen" export table "${hertz[@]}" --overlap $range
done
for range in nan:1e-6:3 0:inf:3 -inf:0:3; do
  answers 2 'must be finite' "$platen" eval "${hertz[@]}" --overlap=$range
done
answers 2 'the range is empty' "$platen" eval "${hertz[@]}" --overlap 1e-6:1e-6:3
answers 2 'the range is empty' "$platen" export table "${hertz[@]}" --overlap 1e-6:1e-6:3
printf '%s\n' 'platen = 1' 'law = "hertz"' '[parameters]' 'E_Pa = 1e9' 'nu = 0.3' >hertz.toml
hertz_card=(hertz.toml --delta-bar 0.01)
answers 0 'timestep' "$platen" export lammps hertz.toml --radius 1e-4 --density 636
printf '%s\n' 'platen = 1' 'law = "luding"' '[parameters]' 'k_1_N_per_m = 1e4' 'k_2_N_per_m = 5e4' 'phi_f = 0.1' >springs.toml
answers 2 'luding' "$platen" export lammps hertz.toml springs.toml --radius 1e-4 --density 636
answers 0 'timestep' "$platen" export lammps "${hertz_card[@]}" --radius 1e-4 --density 636
answers 0 'pair_coeff 1 2' "$platen" export lammps hertz.toml hertz.toml --delta-bar 0.01 --radius 1e-4 --density 636
platen_card() { printf 'platen = 1\nname = "s"\nmodel = "elastic"\n[parameters]\nE_Pa = 1e9\nnu = 0.3\n%s\n' "$1"; }
platen_card 'density_kg_per_m3 = 636' > heavy.toml
platen_card '' > weightless.toml
answers 0 ' 636 kg/m^3' "$platen" export lammps "${hertz_card[@]}" --radius 1e-4 --material heavy.toml
answers 2 'no density_kg_per_m3' "$platen" export lammps "${hertz_card[@]}" --radius 1e-4 --material weightless.toml
answers 2 'positive number of kg/m^3' "$platen" export lammps "${hertz_card[@]}" --radius 1e-4
answers 2 'positive number of metres' "$platen" export lammps "${hertz_card[@]}" --radius -1 --density 636
answers 2 'a number in (0, 1]' "$platen" export lammps hertz.toml --delta-bar -1 --radius 1e-4 --density 636
answers 2 'is no number' "$platen" export lammps "${hertz_card[@]}" --radius 1e200 --density 636
both=(hertz.toml hertz.toml)
answers 0 'with type 1' "$platen" export lammps "${both[@]}" --radius 1e-4 2e-4 --density 636 1500
answers 2 'once for each' "$platen" export lammps "${both[@]}" hertz.toml --radius 1e-4 2e-4 --density 636
answers 2 'there is no such file' "$platen" export lammps missing.toml --radius 1e-4 --density 636
answers 0 'use_platen' "$platen" export dem-engine hertz.toml --restitution 0.5 --friction 0.3 -o engine
has engine/functions.cu
has engine/model.cu
has engine/platen_model.py
answers 2 'restitution coefficient in (0, 1]' "$platen" export dem-engine hertz.toml --restitution 2 -o engine
answers 2 'a coefficient of 0 or more' "$platen" export dem-engine hertz.toml --friction -1 -o engine
answers 2 'E_Pa is missing' "$platen" export dem-engine hertz -o engine
answers 2 '-o is required' "$platen" export dem-engine hertz.toml
answers 0 'E_Pa = 1e+09, nu = 0.3, restitution = 1.000' "$platen" export parameters hertz.toml --radius 1e-3 --delta-bar 0.1
answers 0 '"k_2_N_per_m"' "$platen" export parameters hertz.toml --radius 1e-3 --delta-bar 0.1 --json
answers 2 'give --delta-bar' "$platen" export parameters hertz.toml --radius 1e-3
answers 2 'a number in (0, 1]' "$platen" export parameters hertz.toml --radius 1e-3 --delta-bar 2
answers 2 'positive number of metres' "$platen" export parameters hertz.toml --radius 0
answers 2 'laws are held constant' "$platen" export table "${hertz[@]}" --overlap 1e-6:1e9:3
answers 2 'a table rises' "$platen" export table "${hertz[@]}" --overlap 2e-6:1e-6:3
answers 2 'above 0' "$platen" export table "${hertz[@]}" --overlap 0:1e-6:3
answers 2 '--overlap' "$platen" export table "${hertz[@]}"
answers 2 'FROM:TO:COUNT' "$platen" eval "${hertz[@]}" --overlap 0:1e-6
answers 2 "is not a number" "$platen" eval "${hertz[@]}" --overlap a:b:c
answers 2 'give either --overlap' "$platen" eval "${hertz[@]}"
answers 0 '1e-6,0.0163814503' "$platen" eval "${hertz[@]}" --overlap=-1e-6:1e-6:3 # Hertz by hand
answers 2 'nu is given twice' "$platen" eval "${hertz[@]}" -p nu=0.2 --overlap 0:1e-6:3
answers 2 "radius_m = 'nan'" "$platen" eval hertz -p radius_m=nan -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-6:3
answers 2 'radius_m = -1 is not in (0, inf)' "$platen" eval hertz -p radius_m=-1 -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-6:3
answers 2 "radius_m = '' is not a number" "$platen" eval hertz -p radius_m= -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-6:3
answers 2 'radius_m is missing' "$platen" eval hertz -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-6:3
answers 2 'not of the form key=value' "$platen" eval hertz -p radius_m --overlap 0:1e-6:3
answers 2 'known are: published' "$platen" eval "${hertz[@]}" --variant none --overlap 0:1e-6:3
answers 2 'neither sphere nor plane' "$platen" eval "${hertz[@]}" --against wall --overlap 0:1e-6:3
answers 2 'there is no such file' "$platen" eval missing.toml --overlap 0:1e-6:3
answers 2 'there is no such file' "$platen" export table missing.toml --overlap 1e-7:1e-6:3
material nu 'nu = 0.3'
case_card base-case
answers 2 'this is a case card' "$platen" eval case.toml --overlap 0:1e-6:3
answers 2 'this is a material card' "$platen" eval material.toml --overlap 0:1e-6:3
answers 2 'there is no such file' "$platen" eval "${hertz[@]}" --path missing.csv
printf 'x\n1\n' >path.csv
answers 2 'column overlap_m is missing' "$platen" eval "${hertz[@]}" --path path.csv
printf 'overlap_m\nnan\n' >path.csv
answers 2 'is not a finite number' "$platen" eval "${hertz[@]}" --path path.csv
printf 'overlap_m\n' >path.csv
answers 2 'no row below the header' "$platen" eval "${hertz[@]}" --path path.csv
answers 4 'cannot be written' "$platen" eval "${hertz[@]}" --overlap 0:1e-6:3 -o no/such/folder/out.csv
answers 4 'cannot be written' "$platen" export table "${hertz[@]}" --overlap 1e-7:1e-6:3 -o no/such/folder/out.csv
answers 2 'is no law of its own overlap' "$platen" eval agarwal -p radius_m=1e-3 -p E_Pa=5e8 -p nu=0.3 -p sigma_y_Pa=1e6 \
  -p loading=die -p kind=secondary --overlap 0:1e-4:3
answers 2 '-p is for' "$platen" laws hertz -p E_Pa=1
answers 0 'the contact radius is ours, provisional' "$platen" laws wang

# --- compare ---
{ echo 'delta_m,force_N'; awk 'BEGIN { for (i = 1; i <= 40; ++i) printf "%g,%g\n", i * 1e-6, 0.17 * i }'; } >measured.csv
elastic=(-p E_Pa=1e9 -p nu=0.3 --radius_m 1e-3)
metal=("${elastic[@]}" -p sigma_y_Pa=1e7)
answers 0 '| 1 | mdr |' "$platen" compare measured.csv hertz mdr "${metal[@]}"
answers 0 'outside its validity' "$platen" compare measured.csv hertz "${elastic[@]}"
answers 0 '"law": "mdr/published"' "$platen" compare measured.csv mdr/published "${metal[@]}" --json
answers 0 'at 2: 20 of 30 points' "$platen" compare measured.csv thornton-ning,p_y_Pa=2e7,label='at 2' "${elastic[@]}" \
  --ranges 0.01,0.02 -o compare.svg --table table.md
has compare.svg
answers 0 'wang' "$platen" compare measured.csv wang --material wang-type-1 --radius_m 1e-3
answers 0 '0.01 < δ/R ≤ 0.02' cat table.md
answers 2 'needs a curve' "$platen" compare hertz mdr
answers 2 'needs a law' "$platen" compare measured.csv --radius_m 1e-3
answers 2 'none of the laws has this parameter' "$platen" compare measured.csv hertz "${elastic[@]}" -p k=1
answers 2 "there is no law or law card 'hertzz'" "$platen" compare measured.csv hertzz "${elastic[@]}"
answers 2 'is not a number above' "$platen" compare measured.csv hertz "${elastic[@]}" --ranges 0.1,0.01
answers 2 'ends in .svg or .png' "$platen" compare measured.csv hertz "${elastic[@]}" -o compare.pdf
answers 2 'there is no such file' "$platen" compare missing.csv hertz "${metal[@]}"

# --- a press that cannot go on: strength falls while stiffness rises with density ---
material 'zeta' 'zeta = -40' 'eta' 'eta = 60' 'xi' 'xi = 80' 'omega' 'omega = 60' 'Lambda_bar' 'Lambda_bar = 0.1'
answers 3 'stopped at delta_bar' "$platen" derive material.toml -o unable --elements 200
has unable/curve.csv
grep -qF '"complete": false' unable/summary.json || { failures=$((failures + 1)); echo 'FAILED: summary.json calls it complete'; }
has_not unable/law.toml

# --- units ---
printf 'platen = 1\nname = "u"\nmodel = "von-mises"\n[parameters]\nE = "2 GPa"\nsigma_y = "25 N/mm2"\nnu = 0.3\n' >unit.toml
answers 0 '2.5e7' "$platen" materials unit.toml
answers 0 '1e-5,0.51802' "$platen" eval hertz -p radius=1mm -p 'E=1 GPa' -p nu=0.3 --overlap 0:10um:3
answers 2 'has no unit' "$platen" eval hertz -p radius=1 -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-5:3
answers 2 'is a length; it must be a stress' "$platen" eval hertz -p radius=1mm -p E=1mm -p nu=0.3 --overlap 0:1e-5:3
answers 0 'inside' "$platen" predict --E '2 GPa' --nu 0.3 --sigma_y '20 MPa' -o unit-law.toml
answers 2 'are the same' "$platen" predict --E '2 GPa' --E_Pa 2e9 --nu 0.3 --sigma_y '20 MPa' -o unit-law.toml
answers 2 'is no number with a unit' "$platen" predict --E '2 Gpa' --nu 0.3 --sigma_y '20 MPa' -o unit-law.toml

# --- measurements ---
{
  printf '"Probendurchmesser";1,00;"mm"\r\n"Standardweg";"Standardkraft"\r\n"mm";"N"\r\n'
  "$platen" eval shahin -p radius_m=0.5e-3 -p E_Pa=3e8 -p nu=0.3 -p kappa_Pa=5e6 -p inverse_m=0.5 --against plane \
    --overlap 0:1e-4:60 2>/dev/null | awk -F, 'NR > 1 { printf "%.6f;%.6f\r\n", 2e3 * $1 + 0.02, $2 }' | tr . ,
} >raw.csv
answers 0 'd = 1 mm, 60 rows' "$platen" import raw.csv -o imported.csv
answers 0 'semicolons, decimal comma' "$platen" import raw.csv --json
answers 0 'd = 1 mm' "$platen" import raw.csv --picture raw.svg
grep -q 'nothing for the machine' raw.svg || { failures=$((failures + 1)); echo 'FAILED: raw.svg does not say the corrections'; }
answers 2 'ends in .svg or .png' "$platen" import raw.csv --picture raw.pdf
answers 2 'E_Pa is seen in unloading alone' "$platen" calibrate raw.csv --law shahin --nu 0.3
answers 2 'give it with --nu' "$platen" calibrate raw.csv --law shahin
answers 2 'leave one out' "$platen" import raw.csv --radius_m 2e-3
answers 2 "did you mean 'shahin'?" "$platen" calibrate raw.csv --law shain --nu 0.3
for file in raw.csv imported.csv; do
  answers 0 'contact at' "$platen" calibrate $file --law shahin --nu 0.3 --E_Pa 3e8 -o measured.toml
  grep -q '^kappa_Pa = 5e6$' measured.toml || { failures=$((failures + 1)); echo "FAILED: $(cat measured.toml)"; }
  grep -qF 'machine = "no compliance' measured.toml || { failures=$((failures + 1)); echo 'FAILED: no word of the machine'; }
done
answers 0 ',loading,' "$platen" eval measured.toml -p radius_m=1e-3 --overlap 1e-5:1e-4:3
answers 2 'stiff as an elastic sphere' "$platen" calibrate raw.csv --law shahin --nu 0.3 --E_Pa 3e6 -o doubted.toml
has_not doubted.toml
answers 0 'doubted:' "$platen" calibrate raw.csv --law shahin --nu 0.3 --E_Pa 3e6 -o doubted.toml --force
grep -q '^doubts = ' doubted.toml || { failures=$((failures + 1)); echo 'FAILED: the card has no doubts'; }
cat >bead.toml <<'END'
platen = 1
experiment = "simple"
radius_m = 0.5e-3
material = { platen = 1, name = "bead", model = "von-mises", parameters = { E_Pa = 2e9, sigma_y_Pa = 25e6, nu = 0.3 } }
[path]
delta_bar_max = 0.2
unload_from = [0.1, 0.2]
[mesh]
elements = 300
END
answers 0 'results in' "$platen" press bead.toml -o bead --as-measured beads.csv --particles 2 --seed 3
answers 0 '1 loop, 1 last unloading' "$platen" import beads.csv
cp beads.csv same.csv
answers 0 'results in' "$platen" press bead.toml -o bead --as-measured beads.csv --particles 2 --seed 3
cmp beads.csv same.csv || failures=$((failures + 1))
sed '/delta_bar_max/,/unload/d; s/"simple"/"die"/' bead.toml >bead-die.toml
answers 2 'is for experiment = "simple"' "$platen" press bead-die.toml -o bead --as-measured beads.csv
answers 0 'sigma_y_Pa' "$platen" calibrate beads.csv --material von-mises --nu 0.3 -o metal.toml --law-card metal-law.toml \
  --profiles profiles.svg --picture beads.svg
answers 0 'von-mises' "$platen" materials metal.toml
answers 0 ',loading,' "$platen" eval metal-law.toml -p radius_m=1e-3 --overlap 1e-5:1e-4:3
has profiles.svg
answers 0 '"value_deviance"' "$platen" calibrate beads.csv --model von-mises --nu 0.3 --profiles --json
answers 2 'nu is missing' "$platen" calibrate beads.csv --material von-mises
answers 0 'kappa_Pa' "$platen" calibrate raw.csv --law shahin --nu 0.3 --E '0.3 GPa' --confined confined.csv
grep -q '^die,' confined.csv || { failures=$((failures + 1)); echo 'FAILED: no die in confined.csv'; }
answers 2 'knows one loading only' "$platen" calibrate raw.csv --law hertz --nu 0.3 --confined confined.csv --force
printf 'E_Pa,sigma_y_Pa,what\n2e9,25e6,1\n2e9,1e3,2\n' >asked.csv
answers 0 'sigma_y_Pa' "$platen" calibrate beads.csv --material von-mises --nu 0.3 --ask asked.csv --tell told.csv
grep -q '^1000,2e9,inf,-inf,inf$' told.csv && [ "$(wc -l <told.csv)" -eq 3 ] || { failures=$((failures + 1)); cat told.csv; }
answers 2 "column sigma_y_Pa is missing" "$platen" calibrate beads.csv --material von-mises --nu 0.3 --ask beads.csv --tell told.csv
answers 2 '--tell is required' "$platen" calibrate beads.csv --material von-mises --nu 0.3 --ask asked.csv
answers 2 'nothing is left' "$platen" calibrate beads.csv --law hertz --nu 0.3 --E '2 GPa'
answers 2 '--material CARD' "$platen" calibrate beads.csv --material vmdc
answers 2 'give one of the two' "$platen" calibrate beads.csv --material von-mises --law hertz --nu 0.3
answers 2 '--press is for --material' "$platen" calibrate beads.csv --law hertz --nu 0.3 --press
answers 2 '--store is for --press' "$platen" calibrate beads.csv --material von-mises --nu 0.3 --store kept
answers 2 '--press calibrates through presses' "$platen" calibrate beads.csv --material lead-hollomon
printf 'rho_r,axial_stress_MPa,radial_stress_MPa\n0.5,1,0.4\n0.6,2,0.8\n' >die.csv
printf 'rho_r,compressive_strength_MPa,tensile_strength_MPa\n0.5,1,0.2\n0.7,3,0.5\n' >tablets.csv
answers 2 'fewer than 8 rows load' "$platen" compaction die.csv --strengths tablets.csv --rho_r0 0.5
answers 2 'there is no column compressive_strength' "$platen" compaction die.csv --strengths die.csv --rho_r0 0.5
answers 2 '--rho_r0 must be in' "$platen" compaction die.csv --strengths tablets.csv --rho_r0 50
answers 2 'is no relative density' "$platen" compaction <(printf 'rho_r,axial_stress_MPa,radial_stress_MPa\n50,1,1\n') --strengths tablets.csv --rho_r0 0.5
answers 2 'it is travel' "$platen" fit imported.csv --law edmans-sinka --displacement-is delta
answers 0 'relative L2' "$platen" fit raw.csv --law edmans-sinka
awk 'BEGIN { print "delta_m,force_N"; for (i = 0; i <= 50; ++i) print i * 1e-5 "," i * 1e-1 }' >unit.csv
answers 2 'with mm instead of m' "$platen" fit unit.csv --radius_m 1e-6 --law edmans-sinka
answers 0 'doubted:' "$platen" fit unit.csv --radius_m 1e-6 --law edmans-sinka --force
printf '\211PNG\r\n' >picture.csv
answers 2 'a picture (PNG)' "$platen" import picture.csv
answers 2 'there is no such file' "$platen" calibrate no-such.csv --law hertz --nu 0.3
printf '*MATERIAL, NAME=M\n*ELASTIC\n2000, 0.3\n*PLASTIC\n20, 0\n*DEPVAR\n1\n' >deck.inp
answers 2 'give them with --units' "$platen" convert deck.inp
answers 2 'platen convert deck.inp' "$platen" press deck.inp -o out
answers 0 '*DEPVAR' "$platen" convert deck.inp --units mm-tonne-MPa -o deck.toml
answers 0 'von-mises' "$platen" materials deck.toml
answers 0 '*Plastic' "$platen" convert deck.toml --units si
answers 2 'no von Mises Double Cap' "$platen" convert base-case --units si
answers 0 'kind = "hollomon"' "$platen" convert lead-ludwik --hardening hollomon --strain 0:1.5
answers 0 'stress off by' "$platen" convert lead-hollomon --hardening ludwik -o ludwik.toml
answers 0 'hardening.K_Pa' "$platen" materials ludwik.toml
answers 2 'hardening is of von-mises, this is vmdc' "$platen" convert base-case --hardening table
answers 2 "did you mean 'ludwik'?" "$platen" convert lead-hollomon --hardening ludwick
answers 2 'no hollomon law follows this stress' "$platen" convert von-mises-100 --hardening hollomon
answers 2 '--strain 0.5 is not of the form FROM:TO' "$platen" convert lead-hollomon --hardening ludwik --strain 0.5
answers 2 '--strain requires --hardening' "$platen" convert lead-ludwik --strain 0:0.5 --units si
answers 2 '--rho_r0 is of an Abaqus input file' "$platen" convert lead-ludwik --units si --rho_r0 0.3
answers 2 '--material is of an Abaqus input file' "$platen" convert lead-hollomon --hardening ludwik --material lead
answers 2 '--units excludes --hardening' "$platen" convert lead-hollomon --hardening ludwik --units si
answers 2 'they must ascend' "$platen" convert lead-hollomon --hardening ludwik --strain 1:0.5
answers 2 "did you mean 'lead-hollomon'?" "$platen" convert led-hollomon --hardening ludwik

# misspelt commands and options, streams, quiet, what shells and man read
answers 2 "there is no command 'platen pres'; did you mean 'press'?" "$platen" pres
answers 2 "there is no command 'platen study ru'; did you mean 'run'?" "$platen" study ru
answers 2 'platen study needs one of: design' "$platen" study
answers 2 'platen predict has no option --lw; did you mean --law?' "$platen" predict mcc-ph-200 --lw pressed
answers 2 'platen export lammps has no option --radios; did you mean --radius?' "$platen" export lammps hertz.toml --radios=1
answers 2 'there is no completion for' "$platen" completion csh
same() { cmp -s "$1" "$2" || { failures=$((failures + 1)); echo "FAILED: $1 is not $2"; }; }
"$platen" predict mcc-ph-200 -o predicted.toml --quiet >/dev/null 2>noise
"$platen" predict mcc-ph-200 -o - --quiet >piped.toml 2>noise2
same predicted.toml piped.toml
[ ! -s noise ] || { failures=$((failures + 1)); echo "FAILED: --quiet says $(cat noise)"; }
"$platen" eval predicted.toml -p radius_m=1e-3 --overlap 0:1e-5:3 >named
"$platen" eval - -p radius_m=1e-3 --overlap 0:1e-5:3 <predicted.toml >piped
same named piped
answers 2 'wrong_Pa' "$platen" --quiet eval hertz -p wrong_Pa=1 --overlap 1
"$platen" completion bash >complete.sh && completed=$(bash -c '. ./complete.sh; COMP_WORDS=(platen study ru); COMP_CWORD=2; _platen
  echo "${COMPREPLY[*]}"; COMP_WORDS=(platen predict mcc --la); COMP_CWORD=3; _platen; echo "${COMPREPLY[*]}"')
[ "$completed" = $'run\n--law' ] || { failures=$((failures + 1)); echo "FAILED: bash completes $completed"; }
answers 0 'bashcompinit' "$platen" completion zsh
answers 0 "complete -c platen -n '__fish_seen_subcommand_from study' -a run" "$platen" completion fish
"$platen" manual >platen.1
[ "$(sed -n '/^.SH EXIT STATUS/,/^.SH ENV/p' platen.1 | grep -xE '[0-9]+' | xargs)" = '0 1 2 3 4 130' ] ||
  { failures=$((failures + 1)); echo 'FAILED: the exit codes of the manual'; }
for command in $("$platen" | awk '/^  platen/ { print $2 }'); do
  grep -q "^\.SS platen $command" platen.1 || { failures=$((failures + 1)); echo "FAILED: the manual lacks $command"; }
done

find . -name '.*.*' -type f | grep -q . && { failures=$((failures + 1)); echo 'FAILED: temporary files were left'; }

[ $failures -eq 0 ] && echo 'all answers as wanted'
exit $((failures > 0))
