#!/usr/bin/env bash
# surface_mesh_geodesics distances
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

# The table, on the standard output and in a file.
is_silent distances "$grid" --source 0 > table.csv
equals "$(line table.csv 1)" vertex,distance,source,source_vertex
equals "$(wc -l < table.csv)" 17
is_near "$(column table.csv distance | line /dev/stdin 16)" 1.4142135623730951
is_near "$(column table.csv distance | line /dev/stdin 10)" 0.74535599249992990
equals "$(column table.csv source | sort -u)" 0
is_silent distances "$grid" --source 0 -o file.csv > out
[ ! -s out ]
cmp table.csv file.csv
is_silent distances "$grid" --source 0 -o - > out
cmp table.csv out

# Several sources, specified in all ways, in this order.
printf '# corners\n3\n1 0 0\n\n17 0 0 1 # the last corner of the last face, vertex 14\n' > locations.txt
is_silent distances "$grid" --source 0 --source-point 0.5,0.5,0.3 --snap --source-file locations.txt --quiet -o several.csv
equals "$(column several.csv source | line /dev/stdin 1)" 0
equals "$(column several.csv source | line /dev/stdin 4)" 2
equals "$(column several.csv source | line /dev/stdin 13)" 3
is_near "$(column several.csv distance | line /dev/stdin 6)" 0.23570226039551584
equals "$(column several.csv source | line /dev/stdin 6)" 1
is_near "$(column several.csv distance | line /dev/stdin 15)" 0
equals "$(column several.csv source | line /dev/stdin 15)" 4
remarks "--source-point -3,0,0: the point was moved to the surface, by 2.12 times the diagonal of the mesh" \
  distances "$grid" --source-point -3,0,0 --snap -o negative.csv
cmp <(cut -d, -f1,2 table.csv) <(cut -d, -f1,2 negative.csv)

# Random sources depend on the seed only.
is_silent distances "$grid" --source-random 3 --seed 5 --quiet > first.csv
is_silent distances "$grid" --source-random 3 --seed 5 --quiet > again.csv
is_silent distances "$grid" --source-random 3 --seed 6 --quiet > other.csv
cmp first.csv again.csv
differ first.csv other.csv
equals "$(column first.csv distance | grep -c '^0$')" 3
# A remark lists them in order.
remarks "--source-random: vertices " distances "$grid" --source-random 3 --seed 5
cmp remarks.out first.csv
chosen=$(sed 's/.*vertices //; s/,//g' remarks.err)
equals "$(for v in $chosen; do line first.csv $((v + 2)); done)" "$(i=0; for v in $chosen; do echo "$v,0,$((i++)),$v"; done)"

# A radius, and a surface in two parts.
is_silent distances "$grid" --source 0 --radius 0.5 > near.csv
equals "$(column near.csv distance | grep -vc inf)" 4
equals "$(column near.csv source | grep -c -- -1)" 12
remarks "3 of 6 vertices are not reached; the mesh has 2 components" distances "$data/two_components.off" --source 0
mv remarks.out parts.csv
[ "$(column parts.csv distance | grep -c inf)" -gt 0 ]
equals "$(column parts.csv distance | grep -c inf)" "$(column parts.csv source | grep -c -- -1)"

# Files for viewers: the mesh, a color for each point, and nothing else.
is_silent distances "$grid" --source 0 -o d.vtk -o d.obj -o d.ply -o d.vtu
contains d.vtk "POLYGONS 18 72"
contains d.vtk "POINT_DATA 16"
contains d.vtk "SCALARS distance double 1"
equals "$(grep --text -c "^LINES\|^CELL_DATA" d.vtk)" 0
contains d.vtu 'NumberOfPoints="16" NumberOfCells="18"'
equals "$(grep -c '^v ' d.obj)" 16
equals "$(grep -c '^f ' d.obj)" 18
equals "$(awk '$1 == "v" { print NF }' d.obj | sort -u)" 7
contains d.ply "format binary_little_endian 1.0"
contains d.ply "element vertex 16"
contains d.ply "property double quality"
equals "$(grep --text -c "element edge" d.ply)" 0
is_silent distances d.ply --source 0 > again.csv
cmp table.csv again.csv

# The isolines at the requested distances, in files of their own, from the same propagation.
is_silent distances "$grid" --source 0 --spacing 0.5 --lines l.obj --lines l.ply --lines l.vtk --lines l.vtu -o l.csv
cmp table.csv l.csv
equals "$(grep -c '^l ' l.obj)" 2
awk '$1 == "v" { r = sqrt($2^2 + $3^2); if((r - 0.5)^2 > 1e-20 && (r - 1)^2 > 1e-20) exit 1; ++n } END { exit !n }' l.obj
number_of_points=$(grep -c '^v ' l.obj)
contains l.ply "element vertex $number_of_points"
contains l.ply "element edge $((number_of_points - 2))"
contains l.vtk "LINES 2 "
contains l.vtk "CELL_DATA 2"
contains l.vtu "NumberOfPoints=\"$number_of_points\" NumberOfCells=\"2\""
is_silent distances "$grid" --source 0 --isolines 3 --lines three.vtk > out
contains three.vtk "LINES 2 " # at 0.5 and 1: "about 3"
[ ! -s out ]
# The distances of isolines are chosen in little time, also beside a face that is longer than all others by far.
awk 'BEGIN { n = 20; print "OFF"; print n * n + 1, 2 * (n - 1) * (n - 1) + 1, 0
  for(i = 0; i < n * n; ++i) printf "%.17g %.17g 0\n", 1e-12 * (i % n), 1e-12 * int(i / n)
  print "1 -1 0"
  for(j = 0; j + 1 < n; ++j) for(i = 0; i + 1 < n; ++i) {
    a = j * n + i; print 3, a, a + 1, a + n + 1; print 3, a, a + n + 1, a + n }
  print 3, 1, 0, n * n }' > long_face.off
