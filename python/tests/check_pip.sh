#!/usr/bin/env bash
# usage: check_pip.sh PYTHON WORK_FOLDER
# `pip install ./python` in a copy of the package, and a call of what it has installed. Exits with 77 if pip, setuptools
# or pybind11 is missing.
set -euo pipefail
python=$1
work=$2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
"$python" -c "import setuptools, wheel, pybind11, pip" 2> /dev/null || exit 77

rm -rf "$work"
mkdir -p "$work/package/demo/Surface_mesh_geodesics"
cp -r "$root/python" "$root/include" "$root/CMakeLists.txt" "$work/package"
cp -r "$root/demo/Surface_mesh_geodesics/page" "$work/package/demo/Surface_mesh_geodesics"
"$python" -m pip install --quiet --no-build-isolation --no-deps --no-index --target "$work/site" "$work/package/python"
cd "$work"
PYTHONPATH=$work/site "$python" -c "
import surface_mesh_geodesics as smg
d = smg.Solver([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]]).distances(1)
assert d.tolist() == [3, 0, 5], d
assert (smg.pages.TEMPLATES / 'page.js').is_file()
print(smg.__version__, d)"
