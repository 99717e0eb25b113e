#!/usr/bin/env bash
# Runs the examples of CGAL's package Surface_mesh_shortest_path with Surface_mesh_geodesic_paths: replaces the include
# and the name of the class, builds and runs both versions, and compares all numbers that they print and write. The
# examples are part of Debian's CGAL.
#
# Usage: run_cgal_examples.sh <include folder> <work folder> [<arguments for cmake> ...]
# The exit status is 77 if the examples are not available.
set -euo pipefail
include=$(cd "$1" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)
shift 2
rm -rf "$work"
mkdir -p "$work"
cd "$work"

skip() {
  echo "SKIPPED: $*"
  exit 77
}

# Slim images of Debian do not install the folder of the archive. In that case, takes the archive out of the package.
find_archive() {
  local name=$1 folder
  for folder in /usr/share/doc/libcgal-dev /usr/share/doc/libcgal-demo; do
    if [ -f "$folder/$name" ]; then
      archive=$folder/$name
      return
    fi
  done
  if [ ! -d package ]; then
    command -v apt-get > /dev/null && command -v dpkg-deb > /dev/null || skip "there is no $name, and no apt-get"
    mkdir package
    (cd package && apt-get download libcgal-demo && dpkg-deb --extract libcgal-demo_*.deb .) > download.log 2>&1 \
      || skip "there is no $name, and the package libcgal-demo cannot be downloaded: $(tail -n 1 download.log)"
  fi
  for folder in package/usr/share/doc/libcgal-dev package/usr/share/doc/libcgal-demo; do
    if [ -f "$folder/$name" ]; then
      archive=$folder/$name
      return
    fi
  done
  skip "the package libcgal-demo has no $name"
}

find_archive examples.tar.gz
tar --extract --gzip --file "$archive" examples/Surface_mesh_shortest_path
find_archive data.tar.gz
tar --extract --gzip --file "$archive" data/meshes/elephant.off
mesh=$PWD/data/meshes/elephant.off

# Both versions write all digits. The example with OpenMesh is omitted.
mkdir before after
examples=()
for source in examples/Surface_mesh_shortest_path/*.cpp; do
  name=$(basename "$source" .cpp)
  case $name in *OpenMesh*) continue ;; esac
  examples+=("$name")
  sed -e 's/std::ofstream output(.*);/&\n  output.precision(17);/' \
    -e '/^int main(/{n;s/{/{ std::cout.precision(17);/}' "$source" > "before/$name.cpp"
  sed -e 's|<CGAL/Surface_mesh_shortest_path.h>|<CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>|' \
    -e 's/CGAL::Surface_mesh_shortest_path</CGAL::Surface_mesh_geodesic_paths</' \
    "before/$name.cpp" > "after/$name.cpp"
  grep -q 'CGAL::Surface_mesh_geodesic_paths<' "after/$name.cpp" || { echo "FAILED: sed left $name as it was"; exit 1; }
  ! grep -q 'CGAL::Surface_mesh_shortest_path<\|Surface_mesh_shortest_path\.h' "after/$name.cpp" \
    || { echo "FAILED: sed left $name as it was"; exit 1; }
done
echo "${#examples[@]} examples: ${examples[*]}"

cat > CMakeLists.txt << END
cmake_minimum_required(VERSION 3.19...3.31)
project(cgal_examples LANGUAGES CXX)
find_package(CGAL REQUIRED)
foreach(version before after)
  foreach(name ${examples[*]})
    add_executable(\${version}_\${name} \${version}/\${name}.cpp)
    target_link_libraries(\${version}_\${name} PRIVATE CGAL::CGAL)
    target_compile_definitions(\${version}_\${name} PRIVATE NDEBUG)
  endforeach()
endforeach()
foreach(name ${examples[*]})
  target_include_directories(after_\${name} PRIVATE "$include")
endforeach()
END
# More optimization would take longer than it saves.
cmake -S . -B build -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS=-O1 "$@" > configure.log 2>&1 \
  || { cat configure.log; exit 1; }
cmake --build build --parallel "${JOBS:-2}" > build.log 2>&1 || { grep -B 2 -A 20 'error' build.log; exit 1; }

# Compares two files line by line. A line "n x y z ..." is a path. Ignores repeated points. Paths that differ must have
# the same length, because there may be several shortest paths.
cat > compare.awk << 'END'
function is_number(s) { return s ~ /^[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?$/ }
function magnitude(x) { return x < 0 ? -x : x }
function differs(x, y,   m) {
  m = magnitude(x) > magnitude(y) ? magnitude(x) : magnitude(y)
  return magnitude(x - y) > tolerance * (m > size ? m : size)
}
# reads the points of a path into p, without repetitions; returns their number and sets path_length
function read_path(fields, n, p,   i, k, d, c) {
  c = 0
  path_length = 0
  for(i = 0; i < n; ++i) {
    d = 0
    for(k = 0; k < 3; ++k) d += (fields[2 + 3 * i + k] - p[c - 1, k]) ^ 2
    if(c > 0 && sqrt(d) <= 1e-9 * size) continue
    if(c > 0) path_length += sqrt(d)
    for(k = 0; k < 3; ++k) p[c, k] = fields[2 + 3 * i + k]
    ++c
  }
  return c
}
{
  line = $0
  ++lines
  if((getline other < second) <= 0) { print "the second output ends at line " FNR; failures = 1; exit }
  n = split(line, a, /[ \t,():#]+/)
  m = split(other, b, /[ \t,():#]+/)
  if(is_number(a[1]) && n - (a[n] == "") == 1 + 3 * a[1] && m - (b[m] == "") == 1 + 3 * b[1]) {
    split("", p); split("", q)
    np = read_path(a, a[1], p); lp = path_length
    nq = read_path(b, b[1], q); lq = path_length
    ++paths
    if(differs(lp, lq)) { print "line " FNR ": length " lp " against " lq; ++failures }
    same = np == nq
    for(i = 0; same && i < np; ++i) for(k = 0; k < 3; ++k) if(differs(p[i, k], q[i, k])) same = 0
    if(!same) ++other_paths
    if(a[1] != b[1]) ++repeated
    next
  }
  if(n != m) { print "line " FNR ": " line " | " other; ++failures; next }
  for(i = 1; i <= n; ++i)
    if(is_number(a[i]) && is_number(b[i]) ? differs(a[i], b[i]) : a[i] != b[i]) {
      print "line " FNR ": " line " | " other
      ++failures
      break
    }
}
END {
  if((getline other < second) > 0) { print "the first output ends before the second"; ++failures }
  printf "%d lines, %d of them paths (%d along another way of the same length, %d with another number of points), " \
    "%d failures\n",
    lines, paths, other_paths, repeated, failures
  exit failures > 0 || lines == 0
}
END

failed=0
for name in "${examples[@]}"; do
  for version in before after; do
    mkdir -p "run/$version/$name"
    (cd "run/$version/$name" && "$work/build/${version}_$name" "$mesh" > stdout.txt) \
      || { echo "FAILED: $version/$name ends with an error"; exit 1; }
  done
  for file in run/before/"$name"/*; do
    [ -s "$file" ] || continue
    echo -n "$name, $(basename "$file"): "
    awk -v second="run/after/$name/$(basename "$file")" -v tolerance=1e-6 -v size=0.1 -f compare.awk "$file" || failed=1
  done
done
exit $failed
