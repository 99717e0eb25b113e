#!/usr/bin/env bash
# Computes the exact distances from one vertex to all others on a scan with 75,000 faces, as numbers and as a colored
# mesh: installs what is needed, builds the example in Release mode and runs it. Everything is written below build/.
# Arguments replace those of the example: a mesh, and the index of the source vertex.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
data=$build/cgal_data

needs=(g++ cmake make libcgal-dev)
[ $# -gt 0 ] || needs+=(libcgal-demo) # has the scan
"$root/scripts/install_needs.sh" "${needs[@]}"

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DSurface_mesh_geodesics_EXAMPLES=ON -DSurface_mesh_geodesics_TESTS=OFF -DSurface_mesh_geodesics_BENCHMARK=OFF \
  -DSurface_mesh_geodesics_PROGRAM=OFF
cmake --build "$build" --target distances_as_colored_mesh --parallel "${JOBS:-$(nproc)}"

if [ $# -eq 0 ] && [ ! -f "$data/data/meshes/bunny00.off" ]; then
  archive=/usr/share/doc/libcgal-dev/data.tar.gz
  if [ ! -f "$archive" ]; then
    # Slim images of Debian do not install /usr/share/doc: takes the file out of the package.
    mkdir -p "$build/libcgal-demo"
    (cd "$build/libcgal-demo" && apt-get download libcgal-demo && dpkg-deb --extract libcgal-demo_*.deb .)
    archive=$build/libcgal-demo$archive
  fi
  mkdir -p "$data"
  tar --extract --gzip --file "$archive" --directory "$data" data/meshes/bunny00.off
fi

if [ $# -eq 0 ]; then
  set -- "$data/data/meshes/bunny00.off"
fi
arguments=()
for argument in "$@"; do
  if [ -f "$argument" ]; then
    argument=$(realpath "$argument") # the example runs in another folder
  fi
  arguments+=("$argument")
done
mkdir -p "$build/main_job"
cd "$build/main_job"
"$build/examples/Surface_mesh_geodesics/distances_as_colored_mesh" "${arguments[@]}"
echo "The results are in $build/main_job"
