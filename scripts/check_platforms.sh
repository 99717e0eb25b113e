#!/usr/bin/env bash
# Compiles all headers and one program with each compiler and for each platform that Debian can run here, and compares
# the bits of all answers. Prints the table of the manual (doc/Surface_mesh_geodesics/Platforms.txt).
# usage: check_platforms.sh [--install] [--tests] [NAME...]
# --install installs the compilers and emulators first. NAME is the beginning of a row, such as "ARM64" (default: all).
# --tests also runs the test programs for Windows and ARM64 (run_tests_emulated.sh), which takes hours.
# A row whose compiler is not installed says so. NEWER_CGAL is the include folder of CGAL 6, for compilers that CGAL 5.5
# does not know (default: what run_tests_with_newer_cgal.sh has unpacked). WORK_FOLDER is the folder to build in. It
# takes about ten minutes.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=${WORK_FOLDER:-$root/build/platforms}
mkdir -p "$work/headers"

if [ "${1:-}" = --install ]; then
  shift
  apt-get install --yes --quiet --no-install-recommends g++ g++-11 clang-14 clang-19 libc++-14-dev libc++abi-14-dev \
    g++-aarch64-linux-gnu qemu-user-static g++-mingw-w64-x86-64-posix wine64 wine > "$work/install.log"
fi

with_tests=no
if [ "${1:-}" = --tests ]; then
  shift
  with_tests=yes
fi

# --- what is compiled ------------------------------------------------------------------------------------------------

# All headers, after macros with short names such as those of Windows.
{
  echo '#include "macros_of_other_headers.h"'
  (cd "$root/include" && find CGAL/Surface_mesh_geodesics* -name '*.h' | LC_ALL=C sort) | sed 's/.*/#include <&>/'
  echo 'int main() {}'
} > "$work/all_headers.cpp"
hashes=$root/test/Surface_mesh_geodesics/determinism/print_hashes.cpp
data=$root/test/Surface_mesh_geodesics/data
meshes=("$root/examples/Surface_mesh_geodesics/data/bumpy_sphere.off" "$data/cube.off" "$data/grid9.off"
  "$data/cone64.off" "$data/saddle_fan8.off" "$data/needle_1e-12.off")

# Cross compilers must not see the headers of this machine, but CGAL and Boost, which are the same everywhere. They do
# without GMP and MPFR.
cgal=$(dirname "$(dirname "$(echo '#include <CGAL/version.h>' | g++ -M -x c++ - | grep -o '/[^ ]*/CGAL/version.h')")")
cross_include=$work/headers
for library in CGAL boost; do
  ln -sfn "$cgal/$library" "$cross_include/$library"
done
cross=(-isystem "$cross_include" -DCGAL_DISABLE_GMP -DCGAL_DISABLE_MPFR -DBOOST_ERROR_CODE_HEADER_ONLY -static)
newer_cgal=${NEWER_CGAL:-$root/build/cgal_of_trixie/package/usr/include}
common=(-std=c++17 -DNDEBUG "-I$root/include" "-I$root/test/Surface_mesh_geodesics/include")

# --- the rows --------------------------------------------------------------------------------------------------------

reference=
status=0

