#!/usr/bin/env bash
# How many instructions does a list of 1, 2, 3, ... windows cost? Compiles benchmark_short_lists.cpp, lets valgrind count,
# and prints comma separated values. See readme.txt.
set -euo pipefail

if [ $# -eq 0 ]; then
  echo "usage: count_list_instructions.sh MESH...  (the variable CXX names the compiler; needs CGAL and valgrind)" >&2
  exit 1
fi
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
compiler="${CXX:-g++}"
flags="-std=c++17 -O3 -DNDEBUG -frounding-math -ffp-contract=off"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
include="$here/../../include" # in CGAL's source tree as well
# shellcheck disable=SC2086
"$compiler" $flags -I"$include" -I"$here/include" "$here/benchmark_short_lists.cpp" -o "$folder/short_lists" \
  -lgmp -lmpfr -lpthread

echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)"
echo "# compiler: $("$compiler" --version | head -n 1), flags: $flags"
echo "# instructions of a list that crosses a face, counted by valgrind, on average of the lists crossed"
echo "mesh,faces,windows,lists,crossed,instructions_per_list"
for mesh in "$@"; do
  for n in 1 2 3 4 8 16 32; do
    row="$(valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect='*cross_face*' \
      "$folder/short_lists" --windows "$n" "$mesh" 2> "$folder/valgrind.log")" \
      || { cat "$folder/valgrind.log" >&2; exit 1; }
    collected="$(awk '/Collected/ { print $NF }' "$folder/valgrind.log")"
    crossed="${row##*,}"
    [ "$crossed" -eq 0 ] || echo "$row,$((collected / crossed))"
  done
done
