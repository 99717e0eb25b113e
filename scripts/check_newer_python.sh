#!/usr/bin/env bash
# Installs the Python module with pip and runs its tests with Python, NumPy, pybind11, CGAL and the compiler of a newer
# Debian, which is unpacked into a folder and not installed. Needs root, for chroot, and the network; ten minutes.
# Everything is written below build/, or WORK_FOLDER.
# usage: check_newer_python.sh [RELEASE [arguments of pytest]]
# RELEASE is the name of a Debian release (default: trixie, with Python 3.13 and NumPy 2). JOBS is the number of jobs.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
release=${1:-trixie}
[ $# -eq 0 ] || shift
work=${WORK_FOLDER:-$root/build/python_of_$release}
system=$work/system

# apt-get uses its own lists and its own table of installed packages, which is empty: it fetches whatever is needed.
apt=$work/apt
mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
site=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $site $release main" > "$apt/sources.list"
: > "$apt/status"
options=(-o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=- -o "Dir::State::lists=$apt/lists"
  -o "Dir::State::status=$apt/status" -o "Dir::Cache=$apt/cache" -o APT::Sandbox::User=root)
apt-get "${options[@]}" --quiet update
apt-get "${options[@]}" --quiet --yes --no-install-recommends --download-only install base-files bash coreutils dash \
  findutils g++ grep libcgal-dev libjs-three libtbb-dev pybind11-dev python3-dev python3-joblib python3-matplotlib \
  python3-numpy python3-pip python3-pybind11 python3-pytest python3-scipy python3-setuptools python3-wheel sed

# No script of a package runs. What these would have set up and is needed: the null device, the folder of semaphores,
# the certificates, without which pip does not start, and the names of BLAS (below).
rm -rf "$system"
mkdir -p "$system"
for package in "$apt"/cache/archives/base-files_*.deb "$apt"/cache/archives/*.deb; do
  dpkg --extract "$package" "$system"
done
mknod -m 666 "$system/dev/null" c 1 3
mkdir -m 1777 "$system/dev/shm"
mkdir -p "$system/etc/ssl/certs"
cat "$system"/usr/share/ca-certificates/mozilla/*.crt > "$system/etc/ssl/certs/ca-certificates.crt"
mkdir -p "$system/package"
git -C "$root" archive HEAD | tar -x -C "$system/package"

run() {
  local libraries=/usr/lib/$(uname -m)-linux-gnu
  chroot "$system" /usr/bin/env -i PATH=/usr/bin HOME=/root LC_ALL=C.UTF-8 MPLBACKEND=Agg PYTHONDONTWRITEBYTECODE=1 \
    "LD_LIBRARY_PATH=$libraries/blas:$libraries/lapack" "SURFACE_MESH_GEODESICS_JOBS=${JOBS:-$(nproc)}" \
    PYTHONPATH=/site "$@"
}
start=$SECONDS
run python3 -m pip install --quiet --no-build-isolation --no-deps --no-index --target /site /package/python
echo "pip install: $((SECONDS - start)) s"
run python3 -c "
import sys, numpy, pybind11, surface_mesh_geodesics as smg
print('Python', sys.version.split()[0], 'NumPy', numpy.__version__, 'pybind11', pybind11.__version__, smg.__version__)"
run python3 -m pytest -q -p no:cacheprovider /package/python/tests "$@"
run python3 /package/python/examples/tour.py /tmp/tour
