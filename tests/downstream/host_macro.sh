#!/bin/sh
# A GPU code sets PLATEN_FUNCTION. Here it is set to an attribute that can be seen in the object file (hidden
# visibility): every function of platen::law that evaluate() reaches must carry it. Constructors that the compiler
# writes itself need no mark, on a GPU either.
# Usage: host_macro.sh COMPILER INCLUDE_FOLDER
set -eu
here=$(dirname "$0")
object=$(mktemp)
trap 'rm -f "$object"' EXIT
"$1" -std=c++20 -O0 -I"$2" '-DPLATEN_FUNCTION=__attribute__((visibility("hidden"))) inline' \
  -c "$here/host_macro.cpp" -o "$object"
functions=$(objdump -tC "$object" | grep ' F ' | grep 'platen::law::' | grep -v 'reach\|std::span')
marked=$(echo "$functions" | grep -c '\.hidden' || true)
unmarked=$(echo "$functions" | grep -v '\.hidden' | grep -v '::\(BasicResponse\|BasicState\|Loading\|Unloading\)()' || true)
[ "$marked" -ge 4 ] || { echo "only $marked functions carry PLATEN_FUNCTION: does this check see anything?"; exit 1; }
[ -z "$unmarked" ] || { echo "without PLATEN_FUNCTION:"; echo "$unmarked"; exit 1; }
echo "$marked functions carry PLATEN_FUNCTION"
