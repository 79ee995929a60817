#!/bin/bash
# reproduce.sh PROGRAM CATALOGUE: the page of the papers has every figure and table that is listed here; no row is called reproduced without
# a number of the paper beside ours; what another engine changed is marked; what does not exist is refused.
set -u
platen=$(realpath "$1")
catalogue=$(realpath "$2")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0
fails() { failures=$((failures + 1)); echo "FAILED: $*"; }
export PLATEN_CATALOGUE=$catalogue

listed=$(
  for i in 1 2 4 6 7 8 9 10 11 12 13 14 15 16; do echo "es-fig-$i"; done
  echo es-table-3 es-a-1 es-a-2 es-a-3
  for i in $(seq 2 12); do echo "wg-fig-$i"; done
  echo wg-table-2 wg-table-3 wg-table-4
  for i in 1 3 4 6 $(seq 9 23) $(seq 25 30); do echo "sh-fig-2-$i"; done
  for i in $(seq 1 10); do echo "sh-fig-3-$i"; done
  echo sh-fig-c sh-table-2-2 sh-table-2-4 sh-table-3-1 sh-table-c-1
)

start=$SECONDS
"$platen" reproduce all -o page >answer 2>log || { fails "reproduce all"; cat log; }
[ $((SECONDS - start)) -le 120 ] || fails "reproduce all took $((SECONDS - start)) s"
for row in $listed; do grep -q "<article id=\"$row\"" page/index.html || fails "row $row is missing"; done

# a row that is reproduced, or differs, has a number
while read -r id class; do
  case $class in
  reproduced | differs) grep -q "^[a-z-]*,$id,1," page/numbers.csv || fails "$id is '$class' without a number" ;;
  not) ! grep -q ",$id,1," page/numbers.csv || fails "$id cannot be compared, yet has a number" ;;
  *) fails "$id has no verdict" ;;
  esac
done < <(sed -n 's/.*<article id="\([^"]*\)" class="\([^"]*\)".*/\1 \2/p' page/index.html)

# the verdict follows from the numbers that are kept
awk -F, '/^#/ || /^paper,/ { next }
  { d = $7 < 0 ? -$7 : $7; if (!(d <= $8 * (1 + 1e-4))) out[$2] = 1; says[$2] = $11 }
  END { for (r in says) if ((r in out) == (says[r] == "reproduced")) { print r, says[r]; bad = 1 } exit bad }' page/numbers.csv ||
  fails "a verdict is not what its numbers say"

# a share of the rows carries a number
awk '$1 ~ /^(edmans-sinka|wang|shahin)$/ { rows += $2; with += $6 } END { exit !(rows > 0 && with >= 0.6 * rows) }' answer ||
  { fails "less than 60 % of the rows have a number"; cat answer; }

# every picture and table that the page names is there, and nothing is fetched
for file in $(grep -o '\(src\|href\)="figures/[^"]*"' page/index.html | cut -d'"' -f2 | sort -u); do [ -s "page/$file" ] || fails "$file is missing"; done
! grep -qE '(src|href)="(https?:)?//' page/index.html || fails "the page asks a server"

# another engine: one number moved by more than its error, one by less
sed 's/^# engine = .*/# engine = 1/' page/numbers.csv |
  awk -F, -v OFS=, '$2 == "es-fig-11" && $3 == 1 { $7 += 0.5 } $2 == "es-fig-11" && $3 == 2 { $7 += 1e-9 } { print }' >old.csv
"$platen" reproduce edmans-sinka -o one --previous old.csv >/dev/null 2>&1 || fails "reproduce edmans-sinka"
grep -q 'Against the numbers of engine 1 1 changed' one/index.html || fails "the change is not marked, or more than it"
grep -c 'class="out">Changed' one/index.html | grep -qx 1 || fails "its row is not marked"
! grep -q '<article id="wg-' one/index.html || fails "a page of one paper has another's rows"

"$platen" reproduce nobody -o none >answer 2>&1
[ $? -eq 2 ] && grep -q "there is no paper 'nobody'" answer && [ ! -e none/index.html ] || fails "an unknown paper is not refused"
"$platen" reproduce wang -o none --previous missing.csv >answer 2>&1
[ $? -eq 2 ] && grep -q 'missing.csv: there is no such file' answer && [ ! -e none/index.html ] ||
  { fails "a missing file of earlier numbers is not refused"; cat answer; }

[ $failures -eq 0 ] && echo "the papers: every row is there" || exit 1