# row NAME RUNNER COMPILER FLAGS...: one row of the table. RUNNER starts the program: "direct", or an emulator. Flags
# behind "--" are for the linker.
row()
{
  local name=$1 runner=$2 compiler=$3
  shift 3
  is_wanted "$name" || return 0
  if ! command -v "$compiler" > /dev/null || { [ "$runner" != direct ] && ! command -v "$runner" > /dev/null; }; then
    printf '| %s | not installed | |\n' "$name"
    return 0
  fi
  local flags=() libraries=()
  while [ $# -gt 0 ] && [ "$1" != -- ]; do flags+=("$1"); shift; done
  [ $# -eq 0 ] || libraries=("${@:2}")
  local file=$work/${name//[^A-Za-z0-9]/_} headers=compile answers
  "$compiler" "${common[@]}" "${flags[@]}" -fsyntax-only "$work/all_headers.cpp" > "$file.log" 2>&1 || headers=FAIL
  if ! "$compiler" "${common[@]}" "${flags[@]}" -O2 "$hashes" -o "$file.exe" "${libraries[@]}" >> "$file.log" 2>&1; then
    answers="does not compile"
  elif ! run "$runner" "$file.exe" > "$file.txt" 2>> "$file.log"; then
    answers="ends with an error"
  elif [ -z "$reference" ]; then
    reference=$file.txt
    answers="the reference"
  elif cmp --silent "$reference" "$file.txt"; then
    answers="the same bits"
  elif [ "$runner" = wine ] \
    && cmp --silent <(sed 's/ diagram.*//' "$reference") <(sed 's/ diagram.*//' "$file.txt"); then
    answers="the same bits; diagrams, which use std::tan() of another library, differ in last digits"
  else
    answers="other bits"
  fi
  printf '| %s | %s | %s |\n' "$name" "$headers" "$answers"
  case "$headers $answers" in "compile the "*) ;; *) status=1 ;; esac
}

is_wanted()
{
  [ ${#wanted[@]} -gt 0 ] || return 0
  [ -n "$reference" ] || return 0 # the first row is the reference for all
  local prefix
  for prefix in "${wanted[@]}"; do
    case "$1" in "$prefix"*) return 0 ;; esac
  done
  return 1
}

# run RUNNER PROGRAM: prints the hashes of all meshes, with the ends of lines of this system and without paths.
run()
{
  local command=("$2") files=("${meshes[@]}")
  if [ "$1" = wine ]; then
    command=(env WINEDEBUG=-all "WINEPREFIX=$work/wine" wine "$2")
    files=("${meshes[@]/#/Z:}")
  elif [ "$1" != direct ]; then
    command=("$1" "$2")
  fi
  "${command[@]}" "${files[@]}" | tr -d '\r' | sed 's|[^ ]*/||'
}

# rejected NAME FLAG WORDS: all compilers here stop with these words.
rejected()
{
  local compiler
  is_wanted "$1" || return 0
  for compiler in g++ clang++; do
    "$compiler" "${common[@]}" "$2" -fsyntax-only "$work/all_headers.cpp" > "$work/rejected.log" 2>&1 || true
    if grep -q "error.*$3" "$work/rejected.log"; then
      continue
    fi
    printf '| %s | FAIL: %s accepts it | |\n' "$1" "$compiler"
    status=1
    return 0
  done
  printf '| %s | rejected with a reason | |\n' "$1"
}

wanted=("$@")
libraries=(-- -lgmp -lmpfr)
printf '| platform | headers | answers |\n|---|---|---|\n'
row "g++ $(g++ -dumpfullversion)" direct g++ -frounding-math "${libraries[@]}"
row "g++-11" direct g++-11 -frounding-math "${libraries[@]}"
row "g++, one instruction set" direct g++ -frounding-math -DCGAL_SURFACE_MESH_GEODESICS_ONE_INSTRUCTION_SET \
  "${libraries[@]}"
row "g++, one lane" direct g++ -frounding-math -DCGAL_SURFACE_MESH_GEODESICS_NO_SIMD "${libraries[@]}"
row "g++, two lanes in classes" direct g++ -frounding-math -DCGAL_SURFACE_MESH_GEODESICS_NO_VECTOR_EXTENSION \
  "${libraries[@]}"
row "g++, -march=native" direct g++ -frounding-math -march=native -ffp-contract=off "${libraries[@]}"
row "clang++-14" direct clang++-14 "${libraries[@]}"
row "clang++-14 with libc++" direct clang++-14 -stdlib=libc++ "${libraries[@]}"
if [ -d "$newer_cgal/CGAL" ]; then
  row "clang++-19, CGAL 6" direct clang++-19 -isystem "$newer_cgal" "${libraries[@]}"
fi
row "clang++-14, extensions of Visual C++" direct clang++-14 -fms-extensions -fdelayed-template-parsing \
  "${libraries[@]}"
row "ARM64, g++ 12, emulated" qemu-aarch64-static aarch64-linux-gnu-g++ -frounding-math -ffp-contract=off "${cross[@]}"
row "Windows, MinGW-w64, Wine" wine x86_64-w64-mingw32-g++-posix -frounding-math "${cross[@]}"
rejected "-ffast-math" -ffast-math "relies on infinities"
rejected "-fno-exceptions" -fno-exceptions "reports invalid input by exceptions"
if [ "$with_tests" = yes ]; then
  for platform in windows arm64; do
    WORK_FOLDER=$work/tests_$platform bash "$root/scripts/run_tests_emulated.sh" "$platform" \
      > "$work/tests_$platform.txt" 2>&1 || status=1
    printf '| tests, %s, emulated | | %s |\n' "$platform" "$(tail -n 1 "$work/tests_$platform.txt")"
  done
fi
exit "$status"
