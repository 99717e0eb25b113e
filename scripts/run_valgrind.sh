#!/usr/bin/env bash
# Runs the program for the command line under valgrind's memcheck, with several subcommands on small meshes. Fails if
# there is an error or a leak. Tests with exact predicates are left out: valgrind does not support the directions of
# rounding that CGAL's intervals need. Everything is written below build/valgrind, or WORK_FOLDER.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=${WORK_FOLDER:-$root/build/valgrind}
data=$root/test/Surface_mesh_geodesics/data
"$root/scripts/install_needs.sh" valgrind g++ cmake make libcgal-dev libboost-program-options-dev libeigen3-dev

cmake -S "$root" -B "$work/build" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DSurface_mesh_geodesics_PROGRAM=ON \
  -DSurface_mesh_geodesics_TESTS=OFF -DSurface_mesh_geodesics_EXAMPLES=OFF -DSurface_mesh_geodesics_BENCHMARK=OFF
cmake --build "$work/build" --target surface_mesh_geodesics_program --parallel "${JOBS:-1}"
program=$work/build/demo/Surface_mesh_geodesics/surface_mesh_geodesics
cd "$work"

number=0
# runs ARGUMENTS: runs the program, which has to succeed without an error of memory
runs() {
  number=$((number + 1))
  if ! valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,indirect \
    --log-file="valgrind_$number.log" "$program" "$@" > "out_$number" 2> "err_$number"; then
    echo "FAILED: surface_mesh_geodesics $*"
    cat "valgrind_$number.log" "err_$number"
    exit 1
  fi
  echo "passed: surface_mesh_geodesics $(basename "$2") ($1)"
}

for mesh in grid9 cone64 saddle_fan8 needle_1e-12 pinched_vertex two_components cap_zero_area L_shape; do
  runs info "$data/$mesh.off"
  runs distances "$data/$mesh.off" --source 0 --source 2
done
runs distances "$data/grid9.off" --source-random 5 -o distances.csv -o colors.ply
runs matrix "$data/cube.off" --source-random 3
runs path "$data/cone64.off" --source 3 --target 20 -o path.obj
runs path "$data/needle_B_3828.off" --source 0 --target 3 -o path.csv
runs check "$data/grid9.off" --source 0
runs voronoi "$data/cone64.off" --site-random 4 -o cells.vtk
runs voronoi "$data/sites_at_one_point.off" --site 0 --site 1 -o cells.csv
runs sample "$data/cone64.off" --number 5
echo "$number runs without an error of memory."
