#!/usr/bin/env bash
# surface_mesh_geodesics --avoid
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

# The two faces of the square in the middle: the diagonal leads around it, through one of its corners.
number_of_vertices=$(line "$grid" 2 | cut -d ' ' -f 1)
awk -v n="$number_of_vertices" 'NR == FNR { if(FNR > 2 && FNR <= n + 2) { x[FNR - 3] = $1; y[FNR - 3] = $2 } next }
  FNR > n + 2 && NF >= 4 { cx = (x[$2] + x[$3] + x[$4]) / 3; cy = (y[$2] + y[$3] + y[$4]) / 3
    if(cx > 1/3 && cx < 2/3 && cy > 1/3 && cy < 2/3) print FNR - n - 3 }' "$grid" "$grid" > middle.txt
equals "$(wc -l < middle.txt)" 2
around=$(awk 'BEGIN { printf "%.17g", 2 * sqrt(5) / 3 }')
is_silent path "$grid" --source 0 --target 15 --avoid middle.txt -o path.csv -o path.polylines.txt
is_near "$(column path.csv length)" "$around"
equals "$(cut -d ' ' -f 1 path.polylines.txt)" "$(awk '{ print NF == 3 * $1 + 1 ? $1 : "bad" }' path.polylines.txt)"

# All commands with the option know the faces, in any form of the file.
{ printf '# the middle\n'; paste -sd, middle.txt; printf '\n'; } > comments.txt
is_silent distances "$grid" --source 0 --avoid comments.txt -o distances.csv --lines lines.obj
is_near "$(column distances.csv distance | line /dev/stdin 16)" "$around"
is_silent distances "$grid" --source 0 --avoid comments.txt -o again.csv
cmp again.csv distances.csv
is_silent matrix "$grid" --source 0 --target 15 --avoid middle.txt -o matrix.csv
is_near "$(line matrix.csv 2 | cut -d, -f2)" "$around"
is_silent voronoi "$grid" --site 0,15 --avoid middle.txt -o cells.csv -o cells.off -o cells.ply
is_near "$(column cells.csv area | awk '{ s += $1 } END { printf "%.17g", s }')" \
  "$(awk 'BEGIN { printf "%.17g", 8 / 9 }')"
is_silent voronoi "$grid" --site 0 --avoid middle.txt --vertices -o labels.csv
is_near "$(column labels.csv distance | line /dev/stdin 16)" "$around"

# An index counts the faces of the file, and stands for all triangles of a face that is cut.
printf 'OFF\n6 2 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n4 0 1 4 3\n4 1 2 5 4\n' > quads.off
echo 1 > right.txt
"$program" distances quads.off --source 3 --avoid right.txt > quads.csv 2> note
equals "$(column quads.csv distance | line /dev/stdin 3)" inf
equals "$(column quads.csv distance | line /dev/stdin 6)" inf
is_near "$(column quads.csv distance | line /dev/stdin 2)" 1.4142135623730951
echo 2 > beyond.txt
rejects 3 "beyond.txt, line 1: there is no face 2, but 2 faces, counted from 0" \
  distances quads.off --source 3 --avoid beyond.txt --quiet
printf '\xef\xbb\xbf1\r\n' > mark.txt # as Windows writes it
"$program" distances quads.off --source 3 --avoid mark.txt 2> note | cmp - quads.csv

# A stored matrix names the faces, so it can be verified without the file, and continued only with it.
"$program" matrix "$grid" --quiet --source all --avoid middle.txt --store stored > status.csv
equals "$(column status.csv rows_done)" 16
contains stored/manifest.json '"faces_to_avoid"'
"$program" matrix --verify stored --quiet > verified.csv
equals "$(column verified.csv failures | head -n 2 | paste -sd ' ')" "0 0"
"$program" matrix "$grid" --quiet --source all --avoid comments.txt --store stored --resume > again.csv
cmp again.csv status.csv
rejects 3 "and those of this call have the hash" matrix "$grid" --source all --store stored --resume
"$program" matrix "$grid" --quiet --source all --avoid middle.txt --store peeled --symmetric --peel > status.csv
"$program" matrix --verify peeled --quiet > verified.csv
equals "$(column verified.csv failures | head -n 2 | paste -sd ' ')" "0 0"

# Certificates, samples and new meshes.
is_silent check "$grid" --source 0 --avoid middle.txt -o certificate.csv
is_silent check "$grid" --source 0 --avoid middle.txt --distances distances.csv -o certificate.csv
rejects 1 "the distances are not certified" check "$grid" --source 0 --distances distances.csv \
  -o uncertified.csv
is_silent sample "$grid" --quiet --number 16 --first 0 --avoid middle.txt -o samples.csv
equals "$(column samples.csv vertex | line /dev/stdin 2)" 15
is_silent remesh "$grid" --quiet --number 16 --avoid middle.txt -o rest.off
equals "$(line rest.off 2 | cut -d ' ' -f 1-2)" "16 16"
"$program" remesh "$grid" --number 16 --avoid middle.txt -o rest.off 2> notes.txt
grep -q "the two surfaces are the same, up to rounding" notes.txt || fail "the surfaces differ: $(cat notes.txt)"
seq 0 17 > every.txt
rejects 1 "--avoid leaves no face" remesh "$grid" --number 16 --avoid every.txt

# No way around.
seq 0 17 > all.txt
rejects 3 "inside of the faces to avoid" distances "$grid" --source 5 --avoid all.txt
awk 'NR == FNR { avoided[$1]; next } !($1 in avoided)' middle.txt all.txt > but_middle.txt
remarks "of 16 vertices are not reached; the mesh has 1 component, and paths avoid faces or edges" \
  distances "$grid" --source 5 --avoid but_middle.txt
rejects 1 "no source reaches vertex 0; the mesh has 1 component, and paths avoid faces or edges" \
  path "$grid" --source 5 --target 0 --avoid but_middle.txt

# Wrong files.
rejects 3 "none.txt" distances "$grid" --source 0 --avoid none.txt
printf '1\n\n2 x\n' > word.txt
rejects 3 "word.txt, line 3: 'x' is not the index of a face" distances "$grid" --source 0 --avoid word.txt
printf '17 18\n' > outside.txt
rejects 3 "outside.txt, line 1: there is no face 18, but 18 faces, counted from 0" \
  distances "$grid" --source 0 --avoid outside.txt
printf -- '-1\n' > negative.txt
rejects 3 "negative.txt, line 1: '-1' is not the index of a face" path "$grid" --source 0 --target 1 --avoid negative.txt
cp middle.txt kept.csv
rejects 2 "this command reads the file" distances "$grid" --source 0 --avoid kept.csv -o kept.csv
cmp kept.csv middle.txt

# What has no faces to avoid.
rejects 2 "a stored matrix tells the faces to avoid: no --avoid" matrix --status stored --avoid middle.txt
rejects 2 "a stored matrix tells the faces to avoid: no --avoid" matrix --verify stored --avoid middle.txt
echo "$grid" > meshes.txt
rejects 2 "--avoid names the faces of one mesh: not with --meshes" \
  matrix --meshes meshes.txt --source all --store rows --avoid middle.txt
[ ! -e rows ] || fail "a folder was made"
