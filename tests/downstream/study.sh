#!/bin/bash
# study.sh PROGRAM: a study that is killed and resumed gives what an undisturbed one gives; two programs on one store; a
# full disk, a store that cannot be written, claims of the dead; stores are merged; runs of another study or engine,
# unknown factors and studies that cannot be pressed are refused.
set -u
platen=$(realpath "$1")
export OPENBLAS_NUM_THREADS=1
memory=/dev/shm # where fsync costs nothing
[ -w $memory ] || memory=${TMPDIR:-/tmp}
folder=$(mktemp -d -p $memory)
trap 'umount "$folder/small" 2>/dev/null; rm -rf "$folder"' EXIT
chmod 755 "$folder"
cd "$folder" || exit 1
failures=0
fails() { failures=$((failures + 1)); echo "FAILED: $*"; }
refuses() { # CODE TEXT COMMAND...
  local code=$1 text=$2 status
  shift 2
  "$@" >answer 2>&1
  status=$?
  [ $status -eq "$code" ] && grep -qF -- "$text" answer || { fails "wanted exit $code and: $text; got $status"; cat answer; }
}
untimed() { sed 's/,[^,]*,[^,]*$//' "$1"; } # cpu_s and wall_s are the last columns
exported() { "$platen" study export study.toml --store "$1" -o "$1.csv" --curves "$1-curves.csv" || fails "export of $1"; }
same() { # STORE: gives the tables of the undisturbed one, and has nothing lying about
  exported "$1"
  cmp <(untimed whole.csv) <(untimed "$1.csv") && cmp whole-curves.csv "$1-curves.csv" || fails "$1 differs from undisturbed"
  [ -z "$(ls "$1/claims")" ] || fails "$1: claims were left behind"
  [ -z "$(ls -A "$1/runs" | grep '^\.')" ] || fails "$1: unfinished runs were left behind"
}

cat >study.toml <<'T'
platen = 1
name = "small"
[case]
platen = 1
experiment = "simple"
material = "base-case"
radius_m = 1e-3
[case.path]
delta_bar_max = 0.01
unload_from = [0.01]
[case.mesh]
elements = 32
[design]
kind = "factorial"
[factors]
"material.E_bar" = { values = [50, 100, 150, 200] }
"material.Gamma_bar" = { values = [0.5, 1] }
[fit]
laws = ["edmans-sinka"]
T

"$platen" study run study.toml --store whole --workers 2 >/dev/null 2>&1 || { echo "FAILED: an undisturbed study does not end well"; exit 1; }
exported whole
[ "$(grep -c ',done,' whole.csv)" = 8 ] || fails "not all 8 runs are done"

# --- killed ten times, at random moments while runs are being pressed ---
progress=0
for _ in $(seq 10); do
  setsid "$platen" study run study.toml --store killed --workers 2 >/dev/null 2>&1 &
  victim=$!
  while [ -z "$(ls killed/claims 2>/dev/null)" ] && kill -0 $victim 2>/dev/null; do sleep 0.002; done
  sleep "0.0$(printf '%02d' $((RANDOM % 50)))"
  kill -KILL -- "-$victim" 2>/dev/null && [ "$(ls killed/runs 2>/dev/null | wc -l)" -lt 8 ] && progress=$((progress + 1))
  wait "$victim" 2>/dev/null
done
[ $progress -gt 0 ] || fails "no kill came before the end: the test tests nothing"
mkdir -p killed/runs killed/claims # where the kill was that early
mkdir killed/runs/.0123-999 # what a kill in the midst of writing leaves
"$platen" study run study.toml --store killed --workers 2 >/dev/null 2>&1 || fails "a killed study does not resume"
same killed

# --- only the program is killed: its workers end as well ---
"$platen" study run study.toml --store orphans --workers 2 >/dev/null 2>&1 &
victim=$!
for _ in $(seq 100); do [ -n "$(ls orphans/claims 2>/dev/null)" ] && break; sleep 0.02; done
kill -KILL $victim
wait $victim 2>/dev/null
for _ in $(seq 100); do
  left=$(ls orphans/runs | wc -l)
  sleep 0.3
  [ "$(ls orphans/runs | wc -l)" -eq "$left" ] && break
done
[ "$left" -lt 8 ] || fails "the workers of a killed program pressed on"

