#!/usr/bin/env bash
# Builds the program for the command line for Windows, with MinGW-w64, and prints the name of a script that runs it in
# Wine. WORK_FOLDER is the folder to build in (default: build/program_windows).
#
# Debian has no library Boost.Program_options for MinGW-w64, so this compiles it from Debian's sources of Boost, which
# apt-get loads into the work folder. BOOST_ROOT may name a Boost for MinGW-w64 with this library instead. There is no
# TBB and no MPI for it, either: the program computes with one thread, and --mpi is rejected. `wine` runs the program.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/own_archive.sh"
work=${WORK_FOLDER:-$root/build/program_windows}
compiler=x86_64-w64-mingw32-g++-posix
mkdir -p "$work"
work=$(cd "$work" && pwd)
log=$work/build.log
: > "$log"

# The headers of CGAL and Boost are the same everywhere. The cross compiler must not see others of this machine.
cgal=$(dirname "$(dirname "$(echo '#include <CGAL/version.h>' | g++ -M -x c++ - | grep -o '/[^ ]*/CGAL/version.h')")")
cgal_files=$(find "$cgal"/../lib /usr/share -path '*/CGAL/CGALConfig.cmake' -printf '%h\n' -quit)
libraries=$work/libraries
mkdir -p "$libraries/include" "$libraries/lib/cmake"
ln -sfn "$cgal/CGAL" "$libraries/include/CGAL"
ln -sfn "$(realpath "$cgal_files")" "$libraries/lib/cmake/CGAL"

# Loads the sources of Debian's Boost.
unpack_boost()
{
  local apt=$work/apt package
  open_archive "$apt" deb-src this >> "$log" 2>&1
  package=$(dpkg-query --search "$(realpath "$cgal/boost/version.hpp")" | sed 's/:.*//')
  (cd "$apt" && "${archive[@]}" source --download-only \
    "$(dpkg-query --show --showformat '${source:Package}' "$package")") >> "$log" 2>&1
  tar -xJf "$apt"/boost*.orig.tar.xz -C "$work" --wildcards '*/libs/program_options/src/*.cpp'
}

if [ -z "${BOOST_ROOT:-}" ]; then
  BOOST_ROOT=$libraries
  ln -sfn "$cgal/boost" "$libraries/include/boost"
  if [ ! -f "$libraries/lib/libboost_program_options.a" ]; then
    unpack_boost
    objects=()
    for source in "$work"/boost*/libs/program_options/src/*.cpp; do
      objects+=("$work/$(basename "$source" .cpp).o")
      "$compiler" -std=c++17 -O2 -DBOOST_BIND_GLOBAL_PLACEHOLDERS -I"$libraries/include" -c "$source" \
        -o "${objects[-1]}" >> "$log" 2>&1
    done
    x86_64-w64-mingw32-ar rcs "$libraries/lib/libboost_program_options.a" "${objects[@]}"
  fi
fi

cmake -S "$root" -B "$work/build" -G Ninja -DCMAKE_SYSTEM_NAME=Windows -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_RC_COMPILER=x86_64-w64-mingw32-windres -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXE_LINKER_FLAGS=-static \
  "-DCMAKE_FIND_ROOT_PATH=/usr/x86_64-w64-mingw32;$BOOST_ROOT" -DCMAKE_FIND_ROOT_PATH_MODE_LIBRARY=ONLY \
  -DCGAL_DIR="$libraries/lib/cmake/CGAL" -DCGAL_DISABLE_GMP=ON -DBOOST_ROOT="$BOOST_ROOT" \
  -DBoost_NO_SYSTEM_PATHS=ON -DBoost_NO_BOOST_CMAKE=ON -DBoost_USE_STATIC_LIBS=ON -DCMAKE_DISABLE_FIND_PACKAGE_TBB=ON \
  -DSurface_mesh_geodesics_TESTS=OFF -DSurface_mesh_geodesics_EXAMPLES=OFF -DSurface_mesh_geodesics_BENCHMARK=OFF \
  -DSurface_mesh_geodesics_MPI=OFF -DSurface_mesh_geodesics_PROGRAM_FLAGS=-O1 \
  -DSurface_mesh_geodesics_GROUP_PROGRAMS=ON -DSurface_mesh_geodesics_WARNINGS_AS_ERRORS=ON >> "$log" 2>&1
cmake --build "$work/build" --target surface_mesh_geodesics_program -j "${JOBS:-$(nproc)}" >> "$log" 2>&1

program=$work/build/demo/Surface_mesh_geodesics/surface_mesh_geodesics.exe
cat > "$work/surface_mesh_geodesics" <<END
#!/bin/sh
WINEDEBUG=-all WINEPREFIX='$work/wine' exec wine '$program' "\$@"
END
chmod +x "$work/surface_mesh_geodesics"
echo "$work/surface_mesh_geodesics"
