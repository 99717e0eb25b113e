#!/usr/bin/env bash
# surface_mesh_geodesics --avoid-property
script=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/marked_grid.py
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
command -v python3 > /dev/null || { echo "SKIPPED: python3 was not found"; exit 77; }
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3
printf '8 9\n' > middle.txt # the square in the middle: the diagonal leads around it, through one of its corners
mkdir marked
python3 "$script" "$grid" middle.txt marked

# Every format and type of numbers: the same as with the numbers of the faces.
is_silent distances "$grid" --source 0 --avoid middle.txt > expected.csv
is_near "$(column expected.csv distance | line /dev/stdin 16)" "$(awk 'BEGIN { printf "%.17g", 2 * sqrt(5) / 3 }')"
is_silent distances "$grid" --source 0 > free.csv
differ free.csv expected.csv
for name in marked/*.ply; do
  is_silent distances "$name" --source 0 --avoid-property mark > found.csv
  cmp found.csv expected.csv
done
equals "$(find marked -name '*.ply' | wc -l)" 48
is_silent distances - --source 0 --avoid-property mark < marked/big_ushort.ply > found.csv
cmp found.csv expected.csv
is_silent distances marked/big_float.ply --source 0 > found.csv
cmp found.csv free.csv

# The property of another file, and both kinds of faces at once.
is_silent distances "$grid" --source 0 --avoid marked/little_double.ply --avoid-property mark > found.csv
cmp found.csv expected.csv
cp marked/text_int.ply UPPER.PLY
is_silent distances "$grid" --source 0 --avoid UPPER.PLY --avoid-property mark > found.csv
cmp found.csv expected.csv
printf '0 8\n' > corner.txt
printf '0 8 9\n' > both.txt
is_silent distances "$grid" --source 0 --avoid both.txt > both.csv
is_silent distances marked/text_int.ply --source 0 --avoid corner.txt --avoid-property mark > found.csv
cmp found.csv both.csv

# All commands with --avoid know the faces.
"$program" path marked/text_int.ply --quiet --source 0 --target 15 --avoid-property mark -o path.csv
is_near "$(column path.csv length)" "$(column expected.csv distance | line /dev/stdin 16)"
"$program" voronoi marked/text_int.ply --quiet --site 0,15 --avoid-property mark -o cells.csv
is_near "$(column cells.csv area | awk '{ s += $1 } END { printf "%.17g", s }')" \
  "$(awk 'BEGIN { printf "%.17g", 8 / 9 }')"
"$program" remesh marked/text_int.ply --quiet --number 16 --avoid-property mark -o rest.off
equals "$(line rest.off 2 | cut -d ' ' -f 1-2)" "16 16"
"$program" sample marked/text_int.ply --quiet --number 2 --first 0 --avoid-property mark -o samples.csv
"$program" sample "$grid" --quiet --number 2 --first 0 --avoid middle.txt -o same.csv
cmp samples.csv same.csv
is_silent check marked/text_int.ply --source 0 --avoid-property mark --distances expected.csv -o certificate.csv
"$program" matrix marked/text_int.ply --quiet --source all --avoid-property mark --store stored > status.csv
tr -d ' \n' < stored/manifest.json > manifest.txt
contains manifest.txt '[8,9]'
"$program" matrix --verify stored --quiet > verified.csv
equals "$(column verified.csv failures | head -n 2 | paste -sd ' ')" "0 0"
seq 0 17 > all.txt
awk 'NR == FNR { avoided[$1]; avoided[$2]; next } !($1 in avoided)' middle.txt all.txt > but_middle.txt
mkdir reversed
python3 "$script" "$grid" but_middle.txt reversed
remarks "of 16 vertices are not reached; the mesh has 1 component, and paths avoid faces or edges" \
  distances reversed/text_int.ply --source 5 --avoid-property mark

# Both triangles of a face that is cut have its mark: the unit square of nine squares, that in the middle is marked.
{ printf 'ply\nformat ascii 1.0\nelement vertex 16\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'element face 9\nproperty float mark\nproperty list uchar uint vertex_index\nend_header\n'
  for i in 0 1 2 3; do for j in 0 1 2 3; do echo "$i $j 0"; done; done
  for i in 0 1 2; do for j in 0 1 2; do
    echo "$((i == 1 && j == 1)) 4 $((4 * i + j)) $((4 * i + j + 4)) $((4 * i + j + 5)) $((4 * i + j + 1))"
  done; done; } > squares.ply
"$program" distances squares.ply --quiet --source 0 --avoid-property mark -o squares.csv
awk -F, 'NR > 1 { x = int($1 / 4); y = $1 % 4; a = sqrt((x - 2)^2 + (y - 1)^2); b = sqrt((x - 1)^2 + (y - 2)^2)
    d = $2 - (x <= 1 || y <= 1 ? sqrt(x^2 + y^2) : sqrt(5) + (a < b ? a : b)); if(d > 1e-12 || d < -1e-12) exit 1; ++n }
  END { exit n != 16 }' squares.csv

# A repair leaves out a degenerate face before the marked ones, which keep their marks.
awk -v face=0 '/^element face/ { print "element face 19"; next } { print } /^end_header/ { h = NR }
  h && NR == h + 16 { print "3 5 5 6 2 1.5 2.5 1 7" }' marked/text_int.ply > degenerate.ply
rejects 3 "--repair may mend it" distances degenerate.ply --source 0 --avoid-property mark
remarks "1 degenerate face left out" distances degenerate.ply --repair --source 0 --avoid-property mark
cmp remarks.out expected.csv
awk '/^element face/ { print "element face 19"; next } { print } /^end_header/ { h = NR }
  h && NR == h + 17 { print }' marked/text_int.ply > repeated.ply
rejects 3 "repeated.ply: --repair leaves out repeated faces" distances repeated.ply --repair --quiet --source 0 \
  --avoid-property mark

# What is missing or wrong.
rejects 3 "grid4.off: this is not a PLY file, and only these have a property 'mark' of faces" \
  distances "$grid" --source 0 --avoid-property mark
rejects 3 "text_int.ply: the faces have no property 'water'; they have: mark, other" \
  distances marked/text_int.ply --source 0 --avoid-property water
rejects 3 "text_int.ply: the property 'list' of faces is a list, but a number is needed" \
  distances marked/text_int.ply --source 0 --avoid-property list
sed -e '/^property int mark/d' -e '/^property ushort other/d' -e 's/ [0-9]* 7$//' marked/text_int.ply > plain.ply
rejects 3 "plain.ply: the faces have no property 'x', and none that is a number" \
  distances plain.ply --source 0 --avoid-property x
sed 's/^property ushort other/property ushort mark/' marked/text_int.ply > twice.ply
rejects 3 "twice.ply: there are several properties 'mark' of faces" distances twice.ply --source 0 --avoid-property mark
sed 's/ 65536 7$/ nan 7/' marked/text_int.ply > word.ply
rejects 3 "word.ply, line " distances word.ply --source 0 --avoid-property mark
LC_ALL=C sed 's/\x00\x00\x80\x3e/\x00\x00\xc0\x7f/g' marked/little_float.ply > no_number.ply
rejects 3 "no_number.ply: the property 'mark' of face 8 is not a number" \
  distances no_number.ply --source 0 --avoid-property mark
printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n%s' \
  $'element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n4 0 1 2 3\n' > strip.ply
rejects 3 "strip.ply: the faces are strips of triangles, which have no properties of their own" \
  distances strip.ply --source 0 --avoid-property mark
rejects 3 "squares.ply: the file has 9 faces, but $grid has 18" \
  distances "$grid" --source 0 --avoid squares.ply --avoid-property mark
awk '/^end_header/ { h = NR } h && NR == h + 20 { t = $2; $2 = $3; $3 = $4; $4 = t } { print }' marked/text_int.ply \
  > turned.ply
rejects 3 "turned.ply: face 3 (line 33) has other vertices than in $grid" \
  distances "$grid" --source 0 --avoid turned.ply --avoid-property mark
rejects 2 "--avoid-property has to name a property of the faces" \
  distances "$grid" --source 0 --avoid marked/text_int.ply
rejects 2 "--avoid-property needs the name of a property" distances marked/text_int.ply --source 0 --avoid-property ''
rejects 2 "a stored matrix tells the faces to avoid: no --avoid-property" matrix --status stored --avoid-property mark
echo "$grid" > meshes.txt
rejects 2 "--avoid-property names the faces of one mesh: not with --meshes" \
  matrix --meshes meshes.txt --source all --store rows --avoid-property mark
[ ! -e rows ] || fail "a folder was made"
no_remains
