#!/usr/bin/env bash
# What files with meshes may look like, what is wrong with them where they are not read, and --repair.
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3
"$program" distances "$grid" --source 0 > table.csv

# same_distances <file>: the distances of the square
same_distances() {
  is_silent distances "$1" --source 0 > same.csv
  cmp same.csv table.csv || fail "$1 has other distances"
}

# points <format of awk>, faces <format of awk> <first index>: the square in lines of text
points() {
  awk -v format="$1" 'NR > 2 && NF == 3 { printf format "\n", $1, $2, $3 }' "$grid"
}
faces() {
  awk -v format="$1" -v one="$2" 'NR > 2 && NF == 4 { printf format "\n", $2 + one, $3 + one, $4 + one }' "$grid"
}

# --- OFF --------------------------------------------------------------------------------------------------------------

{ printf '\xef\xbb\xbf'; cat "$grid"; } > mark.off
sed 's/$/\r/' "$grid" > crlf.off
tr '\n' '\r' < "$grid" > cr.off
{ echo "# a comment"; echo "OFF # another one"; echo; echo "16 18 # no number of edges"; points "%s %s %s # point"
  faces "3 %s %s %s 255 0 0" 0; } > comments.off
{ echo "OFF 16 18 0"; points "+%s\t%s  %s"; faces " 3\t%s %s %s" 0; } > one_line.off
{ echo COFF; echo 16 18 0; points "%s %s %s 255 0 0 255"; faces "3 %s %s %s 0.5 0 0" 0; } > colors.off
{ echo NOFF; echo 16 18 0; points "%s %s %s 0 0 1"; faces "3 %s %s %s" 0; } > normals.off
for name in mark crlf cr comments one_line colors normals; do
  same_distances $name.off
done
{ echo 4OFF; echo 16 18 0; awk 'NR > 2 && NF == 3 { printf "%.17g %.17g %.17g 2\n", 2 * $1, 2 * $2, 2 * $3 }' "$grid"
  faces "3 %s %s %s" 0; } > fourth.off
same_distances fourth.off
printf 'OFF\n3 1 0\n0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' > comma.off
rejects 3 "comma.off, line 3: '0,5' is not a number: decimals are written with a point, not with a comma" info comma.off
printf 'OFF\n3 1 0\n0 0\n1 0 0\n0 1 0\n3 0 1 2\n' > short.off
rejects 3 "short.off, line 3: the line ends, but a coordinate is needed" info short.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n' > index.off
rejects 3 "index.off, line 6: '3' is not an index of a vertex from 0 to 2" info index.off
printf 'OFF\n3 1 0\n0 0 x1\n1 0 0\n0 1 0\n3 0 1 3\n' > word.off
rejects 3 "word.off, line 3: 'x1' is not a coordinate" info word.off
printf '\xff\xfeO\0F\0F\0' > utf16.off
rejects 3 "utf16.off, line 1: the text is in UTF-16" info utf16.off

# --- TS ---------------------------------------------------------------------------------------------------------------

# Vertices may have any numbers in any order, and several objects number theirs anew.
ts() {
  echo "GOCAD TSurf 1"; echo "HEADER {"; echo "name: VRTX 1"; echo "}"; echo TFACE
}
{ ts; awk 'NR > 2 && NF == 3 { print "VRTX", 100 - NR, $1, $2, $3 } NF == 4 { print "TRGL", 97 - $2, 97 - $3, 97 - $4 }' \
  "$grid"; echo "BSTONE 97"; echo END; } > numbers.ts
same_distances numbers.ts
sed 's/$/\r/' numbers.ts > crlf.ts
same_distances crlf.ts
{ ts; echo "PVRTX 1 0 0 0 7.5"; echo "VRTX 2 1 0 0 CNXYZ"; echo "VRTX 3 1 1 0"; echo "ATOM 4 1"; echo "TRGL 4 2 3"; echo END
  ts; echo "VRTX 1 5 0 0"; echo "VRTX 2 7 0 0"; echo "VRTX 3 7 1 0"; echo "TRGL 1 2 3"; echo END; } > objects.ts
