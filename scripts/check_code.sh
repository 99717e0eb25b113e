#!/usr/bin/env bash
# Looks for faults in include/ and demo/ without running code: clang-tidy with .clang-tidy, and cppcheck with
# cppcheck_suppressions.txt, which gives a reason for each exception. Prints the findings, and fails if there is one.
# Takes about ten minutes. Everything is written below build/static_analysis, or WORK_FOLDER.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=${WORK_FOLDER:-$root/build/static_analysis}
mkdir -p "$work"
"$root/scripts/install_needs.sh" clang-tidy cppcheck libcgal-dev libboost-program-options-dev libeigen3-dev || exit 1
cd "$root" || exit 1

# The program instantiates most headers, the examples the others.
flags=(-std=c++17 -Iinclude -frounding-math)
[ -d /usr/include/eigen3 ] && flags+=(-isystem /usr/include/eigen3 -DCGAL_EIGEN3_ENABLED)
printf '%s\n' demo/Surface_mesh_geodesics/*.cpp examples/Surface_mesh_geodesics/*.cpp \
  | xargs --max-procs="${JOBS:-1}" -I{} clang-tidy --quiet {} -- "${flags[@]}" \
    > "$work/clang_tidy.log" 2> "$work/clang_tidy.err"
status_of_tidy=$? # not zero if the run broke off, regardless of findings
of_tidy=$(grep -E '(warning|error): .*\[[a-zA-Z].*\]$' "$work/clang_tidy.log" | sort -u)

grep -v "^#" scripts/cppcheck_suppressions.txt > "$work/suppressions.txt"
cppcheck --std=c++17 --language=c++ --enable=warning,performance,portability --inline-suppr --quiet \
  --suppressions-list="$work/suppressions.txt" \
  --template='{file}:{line}: {severity}: {message} [{id}]' \
  -j "${JOBS:-1}" -Iinclude include demo/Surface_mesh_geodesics/*.cpp 2> "$work/cppcheck.log"
status_of_cppcheck=$?
of_cppcheck=$(grep -E ': (error|warning|performance|portability): ' "$work/cppcheck.log" | sort -u)

number_of_lines() { [ -z "$1" ] && echo 0 || wc -l <<< "$1"; }
[ -z "$of_tidy" ] || echo "$of_tidy"
[ -z "$of_cppcheck" ] || echo "$of_cppcheck"
echo "clang-tidy: $(number_of_lines "$of_tidy") findings; cppcheck: $(number_of_lines "$of_cppcheck") findings"
[ $status_of_tidy -eq 0 ] || echo "clang-tidy failed, see $work/clang_tidy.err"
[ $status_of_cppcheck -eq 0 ] || echo "cppcheck failed, see $work/cppcheck.log"
[ -z "$of_tidy$of_cppcheck" ] && [ $status_of_tidy -eq 0 ] && [ $status_of_cppcheck -eq 0 ]
