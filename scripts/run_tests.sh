#!/usr/bin/env bash
# Installs what is needed, builds everything with warnings as errors and runs all tests. Everything it writes is below
# build/. Arguments, if any, go to ctest; the variable JOBS sets the number of jobs at once.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
jobs=${JOBS:-$(nproc)}

"$root/scripts/install_needs.sh" \
  g++ clang cmake make libcgal-dev libcgal-demo libboost-program-options-dev libeigen3-dev libjs-three libtbb-dev \
  doxygen python3

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DSurface_mesh_geodesics_WARNINGS_AS_ERRORS=ON \
  -DSurface_mesh_geodesics_EXAMPLES=ON -DSurface_mesh_geodesics_TESTS=ON -DSurface_mesh_geodesics_BENCHMARK=ON \
  -DSurface_mesh_geodesics_PROGRAM=ON
cmake --build "$build" --parallel "$jobs"
cd "$build"
ctest --output-on-failure --no-tests=error --parallel "$jobs" "$@"