is_silent distances long_face.off --source 399 --isolines 6 --lines long_face.vtk
contains long_face.vtk "LINES 7 " # at 0.2, 0.4, ..., 1.4
rejects 2 "same.ply: --lines and --output name the same file" distances "$grid" --source 0 --lines same.ply -o same.ply
for scale in 1e200 1e-200; do # lengths whose squares are not numbers
  awk -v s=$scale 'NR > 2 && NF == 3 { $1 *= s; $2 *= s; $3 *= s } { print }' OFMT=%.17g CONVFMT=%.17g "$grid" > extreme.off
  is_silent distances extreme.off --source 0 --isolines 3 --lines extreme.vtk
  contains extreme.vtk "LINES 2 "
done
rejects 2 "lines.csv: the name must end with one of .obj, .ply, .vtk, .vtu" \
  distances "$grid" --source 0 --lines lines.csv

# An existing file is replaced, also through a link; other files stay.
echo old > old.csv
ln -s old.csv link.csv
is_silent distances "$grid" --source 0 -o link.csv
[ -L link.csv ]
cmp table.csv old.csv

# Faces that are not triangles.
printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' > square.off
"$program" distances square.off --source 0 > square.csv 2> note
contains note "cut 1 face into 2 triangles"
is_near "$(column square.csv distance | line /dev/stdin 3)" 1.4142135623730951
is_silent distances square.off --source 0 --quiet > quiet.csv
cmp square.csv quiet.csv

# Wrong command lines.
rejects 2 "no source is given; use --source, --source-point, --source-file, --source-border, --source-curve or" \
  distances "$grid"
rejects 2 "no mesh is given" distances --source 0
rejects 2 "there is no vertex 16; the vertices of the mesh are 0 to 15" distances "$grid" --source 16
rejects 2 "'-1' is not a vertex index" distances "$grid" --source -1
rejects 2 "'1.5' is not a vertex index" distances "$grid" --source 1.5
rejects 2 "three finite numbers" distances "$grid" --source-point 1,2
rejects 2 "three finite numbers" distances "$grid" --source-point nan,0,0
rejects 2 "--source-point 0,1e7,0: the distance of the point from the mesh is more than a million times the size" \
  distances "$grid" --source-point 0,1e7,0
rejects 2 "more than a million times" distances "$grid" --source-point -1e308,1e308,1e308 --snap
rejects 2 "--source-point 0,0,0.02: the point is 0.02 from the surface, 1.41 % of the diagonal of the mesh; --snap" \
  distances "$grid" --source-point 0,0,0.02
is_silent distances "$grid" --source-point 0,0,0.0001 > near_point.csv
remarks "--source-point 0,0,0.01: the point was moved to the surface, by 0.707 % of the diagonal of the mesh" \
  distances "$grid" --source-point 0,0,0.01
remarks "by 7.07e+05 times the diagonal of the mesh" distances "$grid" --source-point -1e6,0,0 --snap -o far.csv
cmp <(cut -d, -f1,2 table.csv) <(cut -d, -f1,2 far.csv)
equals "$(line far.csv 1)" vertex,distance,source,source_vertex,source_face,source_b0,source_b1,source_b2
rejects 2 "only 16 vertices" distances "$grid" --source-random 17
rejects 2 "'inf' is not a positive number" distances "$grid" --source 0 --radius inf
rejects 2 "cannot be combined" distances "$grid" --source 0 --isolines 3 --spacing 1 --lines x.vtk
rejects 2 "--spacing: more than 1000 lines up to the distance " \
  distances "$grid" --source 0 --spacing 1e-9 --lines x.vtk
for number in 1001 99999999999999999999 -1 2.5 1e3 abc ""; do
  rejects 2 "--isolines: '$number' is not a whole number from 0 to 1000" \
    distances none.off --source 0 --isolines "$number" -o x.vtk
done
for number in abc -3 1.5 18446744073709551616; do
  rejects 2 "--seed: '$number' is not a whole number of 0 or more" distances none.off --source-random 1 --seed "$number"
done
for number in nan inf -inf -1 0 1e400 1e-400 "" " 1" 1x; do
  rejects 2 "--radius: '$number' is not a positive number, such as 0.5 or 1e-3" \
    distances none.off --source 0 --radius "$number"
done
rejects 2 "--source: '' is not a vertex index" distances none.off --source 0,
rejects 2 "only 16 vertices" distances "$grid" --source-random 99999999999
remarks "--seed has no effect: no random locations are requested" distances "$grid" --source 0 --seed 1
is_silent distances "$grid" --source 0 --seed 1 --quiet
remarks "--isolines has no effect without --lines or a page .html" distances "$grid" --source 0 --isolines 3
remarks "--spacing has no effect without --lines or a page" distances "$grid" --source 0 --spacing 1 -o x.csv
is_silent distances "$grid" --source 0 --isolines 1000 --lines most.vtk
[ "$(grep --text "^LINES" most.vtk | cut -d " " -f 2)" -ge 500 ]

# Endings of names may be in upper case.
is_silent distances "$grid" --source 0 -o A.CSV -o A.Obj -o A.PLY
cmp table.csv A.CSV
is_silent distances A.PLY --source 0 -o B.CSV
cmp B.CSV table.csv
"$program" remesh "$grid" --number 16 --quiet -o C.OBJ
is_silent info C.OBJ > info.csv
contains info.csv vertices,16
rejects 2 "the name must end with one of .csv, .ply, .vtu, .vtk, .obj" distances "$grid" --source 0 -o x.txt
rejects 2 "--nonsense" distances "$grid" --source 0 --nonsense
[ ! -e x.vtk ]
no_remains
