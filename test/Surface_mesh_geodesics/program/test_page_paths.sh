#!/usr/bin/env bash
# The paths that pages compute between two clicks are those of the program.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
solver=$here/../../../demo/Surface_mesh_geodesics/page/exact_path.js
if ! command -v node > /dev/null; then
  echo "SKIPPED: there is no Node.js"
  exit 77
fi

# compare <mesh> <number of pairs> <tolerance>: random points of faces, on edges and at vertices
compare() {
  local faces
  faces=$(grep -v -e '^#' -e '^$' "$1" | sed -n 2p | awk '{ print $2 }')
  awk -v n="$2" -v faces="$faces" 'BEGIN {
    srand(7)
    for(i = 0; i < n; ++i) {
      line = ""
      for(k = 0; k < 2; ++k) {
        a = int(64 * rand()) / 64
        b = int(64 * (1 - a) * rand()) / 64
        kind = (i + k) % 4
        if(kind == 1) b = 0
        if(kind == 2) { a = 0; b = 1 }
        line = line (k ? " " : "") int(faces * rand()) " " a " " b " " (1 - a - b)
      }
      print line
    }
  }' > pairs.txt
  node "$here/page_paths.js" "$solver" "$1" pairs.txt > page.txt
  : > program.txt
  while read -r f a b c g d e h; do
    echo "$f $a $b $c" > s.txt
    echo "$g $d $e $h" > t.txt
    "$program" path "$1" --source-file s.txt --target-file t.txt --quiet 2> /dev/null | tail -n 1 | cut -d, -f3 \
      >> program.txt || echo inf >> program.txt
  done < pairs.txt
  paste -d ' ' page.txt program.txt pairs.txt | awk -v t="$3" '
    $1 == "inf" || $3 == "inf" { if($1 != $3) { print "wrong: " $0; exit 1 }; next }
    { size = $3 + 1e-9
      if(($1 - $3)^2 > (t * size)^2 || ($2 - $3)^2 > (t * size)^2) { print "wrong: " $0; exit 1 } }' \
    || fail "the page has another path on $1"
}

examples=$data/../../../examples/Surface_mesh_geodesics/data
compare "$data/grid4.off" 40 1e-9
compare "$data/L_shape.off" 40 1e-9
compare "$data/two_components.off" 20 1e-9
compare "$examples/bumpy_sphere.off" 40 1e-9
# Needles and caps: the page computes with fewer precautions than the program, and shows five digits.
for mesh in "$data"/*.off; do
  if "$program" info "$mesh" > info.csv 2> /dev/null && [ "$(column info.csv value | line /dev/stdin 3)" -lt 3000 ] \
    && ! grep -q '^4 ' "$mesh"; then
    compare "$mesh" 8 1e-6
  fi
done
