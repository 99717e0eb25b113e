#!/usr/bin/env bash
# Builds the test programs of the headers for another platform, runs them in an emulator, and prints how many pass.
# usage: run_tests_emulated.sh windows|arm64 [NAME...]
#   windows  MinGW-w64 and Wine; without TBB, which Debian does not have for Windows
#   arm64    the cross compiler g++ and QEMU; with the libtbb of Debian for ARM64, which is unpacked and not installed
# NAME is the name of a test program, such as test_paths (default: those of the quick check). FLAGS are those of the
# compiler (default: -O1, with assertions). WORK_FOLDER is the folder to build in. Programs are compiled in groups, as
# in the quick check. A program without a result within SECONDS_PER_PROGRAM (default 1800) seconds has failed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/own_archive.sh"
platform=${1:?windows or arm64}
shift
work=${WORK_FOLDER:-$root/build/tests_$platform}
tests=$root/test/Surface_mesh_geodesics
mkdir -p "$work/headers"
work=$(cd "$work" && pwd)
read -r -a flags <<< "${FLAGS:--O1}"

# Cross compilers must not see the headers of this machine, but CGAL, Boost and Eigen, which are the same everywhere.
cgal=$(dirname "$(dirname "$(echo '#include <CGAL/version.h>' | g++ -M -x c++ - | grep -o '/[^ ]*/CGAL/version.h')")")
ln -sfn "$cgal/CGAL" "$work/headers/CGAL"
ln -sfn "$cgal/boost" "$work/headers/boost"
[ ! -d /usr/include/eigen3/Eigen ] || ln -sfn /usr/include/eigen3/Eigen "$work/headers/Eigen"
flags+=(-std=c++17 -frounding-math "-I$root/include" "-I$tests/include" -isystem "$work/headers" -DCGAL_DISABLE_GMP
  -DCGAL_DISABLE_MPFR -DBOOST_ERROR_CODE_HEADER_ONLY -DCGAL_EIGEN3_ENABLED)
libraries=()

# Unpacks TBB for ARM64.
unpack_tbb()
{
  local apt=$work/apt package
  [ ! -e "$work/tbb/usr/include/tbb/tbb.h" ] || return 0
  open_archive "$apt" deb this arm64 > "$work/apt.log"
  (cd "$apt" && "${archive[@]}" download libtbb-dev libtbb12 libtbbmalloc2) >> "$work/apt.log"
  for package in "$apt"/*.deb; do
    dpkg -x "$package" "$work/tbb"
  done
}

case "$platform" in
  windows)
    compiler=x86_64-w64-mingw32-g++-posix
    export WINEDEBUG=-all WINEPREFIX=$work/wine
    emulator=(wine)
    libraries=(-static)
    ;;
  arm64)
    compiler=aarch64-linux-gnu-g++
    unpack_tbb
    flags+=(-ffp-contract=off -isystem "$work/tbb/usr/include" -DCGAL_LINKED_WITH_TBB)
    libraries=("-L$work/tbb/usr/lib/aarch64-linux-gnu" -ltbb -ltbbmalloc)
    emulator=(qemu-aarch64-static -L /usr/aarch64-linux-gnu
      -E "LD_LIBRARY_PATH=$work/tbb/usr/lib/aarch64-linux-gnu")
    ;;
  *)
    echo "unknown platform: $platform" >&2
    exit 2
    ;;
esac

# --- the programs, in groups -------------------------------------------------------------------------------------------

# The quick check without what is in the long check only, and what reads meshes that are not here.
quick_tests()
{
  (cd "$tests" && ls test_*.cpp) | sed 's/\.cpp$//' \
    | grep -vxE 'test_(schedulers|differences|bounded_cost|Voronoi_against_shortest_path)'
}

names=("$@")
[ $# -gt 0 ] || mapfile -t names < <(quick_tests)
singles=() grouped=()
for name in "${names[@]}"; do
  if grep -qE '^#(define|undef|pragma)' "$tests/$name.cpp"; then
    singles+=("$name")
  else
    grouped+=("$name")
  fi
done

passed=0
failures=()

# compile PROGRAM SOURCE
compile()
{
  "$compiler" "${flags[@]}" "$2" -o "$1" "${libraries[@]}" > "$1.log" 2>&1
}

# run PROGRAM NAME: the name decides which program of a group runs.
run()
{
  local status=0
  [ "$1" = "$work/$2.exe" ] || ln -f "$1" "$work/$2.exe"
  (cd "$tests" && timeout "${SECONDS_PER_PROGRAM:-1800}" "${emulator[@]}" "$work/$2.exe" < /dev/null) \
    > "$work/$2.txt" 2>&1 || status=$?
  if [ $status -eq 0 ]; then
    passed=$((passed + 1))
  else
    failures+=("$2")
  fi
  printf '%-45s %s\n' "$2" "$([ $status -eq 0 ] && tail -n 1 "$work/$2.txt" | tr -d '\r' || echo "FAILED ($status)")"
}

for ((i = 0; i < ${#grouped[@]}; i += 10)); do
  part=("${grouped[@]:i:10}")
  sources=("${part[@]/#/$tests/}")
  unit=$work/group_$((i / 10))
  cmake "-Doutput=$unit.cpp" "-Dsources=$(IFS=';'; echo "${sources[*]/%/.cpp}")" \
    -P "$root/cmake/write_program_group.cmake"
  if compile "$unit.exe" "$unit.cpp"; then
    for name in "${part[@]}"; do run "$unit.exe" "$name"; done
  else
    # One of them does not compile: each alone.
    singles=("${part[@]}" "${singles[@]}")
  fi
done
for name in "${singles[@]}"; do
  if compile "$work/$name.exe" "$tests/$name.cpp"; then
    run "$work/$name.exe" "$name"
  else
    failures+=("$name")
    printf '%-45s %s\n' "$name" "does not compile"
  fi
done

echo "$passed of ${#names[@]} test programs pass${failures[0]:+; not: ${failures[*]}}"
[ ${#failures[@]} -eq 0 ]