"$program" distances objects.ts --source 3 > objects.csv 2> note
equals "$(column objects.csv distance | paste -sd ' ')" "inf inf inf 0 2 2.23606797749979"
for header in "HEADER { name:a}" "HEADER {name:VRTX 1 }" HEADER; do
  { echo "GOCAD TSurf 1"; echo "$header"; tail -n +6 numbers.ts; } > header.ts
  same_distances header.ts
done
{ ts; echo "VRTX 1 0 0 0"; echo "VRTX 1 1 0 0"; } > twice.ts
rejects 3 "twice.ts, line 7: there are two vertices with the number 1" info twice.ts
{ ts; echo "VRTX 1 0 0 0"; echo "TRGL 1 2 3"; } > missing.ts
rejects 3 "missing.ts, line 7: there is no vertex with the number 2 before" info missing.ts
{ ts; echo "VRTX 1 0 0 0"; } > cut.ts
rejects 3 "the file ends before END" info cut.ts
echo "GOCAD VSet 1" > points.ts
rejects 3 "points.ts, line 1: 'VSet' is not a kind of object that the program reads, which is TSurf" info points.ts

# --- OBJ --------------------------------------------------------------------------------------------------------------

{ echo "mtllib x.mtl"; echo "o thing"; points "v %s %s %s 1 0.5 0"; echo "vn 0 0 1"; echo "vt 0 0"; echo "g part"
  echo "usemtl red"; echo "s off"; faces "f %d/1/1 %d//1 %d/1" 1; echo "l 1 2 3"; echo "p 1"; } > all.obj
same_distances all.obj
{ points "v %s %s %s"; awk 'NR > 2 && NF == 4 { print "f " $2 - 16, $3 - 16, $4 - 16 }' "$grid"; } > negative.obj
same_distances negative.obj
{ points 'v %s \\\n %s %s'; faces 'f %d %d \\\r\n%d' 1; } > continued.obj
same_distances continued.obj
{ faces 'f %d %d %d' 1; points "v %s %s %s"; } > faces_first.obj
same_distances faces_first.obj
# what the program writes, with lines
"$program" distances "$grid" --source 0 -o written.obj --lines lines.obj
cat lines.obj > with_lines.obj
same_distances written.obj
rejects 3 "lines.obj: the file contains no faces" info lines.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nhello world\nf 1 2 3\n' > unknown.obj
remarks "unknown.obj, line 4: 'hello' is not a statement of OBJ that the program knows" info unknown.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n' > word.obj
rejects 3 "word.obj, line 4: 'x' is not a corner of a face, such as 7, 7/7 or 7/7/7" info word.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n' > zero.obj
rejects 3 "zero.obj, line 4: '0' is not an index of a vertex: OBJ counts from 1" info zero.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n' > back.obj
rejects 3 "back.obj, line 4: '-4' is not an index of a vertex: there are 3 before this line" info back.obj
printf 'v 0 0 0\nv 1,5 0 0\nv 0 1 0\nf 1 2 3\n' > comma.obj
rejects 3 "comma.obj, line 2: '1,5' is not a number: decimals" info comma.obj

# --- PLY --------------------------------------------------------------------------------------------------------------

header() { # <format> <type of coordinates>
  printf 'ply\nformat %s 1.0\ncomment x\nelement vertex 16\nproperty uchar red\n' "$1"
  printf 'property %s x\nproperty %s y\nproperty %s z\n' "$2" "$2" "$2"
}
{ header ascii double; echo "element face 18"; echo "property list uchar int vertex_index"; echo end_header
  points "255 %s %s %s"; faces "3 %d %d %d" 0; } > text.ply
same_distances text.ply
sed 's/$/\r/' text.ply > crlf.ply
same_distances crlf.ply
# a strip for each row of squares; -1 begins a new one
{ header ascii double; printf 'element tristrips 1\nproperty list int int vertex_indices\nend_header\n'
  points "255 %s %s %s"; echo "26 0 4 1 5 2 6 3 7 -1 4 8 5 9 6 10 7 11 -1 8 12 9 13 10 14 11 15"; } > strips.ply
is_silent info strips.ply > strips.csv
contains strips.csv faces,18
contains strips.csv borders,1
contains strips.csv area,1
head -n 5 text.ply > no_end.ply
rejects 3 "no_end.ply, line 6: the file ends within its header" info no_end.ply
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty real x\nend_header\n' > type.ply
rejects 3 "type.ply, line 4: 'real' is not a type of numbers, such as int or float" info type.ply
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n' > no_y.ply
rejects 3 "no_y.ply, line 5: the vertices have no coordinates x, y and z" info no_y.ply

