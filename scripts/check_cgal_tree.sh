#!/usr/bin/env bash
# Lays the package out in an empty tree of CGAL and checks the result: it holds every header; an example compiles with
# only folders of the tree and the installed CGAL; CMake finds a program for each example, test and benchmark,
# and the program for the command line; no file mentions what CGAL does not have; each citation has an entry.
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

# A tree of CGAL has a list of named parameters: that of the installed CGAL.
parameters=STL_Extension/include/CGAL/STL_Extension/internal/parameters_interface.h
installed=$(echo '#include <CGAL/Named_function_parameters.h>' | "${CXX:-g++}" -std=c++17 -M -x c++ - \
  | tr ' ' '\n' | grep 'STL_Extension/internal/parameters_interface\.h$' | head -n 1)
[ -f "$installed" ] || fail "the compiler does not find the list of named parameters of CGAL"
mkdir -p "$tree/$(dirname "$parameters")"
cp "$installed" "$tree/$parameters"

# Lays it out twice, because a second call must replace the first one.
options=(--owner "A & B | C (Utopia)" --maintainer "M & N <m@example.org>" --since 9.9)
bash "$root/scripts/lay_out_in_cgal.sh" "$tree" > "$work/first.txt"
bash "$root/scripts/lay_out_in_cgal.sh" "${options[@]}" "$tree" > "$work/second.txt"
diff <(grep -v '^Missing: ' "$work/first.txt") "$work/second.txt"
empty=$(grep -cE '^[a-z]+: *$' "$root/doc/submission/placeholders.txt" || true)
[ "$(grep -c '^Missing: ' "$work/first.txt")" = "$empty" ] || fail "the script does not name the missing options"
[ "$(grep -c "^$package " "$tree/Installation/include/CGAL/license/gpl_package_list.txt")" = 1 ] \
  || fail "the list of licenses does not have exactly one line for the package"

# Each named parameter is in the list once, behind the lines that were there. An empty tree gets the lines as well.
list=$root/include/CGAL/$package/internal/interface/parameters/geodesic_parameters_interface.h
names_of() { sed -nE 's/^CGAL_add_\w+\(.*, *(\w+) *\)$/\1/p' "$1"; }
bash "$root/scripts/lay_out_in_cgal.sh" "$work/empty" > /dev/null
diff <(names_of "$list") <(names_of "$work/empty/$parameters")
for name in $(names_of "$list"); do
  [ "$(names_of "$tree/$parameters" | grep -cx "$name")" = 1 ] || fail "$parameters does not have $name exactly once"
done
diff "$installed" <(head -n "$(wc -l < "$installed")" "$tree/$parameters")

# A clone of this repository is not replaced, although it has the name of the package.
clone=$work/above/$package
mkdir -p "$clone/.git" "$clone/package_info/$package"
status=0
bash "$root/scripts/lay_out_in_cgal.sh" "$work/above" > /dev/null 2> "$work/rejected.txt" || status=$?
[ "$status" = 2 ] && [ -d "$clone/.git" ] || fail "a clone of the repository has been replaced"

# All headers are there, and are marked as a part of CGAL.
headers_below() { (cd "$1" && find . -name '*.h' | LC_ALL=C sort); }
stand_ins='/(Parameter_sequence|geodesic_parameters(_interface)?)\.h$'
diff <(headers_below "$root/include" | grep -vE "$stand_ins") \
  <(cat <(headers_below "$tree/$package/include") <(headers_below "$tree/Installation/include") | LC_ALL=C sort)
mark='This file is part of CGAL (www.cgal.org).'
grep -rL --include='*.h' "$mark" "$tree/$package/include" "$tree/Installation" > "$work/unmarked.txt" || true
[ ! -s "$work/unmarked.txt" ] || fail "not marked as a part of CGAL: $(cat "$work/unmarked.txt")"

# They name the given owner, and no other one.
owner='^// Copyright (c) [0-9-]*  A & B | C (Utopia)\.$'
grep -rL --include='*.h' "$owner" "$tree/$package/include" "$tree/Installation" > "$work/others.txt" || true
[ ! -s "$work/others.txt" ] || fail "another owner: $(cat "$work/others.txt")"
grep -qxF 'A & B | C (Utopia)' "$tree/$package/package_info/$package/copyright" || fail "package_info: another owner"
grep -qxF 'M & N <m@example.org>' "$tree/$package/package_info/$package/maintainer" \
  || fail "package_info: another maintainer"
