#!/usr/bin/env bash
# The long check, for before a release and for the machine that checks every change: all that scripts/run_tests.sh
# leaves out. It has three parts; their names as arguments run only those.
#   full       builds with the flags of a release and runs all tests with them: also each header alone with both
#              compilers, the programs with clang, projects that use the package, CGAL's own examples
#   contracts  runs the tests of windows, propagation, paths and diagrams with all assertions, the expensive ones too
#   fuzz       runs a thousand random cases of each fuzz program
# Everything is written below build/all and build/contracts. JOBS is the number of jobs at once, SEED the first number
# of the random cases.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/build_and_test.sh"
parts=("$@")
[ $# -gt 0 ] || parts=(full contracts fuzz)

full()
{
  configure "$root/build/all" ""
  cmake --build "$root/build/all" --parallel "$jobs"
  run_ctest "$root/build/all" -C full
}

contracts()
{
  configure "$root/build/contracts" "-O1;-UNDEBUG;-DCGAL_CHECK_EXPENSIVE" -DSurface_mesh_geodesics_EXAMPLES=OFF \
    -DSurface_mesh_geodesics_BENCHMARK=OFF -DSurface_mesh_geodesics_PROGRAM=OFF
  cmake --build "$root/build/contracts" --parallel "$jobs"
  run_ctest "$root/build/contracts" -L contracts
}

# The fuzz programs are in the build of the part `full`.
fuzz()
{
  local folder=$root/build/all/test/Surface_mesh_geodesics seed=${SEED:-20261} program
  if [ ! -e "$folder/fuzz_distances" ]; then
    configure "$root/build/all" ""
    cmake --build "$root/build/all" --parallel "$jobs"
  fi
  for program in fuzz_distances fuzz_Voronoi fuzz_paths_near_vertices fuzz_paths_on_hostile_meshes; do
    echo "$program 1000 $seed"
    (cd "$folder" && "./$program" 1000 "$seed")
  done
}

install_needs_of_tests
for part in "${parts[@]}"; do
  case "$part" in
    full | contracts | fuzz) "$part" ;;
    *) sed -n '2,/^[^#]/s/^# \?//p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
  esac
done
