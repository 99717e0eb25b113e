#!/usr/bin/env bash
# surface_mesh_geodesics distances --source-border, --source-curve, --signed
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

# expect <table> <expression of awk in x and y>: the distance of each vertex
expect() {
  awk -F, "NR > 1 { x = int(\$1 / 4) / 3; y = \$1 % 4 / 3; d = \$2 - ($2); if(d > 1e-12 || d < -1e-12) exit 1; ++n }
    END { exit n != 16 }
    function min(a, b) { return a < b ? a : b }
    function max(a, b) { return a > b ? a : b }
    function norm(a, b) { return sqrt(a * a + b * b) }" "$1" || fail "$1 is not $2"
}

# The border, whole edges and not only vertices: vertices inside are a third from it.
is_silent distances "$grid" --source-border > border.csv
equals "$(line border.csv 1)" vertex,distance,source,source_vertex
expect border.csv "min(min(x, 1 - x), min(y, 1 - y))"
equals "$(column border.csv source | sort -u)" 0
is_silent distances "$data/two_components.off" --source-border > parts.csv
equals "$(column parts.csv source | sort -u | paste -sd,)" 0,1
rejects 2 "--source-border: the surface has no border" distances "$data/tetra.off" --source-border

# A segment across the faces, as CGAL's polylines and as OBJ, with faces, other statements and an index from the end.
printf '# a curve\n2 0.1 0.2 0 0.9 0.2 0\n' > segment.polylines.txt
printf 'o curve\nv 0.1 0.2 0\nv 0.9 0.2 0 # the end\nl 1/1 -1/2\ng\nf 1 2 2\n' > segment.obj
segment="norm(x - min(0.9, max(0.1, x)), y - 0.2)"
is_silent distances "$grid" --source-curve segment.polylines.txt > segment.csv
expect segment.csv "$segment"
is_silent distances "$grid" --source-curve segment.obj > again.csv
cmp segment.csv again.csv
equals "$(line segment.csv 1)" vertex,distance,source,source_vertex,source_face,source_b0,source_b1,source_b2
# The table has the nearest point of the curve for each vertex, and may be a file of locations: all are on the curve.
tail -n +2 segment.csv | cut -d, -f5- | tr , ' ' > feet.txt
is_silent distances "$grid" --source-file feet.txt > feet.csv
for v in $(seq 0 15); do
  is_near "$(column segment.csv distance | line /dev/stdin $((v + 1)))" \
    "$(column feet.csv distance | line /dev/stdin $((v + 1)))"
done

# Several curves in several files, with vertices, points and the border; the source tells which one.
printf '1 0.5 0.5 0\n2 0 0 0 0 1 0\n' > two.polylines.txt
is_silent distances "$grid" --source 15 --source-point 1,0,0 --source-curve two.polylines.txt \
  --source-curve segment.obj -o all.csv -o all.ply -o all.vtk
expect all.csv "min(min(min(norm(1 - x, 1 - y), norm(1 - x, y)), min(norm(x - 0.5, y - 0.5), x)), $segment)"
equals "$(column all.csv source | sort -u | paste -sd,)" 0,1,2,3,4
equals "$(column all.csv source | line /dev/stdin 16)" 0
equals "$(column all.csv source | line /dev/stdin 13)" 1
equals "$(column all.csv source | line /dev/stdin 1)" 3
equals "$(column all.csv source_vertex | line /dev/stdin 3)" 2
is_silent distances "$grid" --source-border --source 5 > mixed.csv
expect mixed.csv "min(norm(x - 1 / 3, y - 1 / 3), min(min(x, 1 - x), min(y, 1 - y)))"
equals "$(column mixed.csv source | line /dev/stdin 6)" 0
equals "$(column mixed.csv source | line /dev/stdin 1)" 1
contains all.vtk "SCALARS source int 1"

# A radius, and faces to avoid.
is_silent distances "$grid" --source-border --radius 0.1 > near.csv
equals "$(column near.csv distance | grep -c inf)" 4
equals "$(line near.csv 7)" 5,inf,-1,
seq 0 17 > faces.txt
rejects 3 "segment.obj, line 2: no face is left for the point, as all are to be avoided" \
  distances "$grid" --source-curve segment.obj --avoid faces.txt
