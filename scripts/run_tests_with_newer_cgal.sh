#!/usr/bin/env bash
# Builds everything and runs the tests with the CGAL of a newer Debian, which is unpacked and not installed. Boost, GMP
# and MPFR stay those of this system. Everything it writes is below build/.
# The first argument is the name of the Debian release (trixie if there is none); the others go to ctest. The variable
# JOBS sets the number of jobs at once.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
release=${1:-trixie}
[ $# -eq 0 ] || shift
work=$root/build/cgal_of_$release
jobs=${JOBS:-$(nproc)}

"$root/scripts/install_needs.sh" g++ cmake make libcgal-dev libcgal-demo libboost-program-options-dev \
  libeigen3-dev libjs-three libtbb-dev python3

# apt-get with lists of its own: the system's are not touched
apt=$work/apt
mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
site=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $site $release main" > "$apt/sources.list"
options=(-o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$apt/lists"
  -o "Dir::Cache=$apt/cache" -o APT::Sandbox::User=root)
apt-get "${options[@]}" --quiet update
rm -rf "$work/package" "$apt"/libcgal-dev_*.deb
(cd "$apt" && apt-get "${options[@]}" download libcgal-dev)
dpkg -x "$apt"/libcgal-dev_*.deb "$work/package"

config=$(find "$work/package" -name CGALConfig.cmake)
cmake -S "$root" -B "$work/build" -DCMAKE_BUILD_TYPE=Release -DCGAL_DIR="$(dirname "$config")" \
  -DSurface_mesh_geodesics_WARNINGS_AS_ERRORS=ON -DSurface_mesh_geodesics_EXAMPLES=ON \
  -DSurface_mesh_geodesics_TESTS=ON -DSurface_mesh_geodesics_BENCHMARK=ON \
  -DSurface_mesh_geodesics_PROGRAM=ON
grep -h 'define CGAL_VERSION ' "$work/package/usr/include/CGAL/version.h"
cmake --build "$work/build" --parallel "$jobs"
cd "$work/build"
ctest --output-on-failure --no-tests=error --parallel "$jobs" "$@"
