#!/bin/bash
# misfortune.sh PROGRAM: a press that is stopped, a disk that fills, two runs into one folder: what was computed is
# kept and can be read, and the message says what to do.
set -u
platen=$1
folder=$(mktemp -d)
trap 'umount "$folder/small" 2>/dev/null; rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0

fails() {
  failures=$((failures + 1))
  echo "FAILED: $*"
}

# ends CODE TEXT STATUS: the exit code, and a text in the file `answer`
ends() {
  [ "$3" -eq "$1" ] && grep -qF -- "$2" answer || {
    fails "wanted exit $1 and the text: $2"
    echo "  got exit $3 and:"
    sed 's/^/    /' answer
  }
}

waits_for() { # TEXT: until the file `answer` has it
  local i
  for i in $(seq 600); do
    grep -qF -- "$1" answer && return
    sleep 0.1
  done
  fails "no '$1' within a minute: $(cat answer)"
}

printf '%s\n' 'platen = 1' 'experiment = "simple"' 'material = "base-case"' 'radius_m = 1e-3' '[mesh]' \
  'elements = 2000' '[output]' 'fields_at = [0.02, 0.5]' >long.toml
printf '%s\n' 'platen = 1' 'experiment = "simple"' 'material = "von-mises-100"' 'radius_m = 1e-3' '[path]' \
  'delta_bar_max = 0.02' '[mesh]' 'elements = 200' '[output]' 'fields_at = [0.01, 0.02]' >short.toml

# --- stopped: Ctrl-C, and what a queue sends ---
for signal in INT TERM; do
  : >answer
  "$platen" press long.toml -o stopped-$signal >answer 2>&1 &
  press=$!
  waits_for '10 %'
  kill -$signal $press
  wait $press
  ends 130 "stopped as asked; the curve up to delta_bar" $?
  grep -qF '"interrupted": true' stopped-$signal/summary.json || fails "$signal: summary.json does not say so"
  [ -s stopped-$signal/fields-0.02.vtu ] || fails "$signal: the fields passed by then are missing"
  "$platen" fit stopped-$signal/curve.csv --law edmans-sinka >answer 2>&1
  ends 0 'relative L2' $?
done

# --- a calibration through presses that is stopped: the presses are kept, and the same command goes on ---
printf '%s\n' 'platen = 1' 'experiment = "simple"' 'material = "von-mises-100"' 'radius_m = 1e-3' '[path]' \
  'delta_bar_max = 0.05' 'unload_from = [0.02, 0.05]' '[mesh]' 'elements = 300' >bead.toml
"$platen" press bead.toml -o bead --as-measured beads.csv --particles 2 --seed 3 >answer 2>&1
ends 0 'results in bead' $?
calibrate=("$platen" calibrate beads.csv --material von-mises --nu 0.3 --press --store pressed)
runs() { find pressed/runs -mindepth 1 -maxdepth 1 -name '[0-9a-f]*' 2>/dev/null | sort; }
: >answer
"${calibrate[@]}" -o bead-metal.toml >answer 2>&1 &
calibration=$!
for i in $(seq 6000); do
  [ -n "$(runs)" ] && break
  sleep 0.05
done
kill -INT $calibration
wait $calibration
ends 130 'the finished runs are in pressed, and the same command goes on' $?
[ -e bead-metal.toml ] && fails 'a card was written of a calibration that was stopped'
runs >kept
[ -s kept ] || fails 'no press was kept'
"${calibrate[@]}" -o bead-metal.toml >answer 2>&1
ends 0 'from the store' $?
[ "$(grep -c 'from the store' answer)" -eq "$(wc -l <kept)" ] || fails "of $(wc -l <kept) presses others were taken: $(cat answer)"
"${calibrate[@]}" -o again.toml >answer 2>&1
ends 0 'from the store' $?
grep -E '^press .*elements\)$' answer && fails 'something was pressed twice'
cmp bead-metal.toml again.toml || fails 'the same presses gave another card'

# --- two runs into one folder ---
: >answer
"$platen" press long.toml -o shared >answer 2>&1 &
press=$!
waits_for '10 %'
"$platen" press short.toml -o shared >second 2>&1
second=$?
kill -INT $press
wait $press
mv second answer
ends 4 'another run is writing into this folder; name another with -o, or wait' $second
"$platen" press short.toml -o shared >answer 2>&1 # the lock went with its run
ends 0 'results in shared' $?
[ -e shared/fields-0.01.vtu ] && [ ! -e shared/fields-0.5.vtu ] || fails 'fields of two runs are mixed'

# --- no room ---
(ulimit -f 8 && exec "$platen" press short.toml -o limited) >answer 2>&1 # 8 kB a file
ends 4 'curve.csv: cannot be written: File too large; free some space' $?
mkdir small
if mount -t tmpfs -o size=64k tmpfs small 2>/dev/null; then
  "$platen" press short.toml -o small/out >answer 2>&1
  ends 4 'No space left on device; free some space, or name another place' $?
  [ -e small/out/summary.json ] && fails 'a summary.json says that all is there'
  "$platen" fit small/out/curve.csv --law edmans-sinka >answer 2>&1
  ends 0 'relative L2' $?
else
  echo 'not tried: a full disk, since nothing can be mounted here'
fi
if [ -e /dev/full ]; then
  "$platen" laws 2>answer >/dev/full
  ends 4 'the output could not be written' $?
  "$platen" eval hertz -p radius_m=1e-3 -p E_Pa=1e9 -p nu=0.3 --overlap 0:1e-6:10000 2>answer >/dev/full
  ends 4 'the output could not be written' $?
  "$platen" press short.toml -o quiet >answer 2>/dev/full # nobody listens to the progress
  ends 0 'results in quiet' $?
fi
find . -name '.*.*' -type f | grep -q . && fails "temporary files were left: $(find . -name '.*.*' -type f)"

[ $failures -eq 0 ] && echo 'all as wanted'
exit $((failures > 0))
