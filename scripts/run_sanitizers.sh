#!/usr/bin/env bash
# Builds the test programs with sanitizers and runs them: all programs with the sanitizers for addresses and undefined
# behavior, and the programs with threads with the sanitizer for threads. These use their own threads then, because
# TBB's threads cannot be checked. Prints one line per program. Everything is written below build/. Arguments are the
# names of the programs to run, without .cpp (default: all). CXX is the compiler, JOBS the number of programs at once.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
tests=$root/test/Surface_mesh_geodesics
export work=${WORK_FOLDER:-$root/build/sanitizers}
export compiler=${CXX:-g++} include=$root/include tests
mkdir -p "$work"

mapfile -t programs < <("$root/scripts/list_tests.sh" "$@")

# run_program NAME KIND FLAGS: builds and runs a program, and prints one line about it
run_program() {
  local name=$1 kind=$2 flags=$3 start=$SECONDS log=$work/$1.$2.log
  local program=$work/$name.$kind
  if ! "$compiler" -std=c++17 -O1 -g $flags -fno-omit-frame-pointer -I"$include" -I"$tests/include" \
    $([ -d /usr/include/eigen3 ] && echo -I/usr/include/eigen3) \
    "$tests/$name.cpp" -o "$program" -lgmp -lmpfr -pthread > "$log" 2>&1; then
    echo "FAILED  $name ($kind): does not compile, see $log"
    return 1
  fi
  local built=$((SECONDS - start))
  start=$SECONDS
  if (cd "$tests" && ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 \
    TSAN_OPTIONS=halt_on_error=1 "$program") >> "$log" 2>&1; then
    echo "passed  $name ($kind): built in $built s, run in $((SECONDS - start)) s, $(tail -n 1 "$log")"
    rm -f "$program"
  else
    echo "FAILED  $name ($kind): $(grep -m 1 'SUMMARY\|runtime error\|FAILED' "$log" || tail -n 1 "$log"), see $log"
    return 1
  fi
}
export -f run_program

# Shifts of negative numbers are not checked: CGAL::MP_Float, which a test compares with, uses them on purpose.
list() {
  local name
  for name in "${programs[@]}"; do
    printf '%s\0address_undefined\0-fsanitize=address,undefined -fno-sanitize=shift-base -fno-sanitize-recover=undefined\0' "$name"
    case "$name" in
      test_paths_from_threads | test_distance_matrix | test_parallel_propagation | test_Voronoi_interface \
        | test_fine_subdivisions | test_parallel_keepers | test_work_sharing | test_reading_in_blocks \
        | test_certificate_checks | test_parallel_applications | test_parallel_out_of_memory \
        | test_parallel_paths_and_diagrams)
        printf '%s\0thread\0-fsanitize=thread\0' "$name" ;;
    esac
  done
}
list | xargs --null --max-args=3 --max-procs="${JOBS:-1}" bash -c 'run_program "$@"' run_program
status=$?
[ $status -eq 0 ] && echo "All programs passed." || echo "Some programs FAILED."
exit $status
