#!/bin/bash
# store.sh PROGRAM WORKER MISFORTUNE quick|slow: what a store must stand, with workers whose press computes nothing: killed at
# random moments, 256 of them, in other name spaces of processes, with another clock, without locks and links, on disks
# that fail at any write; damaged and foreign runs; 100,000 runs.
set -u
. "$(dirname "$0")/study.sh"
platen=$(realpath "$1") worker=$(realpath "$2") misfortune=$(realpath "$3") extent=$4
memory=/dev/shm # where fsync costs nothing
[ -w $memory ] || memory=${TMPDIR:-/tmp}
folder=$(mktemp -d -p $memory)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0
fails() { failures=$((failures + 1)); echo "FAILED: $*"; }
status() { "$platen" study status study.toml --store "$1"; }
exported() { "$platen" study export study.toml --store "$1" -o "$1.csv" --curves "$1-curves.csv" || fails "export of $1"; }
same() { # STORE: gives the tables of the undisturbed one, and has nothing lying about
  exported "$1"
  cmp <(untimed whole.csv) <(untimed "$1.csv") && cmp whole-curves.csv "$1-curves.csv" || fails "$1 differs from undisturbed"
  [ -z "$(ls "$1/claims")" ] || fails "$1: claims were left behind: $(ls "$1/claims")"
  [ -z "$(find "$1/runs" -maxdepth 1 -name '.*')" ] || fails "$1: unfinished runs were left behind"
}
each_once() { # LOG RUNS: as many presses as runs, none of them twice
  [ "$(wc -l <"$1")" -eq "$2" ] && [ -z "$(cut -d' ' -f1 "$1" | sort | uniq -d)" ] ||
    fails "$1: $(wc -l <"$1") presses of $2 runs, twice: $(cut -d' ' -f1 "$1" | sort | uniq -d | wc -l)"
}
study 10 6 1 >study.toml
"$worker" study.toml whole 2 0 log || { echo "FAILED: an undisturbed study"; exit 1; }
each_once log 60
exported whole
[ "$(grep -c ',done,' whole.csv)" = 60 ] || fails "not all runs are done"
(cd whole/runs && for key in *; do (cd "$key" && sha256sum --quiet -c sums.txt) || fails "sums.txt of $key"; done)

# --- killed a hundred times at random moments ---
kills=0 removed=0
for _ in $(seq 100); do
  if [ "$(ls killed/runs 2>/dev/null | wc -l)" -gt 40 ]; then # there must be work left at the next kill
    mapfile -t some < <(ls killed/runs | shuf -n 40)
    rm -r "${some[@]/#/killed/runs/}"
    removed=$((removed + 40))
  fi
  setsid "$worker" study.toml killed 4 10 killed.log >/dev/null 2>&1 &
  victim=$!
  disown
  sleep "0.0$(printf '%02d' $((10 + RANDOM % 35)))"
  kill -KILL -- "-$victim" 2>/dev/null && [ "$(ls killed/runs 2>/dev/null | wc -l)" -lt 60 ] && kills=$((kills + 1))
  while kill -0 "$victim" 2>/dev/null; do sleep 0.001; done
done
[ $kills -gt 80 ] || fails "only $kills of 100 kills came before the end"
sleep 0.2 # until the last of them are gone
mkdir -p killed/runs
mkdir "killed/runs/.0123-999" # what a kill in the midst of writing leaves
# a claim that a kill left half-written says nothing of its owner: its silence must tell
"$worker" study.toml killed 2 0 killed.log 20 2000 || fails "a killed study does not resume"
same killed
[ "$(wc -l <killed.log)" -le $((60 + removed + 4 * 100)) ] || fails "more presses than runs and kills"

