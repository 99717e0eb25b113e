#!/usr/bin/env bash
# Compiles all headers and one program with each compiler and for each platform that Debian can run here, and compares
# the bits of all answers. Prints the table of the manual (doc/Surface_mesh_geodesics/Platforms.txt).
# usage: check_platforms.sh [--install] [--tests] [NAME...]
#        check_platforms.sh --list
# --install installs the compilers and emulators, and unpacks the headers of CGAL 6, first. NAME is the beginning of a
# row, such as "ARM64" (default: all); --list prints the names. The first row is also run for rows that compare their
# bits with it. --tests also runs test programs in the emulators (run_tests_emulated.sh): those of the list
# `tests_for_arm64` below, and those of the quick check on Windows, which takes half an hour more.
# A row that cannot run here says why. NEWER_CGAL is the include folder of CGAL 6, for compilers that CGAL 5.5 does not
# know (default: what --install and run_tests_with_newer_cgal.sh have unpacked). PROGRAM is the program for the command
# line of this machine, for the comparison with that for Windows (default: it is built). WORK_FOLDER is the folder to
# build in. It takes about half an hour. NEWEST_CGAL is another include folder of CGAL: that of the newest Debian.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/own_archive.sh"
work=${WORK_FOLDER:-$root/build/platforms}
mkdir -p "$work/headers"
work=$(cd "$work" && pwd)

if [ "${1:-}" = --install ]; then
  shift
  apt-get install --yes --quiet --no-install-recommends g++ g++-11 clang-14 clang-19 libc++-14-dev libc++abi-14-dev \
    g++-aarch64-linux-gnu qemu-user-static g++-mingw-w64-x86-64-posix wine64 wine > "$work/install.log"
  unpack_newer_cgal "$root/build/cgal_of_trixie" trixie >> "$work/install.log"
  unpack_newer_cgal "$root/build/cgal_of_sid" sid >> "$work/install.log"
fi

with_tests=no only_names=no
if [ "${1:-}" = --tests ]; then
  shift
  with_tests=yes
elif [ "${1:-}" = --list ]; then
  shift
  with_tests=yes only_names=yes
fi
wanted=("$@")

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
newest_cgal=${NEWEST_CGAL:-$root/build/cgal_of_sid/package/usr/include}
common=(-std=c++17 -DNDEBUG "-I$root/include" "-I$root/test/Surface_mesh_geodesics/include")

# Lanes, threads, distances, curves, paths, diagrams: programs that an emulator runs in seconds or a few minutes.
tests_for_arm64=(test_numbers_of_lanes test_rounded_products test_parallel_propagation test_work_sharing
  test_distances_analytic test_distances_in_the_plane test_distance_solver test_scales
  test_small_components test_curves test_paths_interface test_certification_of_distances
  test_Voronoi_by_hand test_Voronoi_planar test_Voronoi_symmetric test_Voronoi_interface test_Voronoi_cut
  test_certification_of_Voronoi_diagrams)

# --- the rows --------------------------------------------------------------------------------------------------------

reference=
reference_name="g++ $(g++ -dumpfullversion)"
status=0