printf '8\n9\n' > middle.txt
printf '2 0.1 0.4 0 0.9 0.4 0\n' > through.polylines.txt
is_silent distances "$grid" --source-curve through.polylines.txt > through.csv
expect through.csv "norm(x - min(0.9, max(0.1, x)), y - 0.4)"
is_silent distances "$grid" --source-curve through.polylines.txt --avoid middle.txt > around.csv
is_near "$(column around.csv distance | line /dev/stdin 6)" 0 # around two corners of the square in the middle
is_near "$(column around.csv distance | line /dev/stdin 10)" 0
# Points above the square in the middle do not move into it, but to its rim: the second one to the side y = 1/3.
printf '# a curve\n2 0.1 0.4 0 0.5 0.34 0\n' > into.polylines.txt
remarks "into.polylines.txt, line 2: the point was moved to the faces that are not avoided, by 0.471 % of the diagonal" \
  distances "$grid" --source-curve into.polylines.txt --avoid middle.txt
is_near "$(column remarks.out distance | line /dev/stdin 6)" 0 # the path leads along the rim
is_near "$(column remarks.out distance | line /dev/stdin 10)" "$(awk 'BEGIN { printf "%.17g", 2 / 3 - .5 }')"
printf 'v .1 .4 0\nv .5 .4 0\nv .1 .1 0\nl 3 1 2\n' > inside.obj
goal="the faces that are not avoided"
for call in "distances --source" "check --source" "voronoi --site" "sample --number 3 --first"; do
  # shellcheck disable=SC2086 # the options are words
  rejects 3 "inside.obj, line 2: the point is 0.0666667 from $goal, 4.71 % of the diagonal of the mesh; --snap moves it to \
$goal all the same" ${call%% *} "$grid" ${call#* }-curve inside.obj --avoid middle.txt
done
remarks "inside.obj, line 2: the point was moved to $goal, by 4.71 %" \
  distances "$grid" --source-curve inside.obj --avoid middle.txt --snap
# The border of what is left: the rim of the square in the middle is one more border; without the faces left of x = 1/3
# and those below y = 1/3, which touch the border, a square is left.
is_silent distances "$grid" --source-border --avoid middle.txt > rim.csv
expect rim.csv 0 # all vertices are on one of the two
equals "$(column rim.csv source | sort -u | paste -sd,)" 0,1
awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2 { x[NR - 3] = $1; y[NR - 3] = $2 }
  NR > n + 2 && NF >= 4 { if(x[$2] + x[$3] + x[$4] < 1 || y[$2] + y[$3] + y[$4] < 1) print NR - n - 3 }' "$grid" > L.txt
equals "$(wc -l < L.txt)" 10
is_silent distances "$grid" --source-border --avoid L.txt --quiet > rest.csv
awk -F, 'NR > 1 { x = int($1 / 4) / 3; y = $1 % 4 / 3; if(x == 0 || y == 0) { if($2 != "inf") exit 1; next }
    if($2 - (x == 2 / 3 && y == 2 / 3 ? 1 / 3 : 0) > 1e-12) exit 1; ++n } END { exit n != 9 }' rest.csv || fail "rest.csv"
equals "$(column rest.csv distance | line /dev/stdin 11 | cut -c1-8)" 0.333333
is_silent check "$grid" --source-border --avoid L.txt --distances rest.csv --quiet > certificate.csv
is_silent voronoi "$grid" --site-border --avoid L.txt --vertices --quiet > labels.csv
is_near "$(column labels.csv distance | line /dev/stdin 11)" "$(column rest.csv distance | line /dev/stdin 11)"
equals "$(column labels.csv distance | grep -c inf)" 7
is_silent sample "$grid" --number 1 --first-border --avoid L.txt --quiet > inside.csv
equals "$(column inside.csv vertex)" 10 # the only vertex that is not on the border
rejects 2 "--source-border: the surface has no border" distances "$grid" --source-border --avoid faces.txt

# The curves that the program writes: a shortest path of its own is as near to its ends as to all its points.
is_silent path "$grid" --source-point 0.05,0.1,0 --target-point 0.95,0.7,0 -o path.obj -o path.polylines.txt
is_silent distances "$grid" --source-curve path.obj > from_obj.csv
is_silent distances "$grid" --source-curve path.polylines.txt > from_polylines.csv
awk -F, 'NR > 1 { x = int($1 / 4) / 3; y = $1 % 4 / 3; t = ((x - 0.05) * 0.9 + (y - 0.1) * 0.6) / 1.17
    t = t < 0 ? 0 : t > 1 ? 1 : t; d = sqrt((x - 0.05 - t * 0.9)^2 + (y - 0.1 - t * 0.6)^2) - $2
    if(d * d > 1e-24) exit 1 }' from_obj.csv
