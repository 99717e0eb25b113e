#!/usr/bin/env bash
# The quick check, ten minutes on two cores: installs what is needed, builds the tests with warnings as errors, and runs
# them. scripts/run_all_tests.sh runs the rest, also the examples and the program for the command line.
#
# Programs are compiled in groups, with all assertions (also CGAL_expensive_assertion) and little optimization: the
# answers have the same bits on every level.
# Everything is written below build/. Arguments go to ctest. JOBS is the number of jobs at once.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/build_and_test.sh"

install_needs_of_tests
build=$root/build
configure "$build" "-O1;-UNDEBUG;-DCGAL_CHECK_EXPENSIVE" -DSurface_mesh_geodesics_BENCHMARK=OFF \
  -DSurface_mesh_geodesics_EXAMPLES=OFF -DSurface_mesh_geodesics_PROGRAM=OFF -DSurface_mesh_geodesics_LONG_TESTS=OFF
cmake --build "$build" --parallel "$jobs"
run_ctest "$build" "$@"
