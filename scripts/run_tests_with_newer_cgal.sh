#!/usr/bin/env bash
# Builds everything and runs the quick check with the CGAL of a newer Debian, which is unpacked and not installed.
# Boost, GMP and MPFR stay those of this system. Everything is written below build/.
# usage: run_tests_with_newer_cgal.sh [RELEASE [arguments of ctest]]
# RELEASE is the name of a Debian release (default: trixie). `trixie -C full` runs the long check. JOBS is the number of
# jobs at once.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
release=${1:-trixie}
[ $# -eq 0 ] || shift
work=$root/build/cgal_of_$release
source "$root/scripts/own_archive.sh"
source "$root/scripts/build_and_test.sh"
install_needs_of_tests

unpack_newer_cgal "$work" "$release"

config=$(find "$work/package" -name CGALConfig.cmake)
grep -h 'define CGAL_VERSION ' "$work/package/usr/include/CGAL/version.h"
configure "$work/build" "-O1;-UNDEBUG" -DCGAL_DIR="$(dirname "$config")"
cmake --build "$work/build" --parallel "$jobs"
run_ctest "$work/build" "$@"