# --- STL --------------------------------------------------------------------------------------------------------------

awk 'BEGIN { print "solid square" }
  NR > 2 && NF == 3 { p[n++] = $1 " " $2 " " $3 }
  NR > 2 && NF == 4 { print "facet normal 0 0 1\nouter loop\nvertex " p[$2] "\n VERTEX " p[$3] "\nvertex " p[$4]
    print "endloop\nendfacet" }
  END { print "endsolid square" }' "$grid" > text.stl
is_silent info text.stl > stl.csv
is_silent info "$grid" > off.csv
cmp stl.csv off.csv # all corners are welded
printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0\n' > short.stl
rejects 3 "short.stl, line 5: the line ends, but a coordinate is needed" info short.stl
printf 'solid x\nfacets\n' > word.stl
rejects 3 "word.stl, line 2: 'facets' is not a statement of STL" info word.stl
{ head -c 80 /dev/zero; printf '\3\0\0\0'; head -c 60 /dev/zero; } > half.stl
rejects 3 "half.stl: the file announces 3 faces, but has room for 1 only" info half.stl

# --- standard input and output ----------------------------------------------------------------------------------------

{ printf '# a comment\n#another\n\n'; cat "$grid"; } > comments.off
{ printf 'OFF # a comment\n'; tail -n +2 "$grid"; } > comment_behind.off
for name in "$grid" all.obj text.ply comments.off comment_behind.off; do
  is_silent distances - --source 0 < "$name" > piped.csv
  cmp piped.csv table.csv
done
"$program" info - < text.stl > piped.csv
cmp piped.csv stl.csv
"$program" distances - --source 0 -o - < "$grid" | cmp - table.csv
rejects 3 "standard input: the file is empty" info - < /dev/null

# --- repair -----------------------------------------------------------------------------------------------------------

# repairs <remark> <file>
repairs() {
  "$program" info "$2" --repair > repaired.csv 2> repaired.err || fail "$(cat repaired.err)"
  contains repaired.err "$2: $1"
}
repairs "there is nothing to repair" "$grid"
printf '%s\n' OFF '8 6 0' '0 0 0' '1 0 0' '0 1 0' '1 1 0' '1 0 0' '0 1 0' '5 5 5' '6 5 5' \
  '3 0 1 2' '3 4 5 3' '3 1 2 3' '3 2 0 1' '3 0 0 1' '3 6 7 7' > soup.off
rejects 3 "soup.off: face 4 (line 15) has the vertex 0 twice; --repair may mend it" info soup.off
repairs "2 vertices merged with others, 2 degenerate faces left out, 2 repeated faces left out, 1 face reversed" soup.off
contains repaired.csv faces,2
contains repaired.csv components,1
# an edge with three faces, a strip without orientation, and two tetrahedra that share a vertex
printf '%s\n' OFF '5 3 0' '0 0 0' '1 0 0' '0 1 0' '0 -1 0' '0 0 1' '3 0 1 2' '3 1 0 3' '3 0 1 4' > three.off
rejects 3 "three.off: the edge of the vertices 0 and 1 has 3 faces: face 0 (line 8), face 2 (line 10), face 1 (line 9)" \
  info three.off
repairs "1 edge with more than two faces split, " three.off
printf '%s\n' OFF '5 5 0' '0 0 0' '1 0 0' '0 1 0' '0 0 1' '1 1 1' '3 0 1 2' '3 1 3 2' '3 2 3 4' '3 3 0 4' '3 4 0 1' \
  > moebius.off
repairs "" moebius.off
printf '%s\n' OFF '7 8 0' '0 0 0' '1 0 0' '0 1 0' '0 0 1' '-1 0 0' '0 -1 0' '0 0 -1' \
  '3 0 2 1' '3 0 1 3' '3 0 3 2' '3 1 2 3' '3 0 4 5' '3 0 6 4' '3 0 5 6' '3 4 6 5' > pinched.off
rejects 3 "pinched.off: several parts of the surface meet at vertex 0; --repair may mend it" info pinched.off
repairs "1 vertex copied to separate parts" pinched.off
contains repaired.csv components,2
no_remains
