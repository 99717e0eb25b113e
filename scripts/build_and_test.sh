#!/usr/bin/env bash
# Functions for the scripts that run tests; they set `root`, the folder of the package.

jobs=${JOBS:-$(nproc)}

install_needs_of_tests()
{
  "$root/scripts/install_needs.sh" \
    g++ clang cmake make ninja-build libcgal-dev libcgal-demo libboost-program-options-dev libeigen3-dev libjs-three \
    libtbb-dev doxygen python3
}

# configure BUILD FLAGS [options of cmake]: FLAGS is a list of compiler flags for tests, examples, benchmark
# programs and the program for the command line. Ninja is used if it is there and the folder is new.
configure()
{
  local build=$1 flags=$2 generator=()
  shift 2
  if [ ! -f "$build/CMakeCache.txt" ] && command -v ninja > /dev/null; then
    generator=(-G Ninja)
  fi
  cmake -S "$root" -B "$build" "${generator[@]}" -DCMAKE_BUILD_TYPE=Release \
    -DSurface_mesh_geodesics_WARNINGS_AS_ERRORS=ON -DSurface_mesh_geodesics_GROUP_PROGRAMS=ON \
    -DSurface_mesh_geodesics_PROGRAM_FLAGS="$flags" -DSurface_mesh_geodesics_TESTS=ON \
    -DSurface_mesh_geodesics_EXAMPLES=ON -DSurface_mesh_geodesics_BENCHMARK=ON -DSurface_mesh_geodesics_PROGRAM=ON "$@"
}

# run_ctest BUILD [arguments of ctest]: the summary of the times comes last, also if tests fail.
run_ctest()
{
  local build=$1 status=0
  shift
  (cd "$build" && ctest --output-on-failure --no-tests=error --parallel "$jobs" "$@") || status=$?
  if command -v python3 > /dev/null; then
    python3 "$root/scripts/print_times.py" "$build" || true
  fi
  return $status
}
