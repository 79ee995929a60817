#!/bin/bash
# Each folder of src includes only folders that it stands on, as src/CMakeLists.txt links them; the laws need the standard
# library alone.
# Usage: includes.sh SOURCE_FOLDER
set -u
cd "$1" || exit 1
declare -A stands_on=(
  [core]='' [capi]='' [laws]='' [dem]='fit press fe material core' [material]=core [fe]='material core' [press]='fe material core'
  [fit]='press fe material core' [measure]='fit press fe material core'
  [study]='fit press fe material core' [surrogate]='study fit press fe material core'
  [calibrate]='surrogate study measure fit press fe material core'
  [plot]='fit press fe material core' [plot/measured]='plot calibrate surrogate study measure fit press fe material core'
  [plot/surrogate]='plot surrogate study fit press fe material core'
  [reproduce]='surrogate study plot fit press fe material core'
  [app]='reproduce plot calibrate surrogate study measure dem fit press fe material core')
status=0
for folder in src/*/ src/plot/*/; do
  folder=${folder#src/}
  folder=${folder%/}
  [ -n "${stands_on[$folder]+x}" ] || { echo "src/$folder is not in $0"; status=1; continue; }
  allowed=" $folder ${stands_on[$folder]} "
  while IFS=: read -r file line text; do
    to=${text#*\"}
    to=${to%%/*}
    case $allowed in *" $to "*) ;; *)
      [ -d "src/$to" ] && { echo "$file:$line: $folder includes $to"; status=1; } ;;
    esac
  done < <(grep -nH '#include "[a-z]*/' "src/$folder"/*.?pp)
done
if grep -nH '#include "' include/platen/law/*.hpp | grep -v '"platen/law/\|"platen/lanes.hpp"'; then status=1; fi
for folder in core capi dem material fe press; do
  [ "$folder" = dem ] || [ "$folder" = capi ] || ! grep -nH '#include "platen/law/' "src/$folder"/*.?pp || status=1
done
exit $status
