#!/usr/bin/env bash
# Measures what users wait for when they compile: the example of paths, the same program with CGAL's
# Surface_mesh_shortest_path, and two other examples, in turn. Prints comma separated values. See readme.txt.
set -euo pipefail

usage()
{
  cat <<'END'
usage: measure_compile_times.sh [options]
  --repetitions N  compilations of each program, in turn (3)
  --headers FOLDER the folder include/ to compile with (that of this repository)
The variable CXX names the compiler (g++); CGAL and GNU time (Debian: package time) must be installed.
END
}

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$here/../.." && pwd)"
examples="$root/examples/Surface_mesh_geodesics"
headers="$root/include"
repetitions=3
while [ $# -gt 0 ]; do
  case "$1" in
    --repetitions) repetitions="$2"; shift ;;
    --headers) headers="$2"; shift ;;
    -h | --help) usage; exit 0 ;;
    *) usage >&2; exit 1 ;;
  esac
  shift
done

compiler="${CXX:-g++}"
flags="-std=c++17 -O3 -DNDEBUG -frounding-math -ffp-contract=off"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

# The example of paths says which lines it has changed; this takes the changes back.
sed -e 's#CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths\.h#CGAL/Surface_mesh_shortest_path.h#' \
  -e 's#CGAL::Surface_mesh_geodesic_paths<#CGAL::Surface_mesh_shortest_path<#' \
  "$examples/drop_in_shortest_paths.cpp" > "$folder/original_shortest_paths.cpp"
programs="original_shortest_paths drop_in_shortest_paths distances_to_all_vertices Voronoi_diagram_of_scan"
for program in $programs; do
  [ -f "$folder/$program.cpp" ] || cp "$examples/$program.cpp" "$folder"
done

for((i = 0; i < repetitions; ++i)); do
  for program in $programs; do
    # shellcheck disable=SC2086
    /usr/bin/time -f "$program %U %M" -a -o "$folder/times" \
      "$compiler" $flags -I"$headers" -c "$folder/$program.cpp" -o "$folder/$program.o"
  done
done

echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) hardware threads"
echo "# compiler: $("$compiler" --version | head -n 1), flags: $flags"
echo "# processor times of the compiler in seconds, in turn: median, least and greatest of $repetitions runs"
echo "# memory: peak of the compiler; ratio: of the medians, this program / original_shortest_paths"
sort -k1,1 -k2,2n "$folder/times" | awk -v programs="$programs" '
  { n[$1]++; second[$1, n[$1]] = $2; if($3 > memory[$1]) memory[$1] = $3 }
  function median(p) { return (second[p, int((n[p] + 1) / 2)] + second[p, int(n[p] / 2) + 1]) / 2 }
  END {
    print "program,seconds,seconds_min,seconds_max,memory_mb,ratio"
    count = split(programs, name, " ")
    for(i = 1; i <= count; ++i) {
      p = name[i]
      printf "%s,%.2f,%.2f,%.2f,%.0f,%.2f\n", p, median(p), second[p, 1], second[p, n[p]], memory[p] / 1024, \
             median(p) / median(name[1])
    }
  }'