# --- two programs on one store: each run is pressed once, and both see it through ---
"$platen" study run study.toml --store shared --workers 1 >first 2>&1 &
one=$!
"$platen" study run study.toml --store shared --workers 2 >second 2>&1 || fails "the second program on a store"
wait $one || fails "the first program on a store"
grep -q '^8 runs: 8 done, 0 failed, 0 left' first || fails "the first program ended before all runs were there: $(cat first)"
same shared

# --- nothing is computed twice: what is there keeps its time ---
before=$(ls -l --time-style=full-iso whole/runs)
"$platen" study run study.toml --store whole >/dev/null 2>&1
[ "$before" = "$(ls -l --time-style=full-iso whole/runs)" ] || fails "a finished study pressed again"

# --- a live worker's claim is waited for; when it dies, the run is taken over ---
cp -r whole claimed
key=$(ls claimed/runs | head -1)
rm -r "claimed/runs/$key"
sleep 1000 &
worker=$!
table=$(cat /proc/sys/kernel/random/boot_id)/$(readlink /proc/self/ns/pid)
echo "0000000000 0123 $table $worker $(cut -d' ' -f22 /proc/$worker/stat)" >"claimed/claims/$key"
"$platen" study run study.toml --store claimed --workers 1 >answer 2>&1 &
waiting=$!
sleep 1
kill -0 $waiting || fails "a program ended while another had still claimed a run"
[ -d "claimed/runs/$key" ] && fails "a run that another process has claimed was pressed"
"$platen" study status study.toml --store claimed | grep -q '^1 being pressed' || fails "status does not count the claim"
kill $worker
wait $worker 2>/dev/null
wait $waiting || fails "the run of a dead worker"
[ -d "claimed/runs/$key" ] || fails "the claim of a dead worker was not taken over"
same claimed

# --- a disk that fills: by the limit on the size of files, and a small file system where one can be mounted ---
(ulimit -f 8; "$platen" study run study.toml --store full --workers 1 >answer 2>&1)
[ $? -eq 4 ] && grep -q 'cannot be written' answer || fails "a file that may not grow: $(cat answer)"
[ -z "$(ls full/runs)" ] || fails "a run was kept that could not be written"
"$platen" study run study.toml --store full --workers 2 >/dev/null 2>&1 || fails "a study does not go on after a full disk"
same full
mkdir small
if mount -t tmpfs -o size=96k tmpfs small 2>/dev/null; then
  refuses 4 "No space left on device; free some space" "$platen" study run study.toml --store small/store --workers 2
  "$platen" study status study.toml --store small/store | grep -q ' 0 failed' || fails "the store on a full disk cannot be read"
  mount -o remount,size=8m small
  "$platen" study run study.toml --store small/store --workers 2 >/dev/null 2>&1 || fails "a study does not go on after there is room"
  cp -r small/store roomy
  same roomy
  # --- a store that cannot be written is refused, and read ---
  mount -o remount,ro small
  refuses 4 "small/store: the output folder cannot be written (Read-only file system); name another with --store" \
    "$platen" study run study.toml --store small/store
  "$platen" study status study.toml --store small/store | grep -q '^8 runs: 8 done' || fails "a read-only store cannot be read"
  "$platen" study export study.toml --store small/store -o read.csv || fails "a read-only store cannot be exported"
else
  echo "study: no file system can be mounted here: full and read-only disks were tried by the limit on files alone"
fi

# --- merging halves, in either order, twice ---
for half in a b; do cp -r whole $half; done
for key in $(ls whole/runs | head -4); do rm -r "a/runs/$key"; done
for key in $(ls whole/runs | tail -4); do rm -r "b/runs/$key"; done
for order in "a b" "b a"; do
  rm -rf both
  # shellcheck disable=SC2086
  "$platen" study merge study.toml --store both --from $order >/dev/null || fails "merge $order"
  "$platen" study merge study.toml --store both --from $order | grep -q '^0 runs' || fails "merge is not idempotent"
  "$platen" study export study.toml --store both -o both.csv
  cmp whole.csv both.csv || fails "merged differs from whole"
done

# --- SQLite has what the CSV has ---
"$platen" study export study.toml --store whole -o whole.sqlite || fails "export to SQLite"
[ "$(head -c 15 whole.sqlite)" = "SQLite format 3" ] || fails "whole.sqlite is no database"
if python3 -c 'import sqlite3' 2>/dev/null; then
  python3 - <<'P' || fails "the database does not say what the CSV says"
