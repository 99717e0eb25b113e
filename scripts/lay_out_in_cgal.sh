#!/usr/bin/env bash
# Lays the package out in a source tree of CGAL, in the way CGAL keeps its packages: include/CGAL/..., test, examples,
# demo, benchmark, doc and package_info in TREE/Surface_mesh_geodesics. The script makes all necessary changes, so that
# nobody renames or edits files by hand, and leaves out what CGAL has no place for. The tree may be a clone of CGAL or
# an empty folder; a second call replaces what the first one has laid out.
# usage: lay_out_in_cgal.sh [--owner "NAME (COUNTRY)"] [--maintainer "NAME <ADDRESS>"] [--since VERSION] TREE
#        lay_out_in_cgal.sh --list    prints the files of the package, relative to the tree
#   --owner    the owner of the copyright, in the form of CGAL's headers; goes into them and into package_info/
#   --maintainer    goes into package_info/
#   --since    the first version of CGAL with the package; goes into the package description
# Without an option, its value in doc/submission/placeholders.txt is used.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
package=Surface_mesh_geodesics
title="Exact Geodesics on Triangulated Surface Meshes"

usage()
{
  sed -n '/^# usage/,/^[^#]/s/^# \?//p' "${BASH_SOURCE[0]}"
}

# placeholder NAME: its value in the list of placeholders, which may be empty
placeholder()
{
  sed -nE "s/^$1: *(.*[^ ]) *\$/\1/p" "$root/doc/submission/placeholders.txt"
}
owner=$(placeholder owner)
maintainer=$(placeholder maintainer)
since=$(placeholder since)
while [ $# -gt 1 ]; do
  case "$1" in
    --owner) owner=$2 ;;
    --maintainer) maintainer=$2 ;;
    --since) since=$2 ;;
    *) break ;;
  esac
  shift 2
done
if [ "$*" = --help ]; then
  usage
  exit