cmp <(cut -d, -f1,2 from_obj.csv) <(cut -d, -f1,2 from_polylines.csv)

# Signed distances: the faces of the grid are clockwise as seen from above, so the outside is on the left of this curve.
# A curve is closed where it ends at its first point.
printf 'v .1 .1 0\nv .9 .1 0\nv .9 .9 0\nv .1 .9 0\nl 1 2 3 4 1\n' > loop.obj
is_silent distances "$grid" --source-curve loop.obj --signed -o signed.csv -o signed.ply -o signed.vtk
equals "$(line signed.csv 1)" vertex,distance
expect signed.csv "x * (1 - x) * y * (1 - y) > 0 ? 1 / 3 - 0.1 \
  : -norm(x - min(0.9, max(0.1, x)), y - min(0.9, max(0.1, y)))"
equals "$(grep --text -c "SCALARS source" signed.vtk || true)" 0
printf '5 .1 .1 0 .1 .9 0 .9 .9 0 .9 .1 0 .1 .1 0\n' > clockwise.polylines.txt
is_silent distances "$grid" --source-curve clockwise.polylines.txt --signed > clockwise.csv
awk -F, 'NR > 1 && FNR == NR { d[$1] = $2; next } FNR != NR { e = d[$1] + $2; if(e * e > 1e-24) exit 1; ++n }
  END { exit n != 16 }' signed.csv <(tail -n +2 clockwise.csv)
# Lines on both sides, from the most negative distance on; outside, the last one is in the four corners only. The table
# stays the same.
is_silent distances "$grid" --source-curve loop.obj --signed --spacing 0.06 -o again.csv --lines both.obj \
  --lines both.vtk --lines both.ply
cmp again.csv signed.csv
awk 'function norm(a, b) { return sqrt(a * a + b * b) }
  function outside(x) { return x < .1 ? .1 - x : x > .9 ? x - .9 : 0 }
  $1 == "v" { x = $2; y = $3; a = x < 1 - x ? x - .1 : .9 - x; b = y < 1 - y ? y - .1 : .9 - y
              d[++n] = outside(x) + outside(y) > 0 ? -norm(outside(x), outside(y)) : a < b ? a : b }
  $1 == "l" { level = sprintf("%.11f", d[$2]); print level
              for(i = 2; i <= NF; ++i) if(sprintf("%.11f", d[$i]) != level) exit 1 }' both.obj > levels.txt
equals "$(paste -sd ' ' levels.txt | sed 's/0*\( \|$\)/\1/g')" "-0.12 -0.12 -0.12 -0.12 -0.06 0.06 0.12 0.18"
LC_ALL=C sed '1,/^SCALARS distance/d' both.vtk | tail -n +2 | head -c 64 | od -An -v -t f8 -w8 --endian=big \
  | awk '{ printf "%.11f\n", $1 }' | cmp - levels.txt
is_silent distances "$grid" --source-curve clockwise.polylines.txt --signed --spacing 0.06 --lines other.vtk -o other.csv
LC_ALL=C sed '1,/^SCALARS distance/d' other.vtk | tail -n +2 | head -c 64 | od -An -v -t f8 -w8 --endian=big \
  | awk '{ printf "%.11f\n", -$1 }' | tac | sed 's/-0\.00000000000/0/' | cmp - levels.txt
printf 'v .1 .1 0\nv .9 .1 0\nv .9 .9 0\nv .1 .9 0\nl 1 2 3 4\n' > open.obj
rejects 3 "--signed: the curves do not separate the surface: their two sides are connected" \
  distances "$grid" --source-curve open.obj --signed --lines x.obj
rejects 3 "--signed: the curves do not separate the surface: their two sides are connected" \
  distances "$grid" --source-curve open.obj --signed
rejects 2 "--signed needs curves: --source-border or --source-curve" distances "$grid" --source 0 --signed