# Is a row to be run? If only names are asked for, prints the name.
is_wanted()
{
  if [ "$only_names" = yes ]; then
    printf '%s\n' "$1"
    return 1
  fi
  [ ${#wanted[@]} -gt 0 ] || return 0
  local prefix
  for prefix in "${wanted[@]}"; do
    case "$1" in "$prefix"*) return 0 ;; esac
  done
  return 1
}

# are_installed ROW COMMAND...: prints the row if a command is missing; "direct" is none.
are_installed()
{
  local row=$1 command
  shift
  for command in "$@"; do
    if [ "$command" != direct ] && ! command -v "$command" > /dev/null; then
      printf '| %s | not run: there is no %s here | |\n' "$row" "$command"
      return 1
    fi
  done
}

# row NAME RUNNER COMPILER FLAGS...: one row of the table. RUNNER starts the program: "direct", or an emulator. Flags
# behind "--" are for the linker.
row()
{
  local name=$1 runner=$2 compiler=$3
  is_wanted "$name" || return 0
  are_installed "$name" "$compiler" "$runner" || return 0
  if [ -z "$reference" ] && [ "$name" != "$reference_name" ]; then
    local wanted=() # the reference is run although it is not wanted
    reference_row
  fi
  shift 3
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

reference_row()
{
  row "$reference_name" direct g++ -frounding-math -- -lgmp -lmpfr
}

# row_with_cgal NAME COMPILER FOLDER FLAGS...: a row with the CGAL of a folder, whose version ends the name.
row_with_cgal()
{
  local name=$1 compiler=$2 folder=$3
  shift 3
  if [ "$only_names" = no ] && ! grep -qs "define CGAL_VERSION ${name##* }" "$folder/CGAL/version.h"; then
    ! is_wanted "$name" || printf '| %s | not run: it is not in %s | |\n' "$name" "$folder"
    return 0
  fi
  row "$name" direct "$compiler" "$@" -isystem "$folder" -- -lgmp -lmpfr
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

# The program for the command line: it writes the same files on Windows as here.
program_row()
{
  local name=$1 log=$work/program.log here=${PROGRAM:-} there answers headers=compile
  is_wanted "$name" || return 0
  are_installed "$name" x86_64-w64-mingw32-g++-posix wine || return 0
  if ! there=$(WORK_FOLDER=$work/program_windows bash "$root/scripts/build_program_for_windows.sh" 2> "$log"); then
    headers=FAIL answers="does not build, see $work/program_windows/build.log"
  elif [ -z "$here" ] && ! here=$(build_program_here); then
    answers="the program of this machine does not build, see $log"
  elif ! write_files "$here" "$work/files_here" || ! write_files "$there" "$work/files_windows"; then
    answers="ends with an error, see $log"
  elif answers=$(diff --brief -r "$work/files_here" "$work/files_windows"); then
    answers="the same $(find "$work/files_here" -type f | wc -l) files"
  else
    answers="other files: $(echo "$answers" | sed -n 's|.* and .*/\(.*\) differ$|\1|p' | paste -sd ' ')"
  fi
  printf '| %s | %s | %s |\n' "$name" "$headers" "$answers"
  case "$answers" in "the same "*) ;; *) status=1 ;; esac
}

# Prints the name of the program.
build_program_here()
{
  {
    cmake -S "$root" -B "$work/program" -DCMAKE_BUILD_TYPE=Release -DSurface_mesh_geodesics_TESTS=OFF \
      -DSurface_mesh_geodesics_EXAMPLES=OFF -DSurface_mesh_geodesics_BENCHMARK=OFF -DSurface_mesh_geodesics_MPI=OFF \
      -DSurface_mesh_geodesics_PROGRAM_FLAGS=-O1 -DSurface_mesh_geodesics_GROUP_PROGRAMS=ON
    cmake --build "$work/program" --target surface_mesh_geodesics_program -j "${JOBS:-$(nproc)}"
  } >> "$work/program.log" 2>&1
  echo "$work/program/demo/Surface_mesh_geodesics/surface_mesh_geodesics"
}

# write_files PROGRAM FOLDER: what each subcommand writes. Diagrams are those of a grid, whose arcs have no angles: the
# libraries differ in the last digit of std::tan().
write_files()
{
  rm -rf "$2"
  mkdir -p "$2"
  (
    cd "$2"
    cp "${meshes[0]}" sphere.off
    cp "$data/grid9.off" grid.off
    "$1" info sphere.off > info.csv
    "$1" distances sphere.off --source 0 --source-point 1,0,0 --snap -o distances.csv -o colors.ply -o colors.vtu
    "$1" path sphere.off --source 0 --target 100,200 -o paths.csv -o paths.obj -o paths.vtk
    "$1" voronoi grid.off --site 0,9,90 -o cells.csv -o cells.vtk
    "$1" sample sphere.off --number 20 --first 0 -o samples.csv
    "$1" matrix sphere.off --source 0,10,20 --target all > matrix.csv
    "$1" matrix sphere.off --source 0,10,20,30 --store store > stored.csv
    "$1" matrix --status store > status.csv
    "$1" matrix --verify store sphere.off > verified.csv
    "$1" check sphere.off --source 0 --distances distances.csv > check.csv || echo "status $?" >> check.csv
    rm -f store/manifest.json # it has the absolute name of the mesh
  ) >> "$work/program.log" 2>&1
}

# tests_row NAME PLATFORM COMPILER RUNNER [TEST...]
tests_row()
{
  local name=$1 platform=$2
  is_wanted "$name" || return 0
  are_installed "$name" "$3" "$4" || return 0
  WORK_FOLDER=$work/tests_$platform bash "$root/scripts/run_tests_emulated.sh" "$platform" "${@:5}" \
    > "$work/tests_$platform.txt" 2>&1 || status=1
  printf '| %s | | %s |\n' "$name" "$(tail -n 1 "$work/tests_$platform.txt")"
}

# --- the table -------------------------------------------------------------------------------------------------------

libraries=(-- -lgmp -lmpfr)
[ "$only_names" = yes ] || printf '| platform | headers | answers |\n|---|---|---|\n'
reference_row
row "g++-11" direct g++-11 -frounding-math "${libraries[@]}"
row "g++, one instruction set" direct g++ -frounding-math -DCGAL_SURFACE_MESH_GEODESICS_ONE_INSTRUCTION_SET \
  "${libraries[@]}"
row "g++, one lane" direct g++ -frounding-math -DCGAL_SURFACE_MESH_GEODESICS_NO_SIMD "${libraries[@]}"
row "g++, two lanes in classes" direct g++ -frounding-math -DCGAL_SURFACE_MESH_GEODESICS_NO_VECTOR_EXTENSION \
  "${libraries[@]}"
row "g++, -march=native" direct g++ -frounding-math -march=native -ffp-contract=off "${libraries[@]}"
row "clang++-14" direct clang++-14 "${libraries[@]}"
row "clang++-14 with libc++" direct clang++-14 -stdlib=libc++ "${libraries[@]}"
row_with_cgal "clang++-19, CGAL 6.0" clang++-19 "$newer_cgal"
row_with_cgal "g++, CGAL 6.2" g++ "$newest_cgal" -frounding-math
row_with_cgal "clang++-19, CGAL 6.2" clang++-19 "$newest_cgal"
# Clang as close to Visual C++ as it comes with the headers of this system, which need some macros that are gone then.
{ clang++-14 -dM -E -x c++ /dev/null 2> /dev/null || true; } | grep __GCC_ATOMIC > "$work/macros_of_gcc.h" || true
row "clang++-14 as Visual C++" direct clang++-14 -fms-compatibility -fms-compatibility-version=19.29 -fms-extensions \
  -fdelayed-template-parsing -U__OPTIMIZE__ -include "$work/macros_of_gcc.h" "${libraries[@]}"
row "ARM64, g++ 12, emulated" qemu-aarch64-static aarch64-linux-gnu-g++ -frounding-math -ffp-contract=off "${cross[@]}"
row "Windows, MinGW-w64, Wine" wine x86_64-w64-mingw32-g++-posix -frounding-math "${cross[@]}"
program_row "program for the command line, Windows, MinGW-w64, Wine"
rejected "-ffast-math" -ffast-math "relies on infinities"
rejected "-fno-exceptions" -fno-exceptions "reports invalid input by exceptions"
if [ "$with_tests" = yes ]; then
  tests_row "tests, ARM64, emulated" arm64 aarch64-linux-gnu-g++ qemu-aarch64-static "${tests_for_arm64[@]}"
  tests_row "tests, Windows, Wine" windows x86_64-w64-mingw32-g++-posix wine
fi
exit "$status"
