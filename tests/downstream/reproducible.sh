#!/bin/bash
# reproducible.sh CMAKE SOURCE: the library of the laws, built in two folders without a compiler cache and, where it can be taken
# away, without a network, is the same to the byte.
set -eu
cmake=$1 source=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export CCACHE_DISABLE=1
apart=()
unshare --net true 2>/dev/null && apart=(unshare --net)
for name in one another/of-another-length; do
  mkdir -p "$folder/$name"
  cp -r "$source/include" "$source/src" "$source/cmake" "$source/CMakeLists.txt" "$source/CMakePresets.json" "$folder/$name"
  "${apart[@]}" "$cmake" -S "$folder/$name" -B "$folder/$name/build" -DCMAKE_BUILD_TYPE=Release -DPLATEN_PROGRAM=OFF -DPLATEN_TESTS=OFF \
    -DBUILD_SHARED_LIBS=ON --log-level=WARNING >/dev/null
  "${apart[@]}" "$cmake" --build "$folder/$name/build" >/dev/null
done
cd "$folder/one/build"
mapfile -t built < <(find . -name 'libplaten_law*' -type f)
[ ${#built[@]} -gt 0 ] || { echo 'nothing was built'; exit 1; }
sha256sum "${built[@]}" | (cd "$folder/another/of-another-length/build" && sha256sum -c)