# --- many workers; one program an hour ahead; one in another name space of processes ---
"$worker" study.toml early 2 5 crowd.log &
LD_PRELOAD=$misfortune MISFORTUNE_CLOCK=3600 "$worker" study.toml early 2 5 crowd.log &
apart=()
unshare --pid --fork --mount-proc true 2>/dev/null && apart=(unshare --pid --fork --mount-proc)
"${apart[@]}" "$worker" study.toml early 2 5 crowd.log &
wait
each_once crowd.log 60
same early

# --- who cannot look up a process sees by its standing count that it is dead, and waits while it counts ---
if [ ${#apart[@]} -gt 0 ]; then
  "${apart[@]}" --kill-child "$worker" study.toml apart 1 100000 apart.log 20 2000 &
  victim=$!
  until [ -n "$(ls apart/claims 2>/dev/null)" ]; do sleep 0.01; done
  "$worker" study.toml apart 1 0 apart.log 20 2000 &
  waiting=$!
  there() { find apart/runs -maxdepth 1 -name '[!.]*' | tail -n +2 | wc -l; }
  until [ "$(there)" -ge 59 ]; do sleep 0.05; done
  sleep 2.5
  [ "$(there)" = 59 ] && kill -0 $waiting || fails "a claim that counts was not waited for"
  kill -KILL $victim
  wait $victim 2>/dev/null
  wait $waiting || fails "a claim whose count stands still is not taken over"
  same apart
else
  echo "store: no name space of processes can be made here"
fi

# --- a file system without locks and links that says a claim is there though it made it ---
for program in 1 2 3; do
  LD_PRELOAD=$misfortune MISFORTUNE_FOLDER=$folder MISFORTUNE_NFS=1 "$worker" study.toml remote 1 1 remote.log 20 300 ||
    fails "program $program without locks and links" &
done
wait
"$worker" study.toml remote 1 1 remote.log 20 300 # sweeps
same remote

# --- damaged and foreign runs are named, are not exported, and are pressed again ---
cp -r whole damaged
# shellcheck disable=SC2012
mapfile -t keys < <(ls whole/runs)
truncate -s -20 "damaged/runs/${keys[0]}/curve.csv"
rm -r "damaged/runs/${keys[1]}" && cp -r "whole/runs/${keys[2]}" "damaged/runs/${keys[1]}"
sed -i '$ s/1/2/' "damaged/runs/${keys[3]}/curve.csv"
rm "damaged/runs/${keys[4]}/summary.json"
rm -r "damaged/runs/${keys[5]}" && echo foreign >"damaged/runs/${keys[5]}"
rm -r "damaged/runs/${keys[6]}" && ln -s nowhere "damaged/runs/${keys[6]}"
rm "damaged/runs/${keys[7]}/curve.csv" && mkdir "damaged/runs/${keys[7]}/curve.csv"
"$platen" study export study.toml --store damaged -o damaged.csv 2>answer
[ $? -eq 4 ] && grep -q '7 of 60 runs are damaged' answer && [ "$(grep -c ',damaged,' damaged.csv)" = 7 ] ||
  fails "damaged runs were exported: $(cat answer)"
"$platen" study merge study.toml --store merged --from damaged >answer 2>&1
grep -q '^53 runs copied' answer && [ "$(grep -c 'the run was left out' answer)" = 7 ] || fails "damaged runs were merged: $(cat answer)"
cp -r damaged mended
"$worker" study.toml mended 1 0 mended.log 2>answer || fails "a damaged store is not mended"
[ "$(grep -c 'pressed again' answer)" = 7 ] || fails "damaged runs are not named: $(cat answer)"
same mended
cp -r damaged merged_over
"$platen" study merge study.toml --store merged_over --from whole | grep -q '^7 runs copied' || fails "whole runs are not taken for damaged ones"
same merged_over

# --- full and read-only file systems say so, and can be read ---
if mkdir small && mount -t tmpfs -o size=64k tmpfs small 2>/dev/null; then
  trap 'umount "$folder/small"; rm -rf "$folder"' EXIT
  "$worker" study.toml small/store 2 0 small.log 2>answer
  [ $? -eq 4 ] && grep -q 'No space left on device; free some space' answer || fails "a full disk: $(cat answer)"
  status small/store >/dev/null || fails "a store on a full disk cannot be read"
  mount -o remount,size=8m small
  "$worker" study.toml small/store 2 0 small.log || fails "the study does not go on when there is room"
  same small/store
  mount -o remount,ro small
  "$platen" study run study.toml --store small/store --workers 1 2>answer
  [ $? -eq 4 ] && grep -q 'Read-only file system' answer || fails "a read-only disk: $(cat answer)"
  status small/store | grep -q '60 done' && "$platen" study export study.toml --store small/store -o read-only.csv ||
    fails "a store on a read-only disk cannot be read"
  umount small
  trap 'rm -rf "$folder"' EXIT
else
  echo "store: nothing can be mounted here"
fi

# --- two stores that both grew ---
for half in one two; do cp -r whole $half; done
for key in "${keys[@]:0:30}"; do rm -r "one/runs/$key"; done
for key in "${keys[@]:20:20}"; do rm -r "two/runs/$key"; done
"$platen" study merge study.toml --store one --from two | grep -q '^20 runs' || fails "one from two"
"$platen" study merge study.toml --store two --from one | grep -q '^10 runs' || fails "two from one"
cmp <(cd one/runs && find . -type f -exec sha256sum {} + | sort) <(cd two/runs && find . -type f -exec sha256sum {} + | sort) ||
  fails "two stores that were merged both ways differ"

# --- any write fails: a sentence, exit code 4; the store can be read, and the study goes on ---
study 2 1 1 >study.toml
rm -r whole
"$worker" study.toml whole 1 0 log && exported whole
ill() { LD_PRELOAD=$misfortune MISFORTUNE_FOLDER=$folder/ill "$@"; }
MISFORTUNE_COUNT=$folder/count ill "$worker" study.toml "$folder/ill" 1 0 log
rm -r ill
calls=$(wc -c <count)
[ "$calls" -gt 20 ] || fails "only $calls calls: the test tests nothing"
[ "$extent" = slow ] && stride=1 || stride=5
for error in 28 5; do # ENOSPC, EIO
  for at in $(seq 1 $stride $((2 * calls))); do
    rm -rf ill
    MISFORTUNE_AT=$at MISFORTUNE_ERROR=$error ill "$worker" study.toml "$folder/ill" 1 0 log 2>answer
    code=$?
    [ $code -eq 0 ] && [ "$at" -gt "$calls" ] && break
    [ $code -eq 4 ] && grep -Eq '^(worker|platen): .*(No space left on device|Input/output error)' answer ||
      { [ $code -eq 0 ] && [ "$(ls ill/runs)" = "$(ls whole/runs)" ]; } || fails "call $at, errno $error: exit $code, $(cat answer)"
    [ ! -d ill ] || status ill >/dev/null || fails "call $at, errno $error: the store cannot be read"
    "$worker" study.toml ill 1 0 log || fails "call $at, errno $error: the study does not go on"
    same ill
  done
done

if [ "$extent" = slow ]; then
  # --- 256 workers ---
  study 20 20 10 >study.toml
  "$worker" study.toml crowd 256 2 crowd256.log || fails "256 workers"
  each_once crowd256.log 4000
  # --- 100,000 runs ---
  study 100 100 10 >study.toml
  "$worker" study.toml big 16 0 big.log || fails "100,000 runs"
  each_once big.log 100000
  TIMEFORMAT='%R s wall, %U s user, %S s system'
  echo status && time status big
  echo export && time "$platen" study export study.toml --store big -o big.csv --curves big-curves.csv --step 0.05
  [ "$(grep -c ',done,' big.csv)" = 100000 ] || fails "not all of 100,000 runs are exported"
  echo merge && time "$platen" study merge study.toml --store big2 --from big
fi
[ $failures -eq 0 ] && echo "store: all well"
exit $((failures > 0))