grep -qxF '\cgalPkgSince{9.9}' "$tree/$package/doc/$package/PackageDescription.txt" || fail "another first version"

# No file mentions what only this repository has: its scripts, its build folder, its folder of the program.
ours='(^|[^[:alnum:]_/])scripts/|run_(tests|main_job)|build_doc|check_determinism|demo/|not in CGAL'
ours+='|Surface_mesh_geodesics_(TESTS|EXAMPLES|program)'
grep -rnE "$ours" "$tree/$package" --include='*.txt' --include='*.h' --include='*.cpp' > "$work/ours.txt" || true
[ ! -s "$work/ours.txt" ] || fail "mentions of what CGAL does not have: $(cat "$work/ours.txt")"
unexpected=$(cd "$tree/$package/test/$package" && find . -mindepth 1 -maxdepth 1 -type d ! -name data ! -name include)
[ -z "$unexpected" ] || fail "folders of tests that CGAL does not build: $unexpected"

# The manual refers to its own sections, and to pictures that are there; no picture is left over.
manual=$tree/$package/doc/$package
grep -ohE '\\ref Surface_mesh_geodesics_\w+' -r "$manual" "$tree/$package/include" | sed 's/.* //' | LC_ALL=C sort -u \
  > "$work/references.txt"
sed -nE 's/^\\((sub)*section|page) (\w+) .*/\3/p' "$manual"/*.txt | LC_ALL=C sort -u > "$work/sections.txt"
missing=$(LC_ALL=C comm -23 "$work/references.txt" "$work/sections.txt")
[ -z "$missing" ] || fail "references to sections that are not there: $missing"
diff <(grep -ohE '[A-Za-z0-9_]+\.(png|svg)' "$manual"/*.txt | LC_ALL=C sort -u) \
  <(find "$manual/fig" -type f -printf '%f\n' | LC_ALL=C sort)

# The specification names every public header.
for header in "$tree/$package/include/CGAL/$package"/*.h; do
  grep -qF "$(basename "$header")" "$root/doc/submission/specification.md" \
    || fail "doc/submission/specification.md does not name $(basename "$header")"
done

# No file mentions what stands in for CGAL's list.
! grep -rnE 'Parameter_sequence|Sequence_end|geodesic_parameters' "$tree/$package" > "$work/stand_ins.txt" \
  || fail "mentions of stand-ins: $(cat "$work/stand_ins.txt")"

# An example, as a user of that CGAL has it, and the test of named parameters.
example=$tree/$package/examples/$package
includes=(-I"$tree/$package/include" -I"$tree/Installation/include" -I"$tree/STL_Extension/include")
"${CXX:-g++}" -std=c++17 -O0 -frounding-math "${includes[@]}" \
  "$example/several_sources.cpp" -o "$work/several_sources" -lgmp -lmpfr -pthread
(cd "$example" && "$work/several_sources") > "$work/several_sources.txt"
grep -q '^source 0 is the nearest one of [1-9]' "$work/several_sources.txt" || fail "the example prints something else"

# CMake finds a program for each source file, and the program for the command line.
for part in examples test benchmark; do
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

folder=$tree/$package/demo/$package
cmake -S "$folder" -B "$work/demo" -DCMAKE_BUILD_TYPE=Release "$@" > "$work/demo.log" 2>&1 \
  || fail "$(cat "$work/demo.log")"
cmake --build "$work/demo" --target help > "$work/demo.targets"
grep -qw surface_mesh_geodesics_program "$work/demo.targets" || grep -q "NOTICE: Boost" "$work/demo.log" \
  || fail "demo: no program"

# Citations and literature. Doxygen would take a colon that follows the key of a citation for a part of it.
! grep -rnE '\\cgalCite\{[^}]+\}:' "$tree/$package/doc" "$tree/$package/include" > "$work/colons.txt" \
  || fail "a colon behind a citation: $(cat "$work/colons.txt")"
diff \
  <(grep -rhoE '\\cgalCite\{[^}]+' "$tree/$package/doc" "$tree/$package/include" | sed 's/.*{//' | LC_ALL=C sort -u) \
  <(sed -nE 's/^@[a-z]+\{(.*),$/\1/p' "$tree/Documentation/doc/biblio/$package.bib" | LC_ALL=C sort -u)
! grep -q "${package}_literature" -r "$tree/$package/doc/$package" \
  || fail "the manual still has its own literature"
echo "The tree is complete, and its example runs."
