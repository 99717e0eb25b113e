#!/usr/bin/env bash
# The long check, an hour on two cores: all that scripts/run_tests.sh leaves out. It has two parts; the name of
# one as an argument runs only that one.
#   full   builds with the flags of a release and runs all tests with them: also the examples, the program for the command
#          line, each header alone, the programs with clang, projects that use the package, CGAL's own examples, the
#          Python module
#   fuzz   runs a thousand random cases of each fuzz program
# Everything is written below build/all. JOBS is the number of jobs at once, SEED the first number of the random cases.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/build_and_test.sh"
parts=("$@")
[ $# -gt 0 ] || parts=(full fuzz)

full()
{
  local python=()
  [ ! -x /usr/bin/python3 ] || python=(-DPython_EXECUTABLE=/usr/bin/python3) # the one of Debian's packages
  configure "$root/build/all" "" -DSurface_mesh_geodesics_PYTHON=ON "${python[@]}"
  cmake --build "$root/build/all" --parallel "$jobs"
  run_ctest "$root/build/all" -C full
}

# The fuzz programs are in the build of the part `full`.
fuzz()
{
  local folder=$root/build/all/test/Surface_mesh_geodesics seed=${SEED:-20261} program
  if [ ! -e "$folder/fuzz_distances" ]; then
    configure "$root/build/all" ""
    cmake --build "$root/build/all" --parallel "$jobs"
  fi
  for program in fuzz_distances fuzz_curves fuzz_Voronoi fuzz_Voronoi_on_lattices fuzz_paths_near_vertices \
    fuzz_paths_on_hostile_meshes; do
    echo "$program 1000 $seed"
    (cd "$folder" && "./$program" 1000 "$seed")
  done
}

install_needs_of_tests
"$root/scripts/install_needs.sh" libboost-mpi-dev openmpi-bin
"$root/scripts/install_needs.sh" pybind11-dev python3-dask python3-dev python3-distributed python3-joblib python3-matplotlib python3-numpy \
  python3-pip python3-pybind11 python3-pytest python3-scipy python3-setuptools python3-wheel
for part in "${parts[@]}"; do
  case "$part" in
    full | fuzz) "$part" ;;
    *) sed -n '2,/^[^#]/s/^# \?//p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
  esac
done
