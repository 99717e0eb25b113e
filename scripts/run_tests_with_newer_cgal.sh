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
source "$root/scripts/build_and_test.sh"
install_needs_of_tests

# apt-get uses its own lists, and those of the system do not change.
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
grep -h 'define CGAL_VERSION ' "$work/package/usr/include/CGAL/version.h"
configure "$work/build" "-O1;-UNDEBUG" -DCGAL_DIR="$(dirname "$config")"
cmake --build "$work/build" --parallel "$jobs"
run_ctest "$work/build" "$@"