# Points away from the surface, as for other points.
printf '2 0.1 0.2 0.001 0.9 0.2 -0.005\n' > high.polylines.txt
remarks "high.polylines.txt, line 1: the point was moved to the surface, by 0.354 % of the diagonal of the mesh; \
the farthest of 2 points" distances "$grid" --source-curve high.polylines.txt
cmp remarks.out segment.csv
printf 'v 0.1 0.2 0\nv 0.9 0.2 1\nl 1 2\n' > far.obj
rejects 3 "far.obj, line 2: the point is 1 from the surface, 70.7 % of the diagonal of the mesh; --snap" \
  distances "$grid" --source-curve far.obj
remarks "far.obj, line 2: the point was moved to the surface, by 70.7 % of the diagonal of the mesh; the farthest of 2 points" \
  distances "$grid" --source-curve far.obj --snap
cmp remarks.out segment.csv

# What is no curve, and what curves do not have yet.
printf 'l 1/1 -1/2\nv 0.1 0.2 0\nv 0.9 0.2 0\n' > bad.obj
rejects 3 "bad.obj, line 1: '-1/2' is not an index of a vertex: there are 0 before this line" \
  distances "$grid" --source-curve bad.obj
printf 'v 0 0 0\nv 1 0 0\nl 1 3\n' > bad.obj
rejects 3 "bad.obj, line 3: there is no vertex 3; the file has 2" distances "$grid" --source-curve bad.obj
printf 'v 0 0 0\nl\n' > bad.obj
rejects 3 "bad.obj, line 2: '' is not a point of a line, such as 7 or 7/7" distances "$grid" --source-curve bad.obj
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n' > bad.obj
rejects 3 "bad.obj: the file contains no curve: it has no statement 'l'" distances "$grid" --source-curve bad.obj
printf '# nothing\n' > bad.polylines.txt
rejects 3 "bad.polylines.txt: the file contains no curve" distances "$grid" --source-curve bad.polylines.txt
printf '3 0 0 0 1 0 0\n' > bad.polylines.txt
rejects 3 "bad.polylines.txt, line 1: the line ends, but a coordinate is needed" \
  distances "$grid" --source-curve bad.polylines.txt
printf '2 0 0 0 1 0 0 1\n' > bad.polylines.txt
rejects 3 "bad.polylines.txt, line 1: '1' follows after the last point of the line" \
  distances "$grid" --source-curve bad.polylines.txt
printf '0\n' > bad.polylines.txt
rejects 3 "bad.polylines.txt, line 1: '0' is not a number of points" distances "$grid" --source-curve bad.polylines.txt
printf '2 0 0 0 nan 0 0\n' > bad.polylines.txt
rejects 3 "bad.polylines.txt, line 1: 'nan'" distances "$grid" --source-curve bad.polylines.txt
rejects 3 "curve.txt: the name of a file of curves must end with one of .obj, .polylines.txt" \
  distances "$grid" --source-curve curve.txt
rejects 3 "none.obj: the file does not exist" distances "$grid" --source-curve none.obj
awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2' "$data/two_components.off" | sed -n '1p;$p' \
  | awk 'NR == 1 { a = $0 } END { print 2, a, $0 }' > apart.polylines.txt
rejects 3 "apart.polylines.txt, line 1: no path leads from this point of a curve to the next one" \
  distances "$data/two_components.off" --source-curve apart.polylines.txt
if "$program" distances --help | grep --quiet -e --html; then
  rejects 2 "--signed cannot be combined with a page .html" distances "$grid" --source-border --signed -o page.html
  "$program" distances "$grid" --source-border -o page.html
  grep --quiet '"role":"curve","lengths":' page.html
fi
# The same table, whether lines are written or not; on surfaces with other coordinates than these, the nearest points
# agree up to rounding. Lines of points at 0.1, 0.2 and 0.3 from the border of the square.
"$program" distances "$grid" --source-border -o without.csv
"$program" distances "$grid" --source-border -o with.csv --lines parallels.obj --spacing 0.1
cmp without.csv with.csv
awk '$1 == "v" { x = $2 < 1 - $2 ? $2 : 1 - $2; y = $3 < 1 - $3 ? $3 : 1 - $3; d = 10 * (x < y ? x : y); n = int(d + .5)
                 if(d - n > 1e-9 || n - d > 1e-9 || n < 1 || n > 3) bad = 1; seen[n]++ }
     END { exit bad || seen[1] < 10 || seen[3] < 10 }' parallels.obj
cp segment.obj kept.obj
rejects 2 "this command reads the file" distances "$grid" --source-curve kept.obj -o kept.obj
cmp kept.obj segment.obj
[ ! -e x.obj ]
no_remains
