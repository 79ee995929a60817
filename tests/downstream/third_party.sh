#!/bin/bash
# third_party.sh SOURCE PYTHON: what a release says of the work of others in it: of each package a version and a licence text; what is
# not there is refused.
set -eu
source=$1 python=$2
command -v dpkg-query >/dev/null || { echo 'skipped: no Debian'; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
eval "$(sed -n -e '/^in_lammps=/p' -e '/^\(group\|present\|from_source\)() {/,/^}/p' "$source/run")"
mapfile -t parts < <(cd "$source" && from_source)
[ ${#parts[@]} -eq "$(cd "$source" && group core | wc -l)" ] || { echo "FAILED: the source is built from ${parts[*]}"; exit 1; }
parts+=("${in_lammps[@]}")
"$python" -B "$source/cmake/third_party.py" "$folder/licences" "$folder/bill.json" "${parts[@]}"
for name in "${parts[@]#debian:}"; do
  version=$(dpkg-query -W -f '${Version}' "$name")
  grep -qF "\"pkg:deb/debian/$name@$version\"" "$folder/bill.json" || { echo "FAILED: no $name in $(cat "$folder/bill.json")"; exit 1; }
  grep -qiE 'copyright' "$folder/licences/$name.txt" || { echo "FAILED: no licence of $name"; exit 1; }
done
"$python" -B "$source/cmake/third_party.py" "$folder/none" "$folder/none.json" debian:no-such-package 2>/dev/null &&
  { echo 'FAILED: a package that is not there was listed'; exit 1; }
echo 'third_party: all well'
