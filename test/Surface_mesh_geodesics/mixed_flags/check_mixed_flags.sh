#!/usr/bin/env bash
# One program of files that are compiled for different instruction sets is right (one-definition rule): the same
# functions in each file, the same distances in whichever order the linker sees the files, and these are those of a
# program without flags. usage: check_mixed_flags.sh COMPILER WORK_FOLDER [FLAGS...]
#
# The flags are -mavx2 and those of AVX-512, without fused operations, which change last digits where a file is compiled
# with them. Skipped (77) on processors without AVX2. On those without AVX-512, -mavx2 takes its place.
set -euo pipefail
compiler=$1
work=$2
shift 2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../../.." && pwd)
grep -qw avx2 /proc/cpuinfo 2> /dev/null || exit 77
avx512=(-mavx2)
grep -qw avx512vl /proc/cpuinfo && avx512=(-mavx512f -mavx512bw -mavx512dq -mavx512vl)
mkdir -p "$work"

# compile FUNCTION FLAGS...: makes FUNCTION.o
compile()
{
  local function=$1
  shift
  "$compiler" -std=c++17 -O2 -ffp-contract=off "-I$root/include" "-DFUNCTION=$function" "$@" -c "$here/distances.cpp" \
    -o "$work/$function.o"
}

compile distances_without_flags -DMAIN "$@"
compile distances_with_avx2 -mavx2 "$@"
compile distances_with_avx512 "${avx512[@]}" "$@"

# The loops in each file, which tables point to: none may exist in one of them only.
functions()
{
  nm --defined-only -C "$work/$1.o" | sed 's/^[0-9a-f]* *//' | grep -E ' .*(cross<|trim|find_nearest|is_split_by)\(' \
    | grep _lanes:: | sed 's/^. //' | LC_ALL=C sort -u
}
functions distances_without_flags > "$work/functions.txt"
[ -s "$work/functions.txt" ] || { echo "no functions for lanes were found" >&2; exit 1; }
for file in distances_with_avx2 distances_with_avx512; do
  diff "$work/functions.txt" <(functions "$file") || { echo "$file has other functions" >&2; exit 1; }
done

data=$here/../data
meshes=("$root/examples/Surface_mesh_geodesics/data/bumpy_sphere.off" "$data/grid9.off" "$data/cone64.off"
  "$data/saddle_fan8.off" "$data/needle_1e-12.off")
# The linker keeps the text of the first file: each of them has its turn.
files=(distances_without_flags distances_with_avx2 distances_with_avx512)
for turn in 0 1 2; do
  objects=()
  for k in 0 1 2; do
    objects+=("$work/${files[(turn + k) % 3]}.o")
  done
  "$compiler" "${objects[@]}" -o "$work/mixed_$turn" -lgmp -lmpfr
  "$work/mixed_$turn" "${meshes[@]}" > "$work/mixed_$turn.txt"
  cmp "$work/mixed_0.txt" "$work/mixed_$turn.txt"
done
echo "the same distances in each order of the files, and $(wc -l < "$work/functions.txt") functions in each file"
