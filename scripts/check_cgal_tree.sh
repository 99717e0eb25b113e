#!/usr/bin/env bash
# Lays the package out in an empty tree of CGAL and checks the result: it holds every header, an example compiles with
# nothing but folders of the tree and the CGAL that is installed, CMake finds a program for each example and test, and
# the literature has an entry for each citation.
# usage: check_cgal_tree.sh WORK_FOLDER [options of cmake]     The variable CXX is the compiler.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$1
shift
package=Surface_mesh_geodesics
rm -rf "$work"
mkdir -p "$work"
work=$(cd "$work" && pwd)
tree=$work/tree

fail()
{
  echo "$*" >&2
  exit 1
}

# Twice, as somebody does who has a newer version.
bash "$root/scripts/lay_out_in_cgal.sh" "$tree" > "$work/first.txt"
bash "$root/scripts/lay_out_in_cgal.sh" "$tree" > "$work/second.txt"
diff "$work/first.txt" "$work/second.txt"
[ "$(grep -c "^$package " "$tree/Installation/include/CGAL/license/gpl_package_list.txt")" = 1 ] \
  || fail "the list of licences has not one line for the package"

# All headers are there, and say whose they are.
headers_below() { (cd "$1" && find . -name '*.h' | LC_ALL=C sort); }
diff <(headers_below "$root/include") \
  <(cat <(headers_below "$tree/$package/include") <(headers_below "$tree/Installation/include") | LC_ALL=C sort)
mark='This file is part of CGAL (www.cgal.org).'
grep -rL --include='*.h' "$mark" "$tree/$package/include" "$tree/Installation" > "$work/unmarked.txt" || true
[ ! -s "$work/unmarked.txt" ] || fail "not marked as a part of CGAL: $(cat "$work/unmarked.txt")"

# The specification names every public header.
for header in "$tree/$package/include/CGAL/$package"/*.h; do
  grep -qF "$(basename "$header")" "$root/doc/submission/specification.md" \
    || fail "doc/submission/specification.md does not name $(basename "$header")"
done

# An example, as a user of that CGAL has it.
example=$tree/$package/examples/$package
"${CXX:-g++}" -std=c++17 -O0 -frounding-math -I"$tree/$package/include" -I"$tree/Installation/include" \
  "$example/several_sources.cpp" -o "$work/several_sources" -lgmp -lmpfr -pthread
(cd "$example" && "$work/several_sources") > "$work/several_sources.txt"
grep -q '^source 0 is the nearest one of [1-9]' "$work/several_sources.txt" || fail "the example prints something else"

# A program for each source file.
for part in examples test; do
  folder=$tree/$package/$part/$package
  cmake -S "$folder" -B "$work/$part" -DCMAKE_BUILD_TYPE=Release "$@" > "$work/$part.log" 2>&1 \
    || fail "$(cat "$work/$part.log")"
  cmake --build "$work/$part" --target help > "$work/$part.targets"
  for source in "$folder"/*.cpp; do
    name=$(basename "$source" .cpp)
    grep -qw "$name" "$work/$part.targets" || grep -q "NOTICE: $name.cpp needs" "$work/$part.log" \
      || fail "$part: no program of $name.cpp"
  done
done

# Citations and literature.
diff \
  <(grep -rhoE '\\cgalCite\{[^}]+' "$tree/$package/doc" "$tree/$package/include" | sed 's/.*{//' | LC_ALL=C sort -u) \
  <(sed -nE 's/^@[a-z]+\{(.*),$/\1/p' "$tree/Documentation/doc/biblio/$package.bib" | LC_ALL=C sort -u)
! grep -q "${package}_literature" "$tree/$package/doc/$package/$package.txt" \
  || fail "the manual still has its own literature"
echo "The tree is complete, and its example runs."
