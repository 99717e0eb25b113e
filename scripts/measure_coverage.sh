#!/usr/bin/env bash
# Measures which lines of include/ the tests run: builds the tests with --coverage and without optimization, runs them,
# prints the share of lines for each file and for all files, and fails if the latter is below 95 %. Takes half an hour
# or more. Arguments are the names of the test programs to run, without .cpp (default: all). JOBS is the number of
# programs at once. Everything is written below build/coverage, or WORK_FOLDER.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export tests=$root/test/Surface_mesh_geodesics include=$root/include work=${WORK_FOLDER:-$root/build/coverage}
export compiler=${CXX:-g++}
"$root/scripts/install_needs.sh" g++ gcovr libcgal-dev libeigen3-dev || exit 1
mkdir -p "$work"
find "$work" -name '*.gcda' -delete

mapfile -t programs < <("$root/scripts/list_tests.sh" "$@")

run_program() {
  local flags=(-std=c++17 -O0 --coverage -fprofile-update=atomic -DNDEBUG -frounding-math)
  [ -d /usr/include/eigen3 ] && flags+=(-isystem /usr/include/eigen3)
  "$compiler" "${flags[@]}" -I"$include" -I"$tests/include" "$tests/$1.cpp" -o "$work/$1" -lgmp -lmpfr -pthread \
    > "$work/$1.log" 2>&1 && (cd "$tests" && "$work/$1" >> "$work/$1.log" 2>&1) \
    && echo "passed  $1" || { echo "FAILED  $1, see $work/$1.log"; return 1; }
}
export -f run_program
printf '%s\0' "${programs[@]}" | xargs --null --max-args=1 --max-procs="${JOBS:-1}" bash -c 'run_program "$0"'
status=$?

gcovr --root "$root" --filter "$include/" --print-summary --fail-under-line 95 -j "${JOBS:-1}" \
  --html-details "$work/index.html" --txt "$work/lines.txt" "$work" || status=1
cat "$work/lines.txt"
exit $status
