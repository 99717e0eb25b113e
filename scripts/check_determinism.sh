#!/usr/bin/env bash
# Checks that all answers have the same bits with every compiler and level of optimization: builds one program in
# several ways and compares its hashes of all distances, points of paths and arcs of geodesic Voronoi diagrams. Usage:
# check_determinism.sh [MESH...]
#
# Without arguments, it takes meshes of the tests, and two of CGAL's meshes if Debian's package libcgal-demo is there.
# With -march=native a compiler may fuse a product and a sum into one operation that rounds once. This may change bits,
# and is only reported. With -ffp-contract=off the bits must be the same.
# CGAL_INCLUDE_DIRS may hold flags for the headers of another CGAL. WORK_FOLDER is the folder to build in.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$root/test/Surface_mesh_geodesics/determinism/print_hashes.cpp
data=$root/test/Surface_mesh_geodesics/data
if [ -n "${WORK_FOLDER:-}" ]; then
  work=$WORK_FOLDER
  mkdir -p "$work"
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi

meshes=("$@")
if [ ${#meshes[@]} -eq 0 ]; then
  meshes=("$root/examples/Surface_mesh_geodesics/data/bumpy_sphere.off" "$data/cube.off" "$data/grid9.off"
    "$data/cone64.off" "$data/saddle_fan8.off" "$data/needle_1e-12.off")
  archive=/usr/share/doc/libcgal-dev/data.tar.gz
  for mesh in bunny00.off fandisk.off; do
    if [ -f "$archive" ] && tar -xzf "$archive" -C "$work" "data/meshes/$mesh" 2>> "$work/tar.log"; then
      meshes+=("$work/data/meshes/$mesh")
    fi
  done
fi

all_flags=("-O0" "-O1" "-O3" "-O3 -march=native -ffp-contract=off" "-O3 -march=native")
reference=
status=0
printf '%-10s %-38s %s\n' compiler flags result
for compiler in g++ clang++; do
  if ! command -v "$compiler" > /dev/null; then
    echo "$compiler is not installed"
    continue
  fi
  for flags in "${all_flags[@]}"; do
    # CGAL requires -frounding-math of every user of GCC.
    rounding=$([ "$compiler" = g++ ] && echo -frounding-math || true)
    # shellcheck disable=SC2086
    "$compiler" -std=c++17 $flags $rounding -I"$root/include" ${CGAL_INCLUDE_DIRS:-} "$program" \
      -o "$work/print_hashes" -lgmp -lmpfr
    "$work/print_hashes" "${meshes[@]}" > "$work/hashes.txt"
    if [ -z "$reference" ]; then
      reference=$work/reference.txt
      cp "$work/hashes.txt" "$reference"
      result="reference, $(wc -l < "$reference") meshes"
    elif cmp -s "$reference" "$work/hashes.txt"; then
      result="the same bits"
    else
      differing=$(diff "$reference" "$work/hashes.txt" | grep -c '^>' || true)
      result="other bits on $differing meshes"
      if [ "$flags" != "-O3 -march=native" ]; then
        result="$result: FAILED"
        diff "$reference" "$work/hashes.txt" >&2 || true
        status=1
      fi
    fi
    printf '%-10s %-38s %s\n' "$compiler" "$flags" "$result"
  done
done
cat "$reference"
exit $status
