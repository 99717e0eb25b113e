#!/usr/bin/env bash
# surface_mesh_geodesics voronoi
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3
sphere=$data/../../../examples/Surface_mesh_geodesics/data/bumpy_sphere.off

# The corners of the square: four quarters of it.
is_silent voronoi "$grid" --site 0,3,15,12 > cells.csv
equals "$(line cells.csv 1)" site,vertex,x,y,z,weight,area,is_disk,neighbors
for i in 1 2 3 4; do
  is_near "$(column cells.csv area | line /dev/stdin $i)" 0.25
  equals "$(column cells.csv is_disk | line /dev/stdin $i)" 1
done
equals "$(column cells.csv x | paste -sd ' ')" "0 0 1 1"

# Two sites: the bisector is the middle line; with weights it is a hyperbola, nearer to the smaller weight.
is_silent voronoi "$grid" --site-point 0,0.5,0 --site-point 1,0.5,0 -o two.csv -o two.obj -o two.ply -o two.vtk
is_near "$(column two.csv area | line /dev/stdin 1)" 0.5
equals "$(column two.csv neighbors | paste -sd ' ')" "1 0"
awk '$1 == "v" { if(($2 - 0.5)^2 > 1e-24) exit 1; ++n } END { exit !(n > 1) }' two.obj
contains two.ply "property int site"
contains two.vtk "SCALARS site int 1"
is_silent distances two.ply --source 0 --quiet > of_cut_mesh.csv # the cut mesh is a mesh; its lines are no faces
[ "$(wc -l < of_cut_mesh.csv)" -gt 17 ]
is_silent voronoi "$grid" --site-point 0,0.5,0 --site-point 1,0.5,0 --weight 0.2,0 -o weighted.csv -o weighted.obj
awk -v a="$(column weighted.csv area | line /dev/stdin 1)" -v b="$(column weighted.csv area | line /dev/stdin 2)" \
  'BEGIN { d = a + b - 1; exit !(a > 0.6 && d < 1e-9 && d > -1e-9) }'
# the table with the weights gives the same diagram; weights on the command line replace its column
is_silent voronoi "$grid" --site-file weighted.csv -o again.csv
cmp weighted.csv again.csv
is_silent voronoi "$grid" --site-file weighted.csv --weight 0,0 -o unweighted.csv
equals "$(column unweighted.csv weight | paste -sd ,)" 0,0
sed '2s/,0\.2[0-9]*,/,heavy,/' weighted.csv > heavy.csv
rejects 3 "heavy.csv, line 2: 'heavy' is not a weight" voronoi "$grid" --site-file heavy.csv
# on the curve the distances differ by the weight
awk '$1 == "v" { d = sqrt($2^2 + ($3 - 0.5)^2) - sqrt((1 - $2)^2 + ($3 - 0.5)^2) - 0.2; if(d^2 > 1e-20) exit 1; ++n }
  END { exit !(n > 1) }' weighted.obj

# Sites and distances of the vertices.
is_silent voronoi "$grid" --site 0,15 --vertices > vertices.csv
equals "$(line vertices.csv 1)" vertex,site,distance,site_vertex
equals "$(column vertices.csv site | line /dev/stdin 2)" 0
equals "$(column vertices.csv site | line /dev/stdin 15)" 1
is_near "$(column vertices.csv distance | line /dev/stdin 5)" 0.33333333333333331
"$program" voronoi "$data/two_components.off" --site 0 --vertices > parts.csv 2> note
contains note "3 of 6 vertices are not reached; the mesh has 2 components"
contains parts.csv ",-1,inf"

# Curves as sites: the sides of the square divide it along its diagonals, a parabola lies between a side and a corner.
printf '2 0 0 0 1 0 0\n2 1 0 0 1 1 0\n2 1 1 0 0 1 0\n2 0 1 0 0 0 0\n' > sides.polylines.txt
is_silent voronoi "$grid" --site-curve sides.polylines.txt -o sides.csv -o sides.obj
for i in 1 2 3 4; do
  is_near "$(column sides.csv area | line /dev/stdin $i)" 0.25
done
awk '$1 == "v" { d = ($2 - $3) * ($2 + $3 - 1); if(d > 1e-12 || d < -1e-12) exit 1; ++n } END { exit !(n > 4) }' sides.obj
printf 'v 0 0 0\nv 1 0 0\nl 1 2\n' > side.obj
is_silent voronoi "$grid" --site-point 1,1,0 --site-curve side.obj -o parabola.csv -o parabola.obj
is_near "$(column parabola.csv area | line /dev/stdin 1)" 0.33333333333333331
is_near "$(column parabola.csv area | line /dev/stdin 2)" 0.66666666666666663
awk '$1 == "v" { d = ($2 - 1)^2 + 1 - 2 * $3; if(d > 1e-9 || d < -1e-9) exit 1; ++n } END { exit !(n > 2) }' parabola.obj
# Vertices 6 and 9 are as far from vertex 5 as from the border; weights decide.
numbers_of_sites() { column border.csv site | sort | uniq -c | awk '{ print $2 ":" $1 }' | paste -sd ' '; }
is_silent voronoi "$grid" --site-border --site 5 --weight 0.05,0 --vertices > border.csv
equals "$(numbers_of_sites)" "0:3 1:13"
is_silent voronoi "$grid" --site-border --site 5 --weight 0,0.05 --vertices > border.csv
equals "$(numbers_of_sites)" "0:1 1:15"
rejects 2 "--site-border: the surface has no border" voronoi "$data/tetra.off" --site-border