fi
# A name that begins with a dash is a mistake: an unknown option, or one without its value.
if [ $# -ne 1 ] || [ -z "$1" ] || [[ "$1" = -* && "$1" != --list ]]; then
  usage >&2
  exit 2
fi

# Lists what the script makes in an empty tree.
if [ "$1" = --list ]; then
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
  "${BASH_SOURCE[0]}" "$work" > /dev/null
  (cd "$work" && find . -type f -printf '%P\n' | LC_ALL=C sort)
  exit 0
fi

mkdir -p "$1"
tree=$(cd "$1" && pwd -P)
target=$tree/$package
if [ "$tree" = "$(cd "$root" && pwd -P)" ]; then
  echo "The tree must not be the folder of the package itself." >&2
  exit 2
fi
# The script replaces only what it has laid out itself: never a clone of this repository that has the name of the
# package, or anything else under this name.
if [ -e "$target" ] && [ -n "$(ls -A "$target")" ] \
  && { [ -e "$target/.git" ] || [ -e "$target/README.md" ] || [ ! -d "$target/package_info/$package" ]; }; then
  echo "$target exists, but this script has not laid it out: nothing is changed." >&2
  exit 2
fi
rm -rf "$target"
mkdir -p "$target"

# --- copies ----------------------------------------------------------------------------------------------------------

cd "$root"
# copy FOLDER: copies the folder with everything in it
copy()
{
  mkdir -p "$target/$(dirname "$1")"
  cp -R "$1" "$target/$(dirname "$1")/"
}
copy include/CGAL
for part in test examples demo benchmark doc package_info; do
  copy "$part/$package"
done
find "$target" -name __pycache__ -type d -prune -exec rm -r {} +

# CGAL keeps the headers that ask for licenses together, and generates them from a list.
installation=$tree/Installation/include/CGAL/license
mkdir -p "$installation"
mv "$target/include/CGAL/license/$package.h" "$installation/"
rmdir "$target/include/CGAL/license"
list=$installation/gpl_package_list.txt
if ! grep -qs "^$package " "$list"; then
  echo "$package $title" >> "$list"
fi

# The named parameters become lines of CGAL's list, each once; some versions of CGAL have one of them. The files that
# stand in for that list are left out, with the lines that include them.
parameters=$target/include/CGAL/$package/internal/interface/parameters
cgal_list=$tree/STL_Extension/include/CGAL/STL_Extension/internal/parameters_interface.h
mkdir -p "$(dirname "$cgal_list")"
[ -e "$cgal_list" ] || touch "$cgal_list"
mark="// List of named parameters used in the package '$package'"
sed -nE 's/^CGAL_add_named_parameter(_of_newer_CGAL)?(\(.*\))$/CGAL_add_named_parameter\2/p' \
  "$parameters/geodesic_parameters_interface.h" | while read -r line; do
  # the name of the function, which is the last word
  name=$(sed -E 's/.*, *(\w+)\)$/\1/' <<< "$line")
  grep -qE "^ *CGAL_add_\w*\(.*, *$name *\)" "$cgal_list" && continue
  grep -qxF "$mark" "$cgal_list" || printf '\n%s\n' "$mark" >> "$cgal_list"
  echo "$line" >> "$cgal_list"
done
rm "$parameters/geodesic_parameters_interface.h" "$parameters/Parameter_sequence.h" \
  "$target/include/CGAL/$package/geodesic_parameters.h"
gone='(Parameter_sequence|geodesic_parameters(_interface)?)\.h'
find "$target" -type f \( -name '*.h' -o -name '*.cpp' \) -exec sed -Ei "/^#include <CGAL\/$package\/.*$gone>\$/d" {} +
sed -Ei "/^\| .$gone. \|/d; /^In CGAL's tree/,/^\$/d" "$parameters/README.md"
sed -i 's/Sequence_end_tag, //' "$parameters/parameter_checks.h"

# These tests concern only this repository: the installed package, the program for the command line, the same bits
# from several compilers, several processes with MPI, CGAL's own examples, runs of minutes, programs that must not
# compile.
for part in consumer program determinism mixed_flags mpi rejected run_cgal_examples.sh; do
  rm -r "$target/test/${package:?}/$part"
done
rm "$target/test/$package"/fuzz_*.cpp

# --- headers and manual ----------------------------------------------------------------------------------------------

# CGAL's headers say that they are part of it.
find "$target/include" "$installation/$package.h" -name '*.h' -exec \
  sed -i '0,/^\/\/ All rights reserved\.$/s//&\n\/\/\n\/\/ This file is part of CGAL (www.cgal.org)./' {} +

if [ -n "$owner" ]; then
  find "$target/include" "$installation/$package.h" -name '*.h' -exec \
    sed -i "s|^\(// Copyright (c) [0-9-]*\)  .*|\1  $(sed 's/[&|\\]/\\&/g' <<< "$owner").|" {} +
  echo "$owner" > "$target/package_info/$package/copyright"
fi
[ -z "$maintainer" ] || echo "$maintainer" > "$target/package_info/$package/maintainer"

# Text about things that only this repository has is between marks, within a line or around lines. The pages about the
# program for the command line and about Python are left out. CGAL has its meshes in a folder of its own.
manual=$target/doc/$package
begin='<!-- not in CGAL: begin -->'
end='<!-- not in CGAL: end -->'
rm "$manual/Program.txt" "$manual/Python.txt" "$manual/Platforms.txt"
perl -0pi -e "s/$begin(\n.*?$end\n|.*?$end)//gs" "$manual"/*.txt
sed -i 's|"build/cgal_data/data/\(meshes/[^"]*\)"|CGAL::data_file_path("\1")|' "$manual"/*.txt
for figure in "$target/doc/$package/fig"/*; do
  grep -qF "$(basename "$figure")" "$target/doc/$package"/*.txt || rm "$figure"
done

# CGAL prints the literature from its own file: see doc/submission/references.bib.
sed -i "/^\\\\section ${package}_literature /,/^\*\/\$/{/^\*\/\$/!d}" "$manual/Literature.txt"
mkdir -p "$tree/Documentation/doc/biblio"
cp "doc/submission/references.bib" "$tree/Documentation/doc/biblio/$package.bib"
if [ -n "$since" ]; then
  sed -i "s|^\\\\cgalPkgSince{.*}$|\\\\cgalPkgSince{$since}|" "$target/doc/$package/PackageDescription.txt"
fi

# --- building in CGAL's way ------------------------------------------------------------------------------------------

# cmake_lists NAME FOLDER: one program for each source file, linked with TBB or Eigen where it uses them
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
cmake_lists Benchmark "$target/benchmark/$package"

# The program for the command line keeps its own lines, which expect the targets of this repository.
version=$(sed -nE 's/^ *VERSION ([0-9.]+)$/\1/p' "$root/CMakeLists.txt" | head -n 1)
{
  cat << END
cmake_minimum_required(VERSION 3.19...3.31)
project(${package}_Demo VERSION $version)

find_package(CGAL REQUIRED)
add_library(CGAL::$package INTERFACE IMPORTED)
target_link_libraries(CGAL::$package INTERFACE CGAL::CGAL)
target_compile_features(CGAL::$package INTERFACE cxx_std_17)

find_package(TBB QUIET)
include(CGAL_TBB_support)
find_package(Eigen3 3.1.0 QUIET)

END
  cat "$root/demo/$package/CMakeLists.txt"
} > "$target/demo/$package/CMakeLists.txt"

# --- what is left ----------------------------------------------------------------------------------------------------

echo "The package is in $target"
[ -n "$owner" ] || echo "Missing: the owner of the copyright with a country (--owner)"
[ -n "$maintainer" ] || echo "Missing: the maintainer with an address (--maintainer)"
[ -n "$since" ] || echo "Missing: the version of CGAL in \\cgalPkgSince (--since)"
echo "The named parameters are in $cgal_list"
echo "Left to do in CGAL's own files, as doc/submission/specification.md says:"
echo "  Documentation/doc/Documentation/packages.txt: \\package_listing{$package}"
echo "  Documentation/doc/biblio/cgal_manual.bib: the entries of Documentation/doc/biblio/$package.bib"
echo "  Installation/CHANGES.md: the entry of the package"

# No two files of CGAL may have the same name, regardless of case. (The license headers are generated, and kept apart.)
names_below()
{
  find "$1" -path '*/.git' -prune -o -name '*.h' ! -path '*/license/*' -printf '%f\n' | tr '[:upper:]' '[:lower:]' \
    | LC_ALL=C sort
}
twice=$(LC_ALL=C comm -12 <(names_below "$tree" | uniq -d) <(names_below "$target" | uniq))
[ -z "$twice" ] || printf 'Names of headers that exist more than once:\n%s\n' "$twice"
