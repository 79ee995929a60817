#!/bin/bash
# The laws with LLVM's standard library, which hosts on a Mac have; skipped where no Clang has it.
# Usage: libcxx.sh SOURCE_FOLDER   (PLATEN_LIBCXX: include/c++/v1 of a libc++ that is unpacked, not installed)
set -u
options=(-stdlib=libc++)
[ -z "${PLATEN_LIBCXX-}" ] || options=(-nostdinc++ -isystem "$PLATEN_LIBCXX")
for version in 19 18 17 16 15 14; do
  clang=clang++-$version
  command -v $clang >/dev/null && echo '#include <charconv>' | $clang "${options[@]}" -x c++ -fsyntax-only - 2>/dev/null || continue
  echo "$clang ${options[*]}"
  exec $clang -std=c++20 -Wall -Wextra -Wpedantic -Werror "${options[@]}" -I"$1/include" -c "$1/tests/downstream/host_macro.cpp" -o /dev/null
done
echo 'skipped: no Clang with libc++'
exit 77