# A smaller tolerance gives more points.
is_silent voronoi "$grid" --site 0,6,15 --weight 0,0.1,0 --tolerance 1e-2 -o coarse.obj
is_silent voronoi "$grid" --site 0,6,15 --weight 0,0.1,0 --tolerance 1e-7 -o fine.obj
[ "$(grep -c '^v ' fine.obj)" -gt "$(grep -c '^v ' coarse.obj)" ]

# The same table beside other files comes from the diagram.
is_silent voronoi "$sphere" --site-random 40 --quiet --vertices > labels.csv
remarks " and 12 more, which a table .csv names" voronoi "$sphere" --site-random 32 -o random.csv
equals "$(column random.csv vertex | sort -u | wc -l)" 32
is_silent voronoi "$sphere" --site-random 40 --quiet --vertices -o from_diagram.csv -o x.obj
cmp labels.csv from_diagram.csv
weighted=(--site-point 0,0.5,0 --site-point 1,0.4,0 --weight 0.2,0)
is_silent voronoi "$grid" "${weighted[@]}" --vertices > labels.csv
is_silent voronoi "$grid" "${weighted[@]}" --vertices -o from_diagram.csv -o x.obj
# All vertices of the grid are flat: labels are computed on larger triangles, and differ in last digits.
paste -d, labels.csv from_diagram.csv | awk -F, 'NR > 1 {
  d = $3 - $(NF / 2 + 3); if($1 != $(NF / 2 + 1) || $2 != $(NF / 2 + 2) || d > 1e-12 || d < -1e-12) exit 1 }'

# Cells as meshes, and their boundaries as polylines: the cell of two sites at the sides of the square is its half.
sides=(--site-point 0,0.5,0 --site-point 1,0.5,0)
is_silent voronoi "$grid" "${sides[@]}" --cell 1 -o cell.off -o open.polylines.txt
is_silent voronoi "$grid" "${sides[@]}" --cell 1 --along-border -o closed.polylines.txt
is_silent voronoi "$grid" "${sides[@]}" -o all.off -o all.polylines.txt
is_silent info cell.off > cell.csv
is_near "$(grep '^area,' cell.csv | cut -d, -f2)" 0.5
is_silent info all.off > all.csv
is_near "$(grep '^area,' all.csv | cut -d, -f2)" 1
equals "$(wc -l < open.polylines.txt) $(wc -l < all.polylines.txt) $(wc -l < closed.polylines.txt)" "1 2 1"
awk '{ for(i = 2; i < NF; i += 3) if(($i - 0.5)^2 > 1e-24) exit 1; exit NF != 3 * $1 + 1 }' open.polylines.txt
# closed: the last point is the first one; the area by the formula for polygons is that of the cell, negative because
# the faces of this mesh run clockwise
awk '{ n = NF; if($2 != $(n - 2) || $3 != $(n - 1)) exit 1
  for(i = 2; i + 4 < NF; i += 3) a += ($i * $(i + 4) - $(i + 3) * $(i + 1)) / 2
  exit !((a + 0.5)^2 < 1e-24) }' closed.polylines.txt

# Colors: one for each cell, as in the header of the file. Adjacent cells have different colors.
is_silent voronoi "$sphere" --site-random 40 --quiet -o colors.ply -o neighbors.csv
contains colors.ply "format binary_little_endian 1.0"
LC_ALL=C sed '/^end_header/q' colors.ply | awk '
  FNR == NR { if($1 == "comment") color[$3] = $5 " " $6 " " $7; if($2 == "face") faces = $3; next }
  { split($0, field, ","); split(field[9], neighbor, " ")
    for(i in neighbor) { ++pairs; if(color[field[1]] == color[neighbor[i]]) exit 1 } }
  END { exit !(faces > 1000 && pairs > 150) }' - <(tail -n +2 neighbors.csv)

rejects 2 "no site is given" voronoi "$grid"
rejects 2 "2 weights for 1 sites" voronoi "$grid" --site 0 --weight 1,2
rejects 2 "--weight: 'abc' is not a number" voronoi none.off --site 0 --weight 1,abc
rejects 2 "--weight: 'nan' is not a number" voronoi none.off --site 0 --weight nan
rejects 2 "--weight: '1e400' is not a number" voronoi none.off --site 0 --weight 1e400
rejects 2 "--weight: '' is not a number" voronoi none.off --site 0 --weight 1,
rejects 2 "'0' is not a positive number" voronoi none.off --site 0 --tolerance 0
rejects 2 "--tolerance: 1e-30 is too small for a mesh of this size; give 1.41421e-09 or more" \
  voronoi "$grid" --site 0,15 --tolerance 1e-30 -o x.ply
is_silent voronoi "$grid" --site 0,6,15 --weight 0,0.1,0 --tolerance 1.5e-9 -o finest.obj # almost too small
[ "$(wc -c < finest.obj)" -lt 10000000 ]
remarks "--tolerance has no effect without an output .ply, .vtk, .obj, .off, .polylines.txt, .html" \
  voronoi "$grid" --site 0 --tolerance 1
remarks "--vertices has no effect without an output .csv" voronoi "$grid" --site 0,15 --vertices -o x.obj
remarks "--cell has no effect without an output .off, .polylines.txt" voronoi "$grid" --site 0,15 --cell 1
remarks "--along-border has no effect without an output .polylines.txt" voronoi "$grid" --site 0,15 --along-border
rejects 2 "--cell: there is no site 2, but 2, counted from 0" voronoi "$grid" --site 0,15 --cell 2 -o x.off
rejects 2 "'x'" voronoi none.off --site 0 --cell x
rejects 2 "the name must end with one of" voronoi "$grid" --site 0 -o x.stl
no_remains
