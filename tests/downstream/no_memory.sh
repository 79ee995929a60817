#!/bin/bash
# no_memory.sh PROGRAM LIBRARY quick|slow: one allocation of a command fails, another one each time. Then the answer is the
# whole one all the same, or there is a sentence and exit code 4; nothing is half-written, and the command can be given again.
set -u
platen=$(realpath "$1") library=$(realpath "$2") extent=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0
fails() { failures=$((failures + 1)); echo "FAILED: $*"; }

printf '%s\n' 'platen = 1' 'experiment = "simple"' 'material = "von-mises-100"' 'radius_m = 1e-3' '[path]' \
  'delta_bar_max = 0.01' '[mesh]' 'elements = 300' '[output]' 'fields_at = [0.01]' >case.toml
printf '%s\n' 'platen = 1' 'law = "edmans-sinka"' '[parameters]' 'sigma_ref_Pa = 1e6' 'E_Pa = 1e8' 'nu = 0.3' 'k = 6.4' \
  'delta_t = 0.12' 'a = 2.4' >law.toml

answer() { (cd out && find . -type f ! -name summary.json -exec sha256sum {} + | sort; sed 's/, in [0-9.]* s$//' ../said); }

# each LABEL QUICK SLOW COMMAND...: that many of its allocations, in equal steps, and its last ones, most of them of
# values of JSON, which allocate even as they are destroyed; it writes into the folder out
each() {
  local label=$1 runs=$2 count at code tried=0 refused=0
  [ "$extent" = slow ] && runs=$3
  shift 3
  rm -rf out && mkdir out
  LD_PRELOAD=$library NO_MEMORY_COUNT=$folder/count "$platen" "$@" >said 2>error || { fails "$label: $(cat error)"; return; }
  count=$(cat count)
  [ "$count" -gt 500 ] || fails "$label: only $count allocations: the test tests nothing"
  answer >whole
  for at in $(seq 1 $((count > runs ? count / runs : 1)) "$count") $(seq $((count - 30)) "$count"); do
    rm -rf out && mkdir out
    LD_PRELOAD=$library NO_MEMORY_AT=$at "$platen" "$@" >said 2>error
    code=$?
    tried=$((tried + 1))
    case $code in
    0) answer | cmp -s - whole || fails "$label, allocation $at: exit code 0 and another answer" ;;
    4)
      refused=$((refused + 1))
      grep -q '^platen: .' error || fails "$label, allocation $at: no sentence"
      [ ! -e out/summary.json ] || grep -q '"complete": true' out/summary.json || # a press keeps what it has
        { grep -q '"failure": "stopped at .* memory' out/summary.json && grep -q '^0' out/curve.csv; } ||
        fails "$label, allocation $at: summary.json"
      [ -z "$(find . -name '.*.*' -type f)" ] || fails "$label, allocation $at: $(find . -name '.*.*' -type f)"
      ;;
    *) fails "$label, allocation $at: exit code $code, $(tail -n 1 error)" ;;
    esac
  done
  "$platen" "$@" >said 2>error && answer | cmp -s - whole || fails "$label: does not run any more"
  echo "$label: $tried of $count allocations, $refused refused"
  [ $refused -gt 0 ] || fails "$label: no allocation was refused"
}

each eval 60 100000 eval law.toml -p radius_m=1e-3 --overlap 0:1e-4:11
each predict 25 1000 predict mcc-ph-200 -o out/law.toml
each press 15 1000 press case.toml -o out
[ $failures -eq 0 ] && echo 'all as wanted'
exit $((failures > 0))