import csv, sqlite3
rows = list(csv.DictReader(line for line in open("whole.csv") if not line.startswith("#")))
base = sqlite3.connect("whole.sqlite")
base.row_factory = sqlite3.Row
for kept, row in zip(base.execute("select * from runs order by run"), rows, strict=True):
    for name, cell in row.items():
        assert (float(cell) if isinstance(kept[name], (int, float)) else cell) == kept[name], (name, cell, kept[name])
curves = [line for line in open("whole-curves.csv") if not line.startswith("#")]
assert base.execute("select count(*) from curves").fetchone()[0] == len(curves) - 1
P
fi

# --- a pool of it, checked; and one with a number that is wrong ---
mkdir pool
cp study.toml pool
cp whole.csv pool/runs.csv
cp whole-curves.csv pool/curves.csv
"$platen" study check pool --share 0.3 >answer 2>&1 && [ "$(grep -c 'as before' answer)" = 3 ] || fails "a pool is not as before: $(cat answer)"
"$platen" study check pool --cheapest --until 0.005 >answer 2>&1 && [ "$(grep -c 'as before' answer)" = 2 ] || fails "the start of a pool: $(cat answer)"
sed -i -E 's/^([0-9]+,0,loading,0.0025),([^,]*)/\1,0.9/' pool/curves.csv
refuses 2 "2 of 2 runs differ from the pool" "$platen" study check pool --cheapest --until 0.005
sed 's/50, 100/51, 100/' study.toml >pool/study.toml
refuses 2 "the key is not that of run 1" "$platen" study check pool --cheapest

# --- three loadings of one table, in space as well; the walls of the die have columns of their own ---
cat >loadings.toml <<'T'
platen = 1
name = "loadings"
[case]
platen = 1
experiment = "simple"
material = "von-mises-100"
radius_m = 1e-2
[case.path]
delta_bar_max = 0.004
[case.mesh]
elements = 200
[design]
kind = "table"
file = "shahin-table-a1.csv"
only = { row = "1" }
[factors]
experiment = { column = "loading", names = { simple = "simple", die = "die", hydro = "hydrostatic" } }
"material.E_Pa" = { column = "E_MPa" }
"material.nu" = { column = "nu" }
"material.sigma_y_Pa" = { column = "sigma_y_MPa" }
T
"$platen" study run loadings.toml --store loadings --workers 2 >answer 2>&1 || fails "a study of three loadings: $(cat answer)"
"$platen" study export loadings.toml --store loadings -o runs.csv --curves curves.csv --step 0.001 || fails "its export"
grep -q ',hydrostatic,2958140000,0.2099,26390000,done,' runs.csv || fails "runs of three loadings: $(cat runs.csv)"
grep -q '^2,0,loading,0.004,[^,]*,[^,]*,[^,]*,[^,]\+$' curves.csv && grep -q '^3,0,loading,0.004,[^,]*,[^,]*,,$' curves.csv ||
  fails "curves of three loadings: $(cat curves.csv)"

# --- laws of large deformation: known, and refused where a curve is too short for them ---
{ cat loadings.toml && printf '[fit]\nlaws = ["agarwal"]\n'; } >fitted.toml
refuses 2 'a fit of agarwal needs at least' "$platen" study export fitted.toml --store loadings -o fitted.csv
[ ! -e fitted.csv ] || fails "a refused export wrote a file"
{ cat loadings.toml && printf '[fit]\nlaws = ["hertz"]\n'; } >unknown.toml
refuses 2 'known are: edmans-sinka, agarwal, shahin' "$platen" study export unknown.toml --store loadings

# --- another study, another engine ---
sed 's/small/other/' study.toml >other.toml
refuses 2 "not of 'other'" "$platen" study run other.toml --store whole
refuses 2 "not of 'other'" "$platen" study merge other.toml --store third --from whole
refuses 2 "is no run store" "$platen" study merge study.toml --store third --from pool
cp -r whole older
echo "1 small" >older/study.txt
for run in older/runs/*; do # the keys that engine 1 would have given
  sed -i 's/^engine = .*/engine = 1/' "$run/identity.txt"
  rm "$run/sums.txt" # which engine 1 did not write
  mv "$run" "older/runs/$(sha256sum <"$run/identity.txt" | head -c 32)"
