#!/usr/bin/env bash
# The paths that pages compute between two clicks are those of the program.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
page=$here/../../../demo/Surface_mesh_geodesics/page
if ! command -v node > /dev/null; then
  echo "SKIPPED: there is no Node.js"
  exit 77
fi

# compare <mesh> <number of pairs> <tolerance>: random points of faces, on edges and at vertices. Paths avoid the faces
# in avoid.txt, in which no location is given, and the walls in walls.txt.
: > avoid.txt
: > walls.txt
compare() {
  local faces
  faces=$(grep -v -e '^#' -e '^$' "$1" | sed -n 2p | awk '{ print $2 }')
  awk -v n="$2" -v faces="$faces" '{ avoided[$1] } END {
    srand(7)
    for(i = 0; i < n; ++i) {
      line = ""
      for(k = 0; k < 2; ++k) {
        a = int(64 * rand()) / 64
        b = int(64 * (1 - a) * rand()) / 64
        kind = (i + k) % 4
        if(kind == 1) b = 0
        if(kind == 2) { a = 0; b = 1 }
        do f = int(faces * rand()); while(f in avoided)
        line = line (k ? " " : "") f " " a " " b " " (1 - a - b)
      }
      print line
    }
  }' avoid.txt > pairs.txt
  node "$here/page_paths.js" "$page" "$1" pairs.txt avoid.txt walls.txt > page.txt
  : > program.txt
  while read -r f a b c g d e h; do
    echo "$f $a $b $c" > s.txt
    echo "$g $d $e $h" > t.txt
    "$program" path "$1" --source-file s.txt --target-file t.txt --avoid avoid.txt --walls walls.txt --quiet \
      2> /dev/null | tail -n 1 | cut -d, -f3 >> program.txt || echo inf >> program.txt
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

# Around faces, beside single edges, in corners and in rooms without a door. Some of the points are on walls.
for mesh in "$data/grid4.off" "$data/grid9.off" "$examples/bumpy_sphere.off"; do
  for step in 6 11; do
    grep -v -e '^#' -e '^$' "$mesh" | awk -v step=$step 'NR == 2 { n = $1; m = $2 }
      NR > n + 2 && NR <= n + m + 2 { f = NR - n - 3; if(f % step == 1) print $2, $3 > "walls.txt"
        if(f % step == 0) print $3, $4 > "walls.txt"; if(f % (4 * step) == 2) print f > "avoid.txt" }'
    [ -s walls.txt ] && [ -s avoid.txt ]
    compare "$mesh" 20 1e-9
    grep --quiet -v inf page.txt
  done
done
: > avoid.txt
: > walls.txt

# Needles and caps: the page computes with fewer precautions than the program, and shows five digits.
for mesh in "$data"/*.off; do
  if "$program" info "$mesh" > info.csv 2> /dev/null && [ "$(column info.csv value | line /dev/stdin 3)" -lt 3000 ] \
    && ! grep -q '^4 ' "$mesh"; then
    compare "$mesh" 8 1e-6
  fi
done
