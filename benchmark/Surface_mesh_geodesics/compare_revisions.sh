#!/usr/bin/env bash
# Compares distances from one vertex, the ordinary case, between two revisions of the package: times, instructions and
# bits. Prints comma separated values. See readme.txt.
set -euo pipefail

usage()
{
  cat <<'END'
usage: compare_revisions.sh [options] REVISION MESH...
  REVISION         the older revision of this repository, as git names it; it is compared with the files that are here
  --repetitions N  pairs of runs of each mesh, in turn, with five calls each (7)
  --subdivide K    subdivide each mesh K times (0)
  --no-instructions  do not count instructions, which takes most of the time
  --no-header      print the rows only
The variable CXX names the compiler (g++). Needs git, CGAL and valgrind, which counts the instructions.
END
}

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
root="$(cd "$here/../.." && pwd)"
repetitions=7
subdivisions=0
counts_instructions=yes
has_header=yes
while [ $# -gt 0 ]; do
  case "$1" in
    --repetitions) repetitions="$2"; shift ;;
    --subdivide) subdivisions="$2"; shift ;;
    --no-instructions) counts_instructions=no ;;
    --no-header) has_header=no ;;
    -h | --help) usage; exit 0 ;;
    -*) usage >&2; exit 1 ;;
    *) break ;;
  esac
  shift
done
[ $# -ge 2 ] || { usage >&2; exit 1; }
revision="$1"
shift

compiler="${CXX:-g++}"
flags="-std=c++17 -O3 -DNDEBUG -frounding-math -ffp-contract=off"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/before"
git -C "$root" archive "$revision" include | tar -x -C "$folder/before"
ln -s "$root" "$folder/now"
for version in before now; do
  # shellcheck disable=SC2086
  "$compiler" $flags -I"$folder/$version/include" -I"$here/include" "$here/benchmark_distances_alone.cpp" \
    -o "$folder/distances_$version" -lgmp -lmpfr -lpthread
done

# instructions VERSION MESH: of one call. A run with two calls has that many more than a run with one.
instructions()
{
  [ "$counts_instructions" = yes ] || return 0
  local n count=()
  for n in 1 2; do
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$folder/distances_$1" --repetitions "$n" \
      --subdivide "$subdivisions" "$2" \
      > /dev/null 2> "$folder/valgrind.log"
    count+=("$(awk '/Collected/ { print $NF }' "$folder/valgrind.log")")
  done
  echo $((count[1] - count[0]))
}

if [ "$has_header" = yes ]; then
  echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) hardware threads"
  echo "# compiler: $("$compiler" --version | head -n 1), flags: $flags"
  echo "# before: revision $(git -C "$root" rev-parse --short "$revision")" \
    "of $(git -C "$root" log -1 --format=%as "$revision")"
  echo "# processor times of geodesic_distances() in ms, medians of $repetitions pairs of runs in turn;" \
    "instructions of one call"
  columns=mesh,subdivisions,faces,before_ms,now_ms,time_ratio
  echo "$columns,before_instructions,now_instructions,instructions_ratio,same_bits"
fi
for mesh in "$@"; do
  : > "$folder/runs"
  for((i = 0; i < repetitions; ++i)); do
    before="$("$folder/distances_before" --subdivide "$subdivisions" "$mesh")"
    now="$("$folder/distances_now" --subdivide "$subdivisions" "$mesh")"
    echo "$before $now" >> "$folder/runs"
  done
  awk -v mesh="$(basename "$mesh")" -v subdivisions="$subdivisions" \
    -v before="$(instructions before "$mesh")" -v now="$(instructions now "$mesh")" '
    function median(a, n,   i, j, t) {
      for(i = 2; i <= n; ++i)
        for(j = i; j > 1 && a[j - 1] > a[j]; --j) { t = a[j]; a[j] = a[j - 1]; a[j - 1] = t }
      return (a[int((n + 1) / 2)] + a[int(n / 2) + 1]) / 2
    }
    { faces = $1; old[NR] = $2 + 0; new[NR] = $5 + 0; ratio[NR] = $5 / $2; if($3 != $6) differs = 1 }
    END {
      counts = before == "" ? ",," : sprintf("%.0f,%.0f,%.4f", before, now, now / before)
      printf "%s,%d,%d,%.3f,%.3f,%.3f,%s,%s\n", mesh, subdivisions, faces, median(old, NR), median(new, NR),
             median(ratio, NR), counts, differs ? "no" : "yes"
    }' "$folder/runs"
done