done
mkdir older-pool && cp study.toml older-pool
"$platen" study export study.toml --store older -o older-pool/runs.csv --curves older-pool/curves.csv
"$platen" study check older-pool --cheapest --until 0.005 >answer 2>&1 &&
  grep -q 'pressed by engine 1, this is .* within 0.03' answer || fails "the pool of another engine: $(cat answer)"
sed -i -E 's/^([0-9]+,0,loading,0.0025),([^,]*)/\1,0.9/' older-pool/curves.csv
refuses 2 "differ from the pool by more than 0.03" "$platen" study check older-pool --cheapest --until 0.005
refuses 2 "give --keep to count the old runs" "$platen" study run study.toml --store older
refuses 2 "has runs of engine 1" "$platen" study merge study.toml --store third --from older
[ -e third ] && fails "a refused merge left a store behind"
"$platen" study merge study.toml --store third --from older --keep | grep -q '^8 runs' || fails "merge --keep"
"$platen" study status study.toml --store third | grep -q '^8 runs: 8 done' || fails "merged runs of another engine do not count"
"$platen" study status study.toml --store older | grep -q '^8 runs: 8 done' || fails "the runs of another engine cannot be looked at"
rm -r "$(ls -d older/runs/* | head -1)"
cp -r older again
"$platen" study run study.toml --store older --keep >/dev/null 2>&1 && [ "$(ls older/runs | wc -l)" = 8 ] || fails "--keep"
"$platen" study run study.toml --store older >/dev/null 2>&1 && [ "$(ls older/runs | wc -l)" = 8 ] || fails "--keep is not remembered"
"$platen" study export study.toml --store older -o older.csv && grep -q '^# engine = [0-9]* 1$' older.csv || fails "two engines are not named"
"$platen" study run study.toml --store again --recompute >/dev/null 2>&1 && [ "$(ls again/runs | wc -l)" = 15 ] || fails "--recompute"
same again

# --- a press that fails is kept with its reason, and a study where all fail says so ---
cat >weak-case.toml <<'T'
platen = 1
experiment = "simple"
material = { platen = 1, name = "weak", model = "drucker-prager", parameters = { E_Pa = 1e10, nu = 0.15, phi_deg = 60, sigma_c_Pa = 1 } }
radius_m = 1e-3
[path]
delta_bar_max = 0.005
T
cat >weak.toml <<'T'
platen = 1
name = "weak"
case = "weak-case.toml"
[design]
kind = "factorial"
[factors]
"material.sigma_c_Pa" = { values = [1, 1e6] }
"mesh.elements" = { values = [32] }
T
"$platen" study run weak.toml --store weak >answer 2>&1 && grep -q 'note: 1 of 2 presses failed' answer || fails "a study with a failure: $(cat answer)"
"$platen" study status weak.toml --store weak | grep -q '^failed .*: stopped at delta_bar' || fails "status does not say why"
before=$(ls -l --time-style=full-iso weak/runs)
"$platen" study run weak.toml --store weak >/dev/null 2>&1
[ "$before" = "$(ls -l --time-style=full-iso weak/runs)" ] || fails "a failed press was pressed again unasked"
"$platen" study run weak.toml --store weak --retry-failed >/dev/null 2>&1
[ "$before" = "$(ls -l --time-style=full-iso weak/runs)" ] && fails "--retry-failed presses nothing"
sed 's/, 1e6//' weak.toml >hopeless.toml
refuses 3 "every press of the study failed, the first with: stopped at delta_bar" "$platen" study run hopeless.toml --store hopeless

# --- bad cards ---
sed 's/Gamma_bar/Gama_bar/' study.toml >wrong.toml
refuses 2 "Gama_bar" "$platen" study status wrong.toml
sed 's/\[50, 100, 150, 200\]/[]/' study.toml >empty.toml
refuses 2 "design is empty" "$platen" study status empty.toml
sed 's/100, 150/100.5, 150/; s/material.E_bar/mesh.elements/' study.toml >wrong.toml
refuses 2 "it must be a whole number" "$platen" study status wrong.toml
sed 's/factorial/factoral/' study.toml >wrong.toml
refuses 2 "did you mean 'factorial'" "$platen" study status wrong.toml
[ $failures -eq 0 ] && echo "study: all well"
exit $((failures > 0))
