#!/usr/bin/env bash
# Lays the package out in a source tree of CGAL, as that keeps its packages: include/CGAL/..., test, examples,
# benchmark, doc and package_info in TREE/Surface_mesh_geodesics. What has to change on the way is changed here, so that
# nothing is renamed or edited by hand. The tree may be a clone of CGAL or an empty folder; what an earlier call has laid out is
# replaced.
# usage: lay_out_in_cgal.sh TREE
#        lay_out_in_cgal.sh --list    prints the files of the package, relative to the tree
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
package=Surface_mesh_geodesics
title="Exact Geodesics on Triangulated Surface Meshes"

if [ $# -ne 1 ] || [ -z "$1" ]; then
  sed -n '/^# usage/,/^[^#]/s/^# \?//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi

# The list is that of an empty tree.
if [ "$1" = --list ]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  "${BASH_SOURCE[0]}" "$work" > /dev/null
  (cd "$work" && find . -type f -printf '%P\n' | LC_ALL=C sort)
  exit 0
fi

mkdir -p "$1"
tree=$(cd "$1" && pwd)
if [ "$tree" = "$root" ]; then
  echo "The tree must not be the folder of the package itself." >&2
  exit 2
fi
target=$tree/$package
rm -rf "$target"
mkdir -p "$target"

# --- copies ----------------------------------------------------------------------------------------------------------

cd "$root"
# copy FOLDER: with all that is below it, less what Python leaves behind
copy()
{
  mkdir -p "$target/$(dirname "$1")"
  cp -R "$1" "$target/$(dirname "$1")/"
}
copy include/CGAL
for part in test examples benchmark doc package_info; do
  copy "$part/$package"
done
find "$target" -name __pycache__ -type d -prune -exec rm -r {} +

# CGAL keeps the headers that ask for licences together, and makes them itself of a list.
installation=$tree/Installation/include/CGAL/license
mkdir -p "$installation"
mv "$target/include/CGAL/license/$package.h" "$installation/"
rmdir "$target/include/CGAL/license"
list=$installation/gpl_package_list.txt
if ! grep -qs "^$package " "$list"; then
  echo "$package $title" >> "$list"
fi

# What tests and examples of this repository only: the installed package, CGAL's own examples, runs of minutes.
rm -rf "$target/test/$package/consumer" "$target/test/$package/run_cgal_examples.sh"
rm -f "$target/test/$package"/fuzz_*.cpp
rm -f "$target/benchmark/$package/CMakeLists.txt"

# --- headers and manual ----------------------------------------------------------------------------------------------

# CGAL's headers say that they are part of it.
find "$target/include" "$installation/$package.h" -name '*.h' -exec \
  sed -i '0,/^\/\/ All rights reserved\.$/s//&\n\/\/\n\/\/ This file is part of CGAL (www.cgal.org)./' {} +

# CGAL prints the literature by itself, of its own file: see doc/submission/references.bib.
manual=$target/doc/$package/$package.txt
sed -i "/^\\\\section ${package}_literature /,/^\*\/\$/{/^\*\/\$/!d}" "$manual"
mkdir -p "$tree/Documentation/doc/biblio"
cp "doc/submission/references.bib" "$tree/Documentation/doc/biblio/$package.bib"

# --- building in CGAL's way ------------------------------------------------------------------------------------------

# cmake_lists NAME FOLDER: one program for each source file; those that want TBB or Eigen get it
cmake_lists()
{
  local name=$1 folder=$2 source
  {
    echo "cmake_minimum_required(VERSION 3.12...3.31)"
    echo "project(${package}_$name)"
    echo
    echo "find_package(CGAL REQUIRED)"
    [ ! -d "$folder/include" ] || echo "include_directories(BEFORE include)"
    echo
    echo "find_package(TBB QUIET)"
    echo "include(CGAL_TBB_support)"
    echo "find_package(Eigen3 3.1.0 QUIET)"
    echo "include(CGAL_Eigen3_support)"
    echo
    for source in "$folder"/*.cpp; do
      source=$(basename "$source")
      if grep -qE '^#include <(Eigen|CGAL/Heat_method_3)/' "$folder/$source"; then
        echo "if(TARGET CGAL::Eigen3_support)"
        echo "  create_single_source_cgal_program(\"$source\")"
        echo "  target_link_libraries(${source%.cpp} PRIVATE CGAL::Eigen3_support)"
        echo "else()"
        echo "  message(STATUS \"NOTICE: $source needs Eigen and will not be compiled.\")"
        echo "endif()"
        continue
      fi
      echo "create_single_source_cgal_program(\"$source\")"
      if grep -qE 'CGAL_LINKED_WITH_TBB|Parallel_(if_available_)?tag' "$folder/$source"; then
        echo "if(TARGET CGAL::TBB_support)"
        echo "  target_link_libraries(${source%.cpp} PRIVATE CGAL::TBB_support)"
        echo "endif()"
      fi
    done
  } > "$folder/CMakeLists.txt"
}
cmake_lists Examples "$target/examples/$package"
cmake_lists Tests "$target/test/$package"

# --- what is left ----------------------------------------------------------------------------------------------------

echo "The package is in $target"
echo "Left to do in CGAL's own files, as doc/submission/specification.md says:"
echo "  Documentation/doc/Documentation/packages.txt: \\package_listing{$package}"
echo "  Documentation/doc/biblio/cgal_manual.bib: the entries of Documentation/doc/biblio/$package.bib"
echo "  Installation/CHANGES.md: the entry of the package"

# No two files of CGAL may have the same name, in whatever case. (The files of licences are made, and apart.)
names_below()
{
  find "$1" -path '*/.git' -prune -o -name '*.h' ! -path '*/license/*' -printf '%f\n' | tr '[:upper:]' '[:lower:]' \
    | LC_ALL=C sort
}
twice=$(LC_ALL=C comm -12 <(names_below "$tree" | uniq -d) <(names_below "$target" | uniq))
[ -z "$twice" ] || printf 'Names of headers that exist more than once:\n%s\n' "$twice"
