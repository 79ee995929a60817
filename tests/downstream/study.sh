#!/bin/bash
# study.sh PROGRAM: a study that is killed and resumed gives what an undisturbed one gives; stores are merged; runs of
# another study or engine, and unknown factors, are refused.
set -u
platen=$1
export OPENBLAS_NUM_THREADS=1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
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

cat >study.toml <<'T'
platen = 1
name = "small"
[case]
platen = 1
experiment = "simple"
material = "base-case"
radius_m = 1e-3
[case.path]
delta_bar_max = 0.05
unload_from = [0.05]
[case.mesh]
elements = 100
[design]
kind = "factorial"
[factors]
"material.E_bar" = { values = [50, 100, 150, 200] }
"material.Gamma_bar" = { values = [0.5, 0.75, 1] }
[fit]
laws = ["edmans-sinka"]
T

"$platen" study run study.toml --store whole --workers 2 >/dev/null 2>&1 || fails "an undisturbed study does not end well"
"$platen" study export study.toml --store whole -o whole.csv || fails "export"
[ "$(grep -c ',done,' whole.csv)" = 12 ] || fails "not all 12 runs are done"

for i in $(seq 10); do # one worker process group, killed after up to 0.3 s
  setsid "$platen" study run study.toml --store killed --workers 2 >/dev/null 2>&1 &
  victim=$!
  sleep "0.$((RANDOM % 3))$((RANDOM % 10))"
  kill -KILL -- "-$victim" 2>/dev/null
  wait "$victim" 2>/dev/null
done
"$platen" study run study.toml --store killed --workers 2 >/dev/null 2>&1 || fails "a killed study does not resume"
"$platen" study export study.toml --store killed -o killed.csv
cmp <(untimed whole.csv) <(untimed killed.csv) || fails "killed and resumed differs from undisturbed"
[ -z "$(ls killed/claims | grep -v '^\.')" ] || fails "claims were left behind"

# Nothing is computed twice: what is there keeps its time.
before=$(ls -l --time-style=full-iso whole/runs)
"$platen" study run study.toml --store whole >/dev/null 2>&1
[ "$before" = "$(ls -l --time-style=full-iso whole/runs)" ] || fails "a finished study pressed again"

# A claim of a live process is respected, that of a dead host is not.
cp -r whole claimed
key=$(ls claimed/runs | head -1)
rm -r "claimed/runs/$key"
echo "$(hostname) $$ $(cut -d' ' -f22 /proc/$$/stat)" >"claimed/claims/$key"
"$platen" study run study.toml --store claimed >/dev/null 2>&1
[ -d "claimed/runs/$key" ] && fails "a run that another process has claimed was pressed"
echo "another-host 1 1" >"claimed/claims/$key"
touch -d '1 hour ago' "claimed/claims/$key"
"$platen" study run study.toml --store claimed >/dev/null 2>&1
[ -d "claimed/runs/$key" ] || fails "the claim of a dead host was not taken over"

# Merging halves, in either order, twice.
for half in a b; do cp -r whole $half; done
for key in $(ls whole/runs | head -6); do rm -r "a/runs/$key"; done
for key in $(ls whole/runs | tail -6); do rm -r "b/runs/$key"; done
for order in "a b" "b a"; do
  rm -rf both
  # shellcheck disable=SC2086
  "$platen" study merge study.toml --store both --from $order >/dev/null || fails "merge $order"
  "$platen" study merge study.toml --store both --from $order | grep -q '^0 runs' || fails "merge is not idempotent"
  "$platen" study export study.toml --store both -o both.csv
  cmp whole.csv both.csv || fails "merged differs from whole"
done

sed 's/small/other/' study.toml >other.toml
refuses 2 "not of 'other'" "$platen" study run other.toml --store whole
echo "1 small" >killed/study.txt
refuses 2 "--recompute" "$platen" study run study.toml --store killed
sed 's/Gamma_bar/Gama_bar/' study.toml >wrong.toml
refuses 2 "Gama_bar" "$platen" study status wrong.toml
sed 's/\[50, 100, 150, 200\]/[]/' study.toml >empty.toml
refuses 2 "design is empty" "$platen" study status empty.toml
[ $failures -eq 0 ] && echo "study: all well"
exit $((failures > 0))
