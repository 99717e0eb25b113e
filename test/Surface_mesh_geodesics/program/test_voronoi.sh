#!/usr/bin/env bash
# surface_mesh_geodesics voronoi
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

# The corners of the square: four quarters of it.
is_silent voronoi "$grid" --site 0,3,15,12 > cells.csv
equals "$(line cells.csv 1)" site,x,y,z,weight,area,is_disk,neighbours
for i in 1 2 3 4; do
  is_near "$(column cells.csv area | line /dev/stdin $i)" 0.25
  equals "$(column cells.csv is_disk | line /dev/stdin $i)" 1
done
equals "$(column cells.csv x | paste -sd ' ')" "0 0 1 1"

# Two sites: the middle line; with weights it is a hyperbola, nearer to the smaller weight.
is_silent voronoi "$grid" --site-point 0,0.5,0 --site-point 1,0.5,0 -o two.csv -o two.obj -o two.ply -o two.vtk
is_near "$(column two.csv area | line /dev/stdin 1)" 0.5
equals "$(column two.csv neighbours | paste -sd ' ')" "1 0"
awk '$1 == "v" { if(($2 - 0.5)^2 > 1e-24) exit 1; ++n } END { exit !(n > 1) }' two.obj
contains two.ply "property int site"
contains two.vtk "SCALARS site int 1"
is_silent distances two.ply --source 0 > of_cut_mesh.csv # the cut mesh is a mesh
[ "$(wc -l < of_cut_mesh.csv)" -gt 17 ]
is_silent voronoi "$grid" --site-point 0,0.5,0 --site-point 1,0.5,0 --weight 0.2,0 -o weighted.csv -o weighted.obj
awk -v a="$(column weighted.csv area | line /dev/stdin 1)" -v b="$(column weighted.csv area | line /dev/stdin 2)" \
  'BEGIN { d = a + b - 1; exit !(a > 0.6 && d < 1e-9 && d > -1e-9) }'
# on the curve the distances differ by the weight
awk '$1 == "v" { d = sqrt($2^2 + ($3 - 0.5)^2) - sqrt((1 - $2)^2 + ($3 - 0.5)^2) - 0.2; if(d^2 > 1e-20) exit 1; ++n }
  END { exit !(n > 1) }' weighted.obj

# Sites and distances of the vertices.
is_silent voronoi "$grid" --site 0,15 --vertices > vertices.csv
equals "$(line vertices.csv 1)" vertex,site,distance
equals "$(column vertices.csv site | line /dev/stdin 2)" 0
equals "$(column vertices.csv site | line /dev/stdin 15)" 1
is_near "$(column vertices.csv distance | line /dev/stdin 5)" 0.33333333333333331
is_silent voronoi "$data/two_components.off" --site 0 --vertices > parts.csv
contains parts.csv ",-1,inf"

# A tolerance: more points for a smaller one.
is_silent voronoi "$grid" --site 0,6,15 --weight 0,0.1,0 --tolerance 1e-2 -o coarse.obj
is_silent voronoi "$grid" --site 0,6,15 --weight 0,0.1,0 --tolerance 1e-7 -o fine.obj
[ "$(grep -c '^v ' fine.obj)" -gt "$(grep -c '^v ' coarse.obj)" ]

refuses 2 "no site is given" voronoi "$grid"
refuses 2 "2 weights for 1 sites" voronoi "$grid" --site 0 --weight 1,2
refuses 2 "'x' is not a number" voronoi "$grid" --site 0 --weight x
refuses 2 "'0' is not a positive number" voronoi "$grid" --site 0 --tolerance 0
refuses 2 "the end of the name must be one of" voronoi "$grid" --site 0 -o x.stl
no_remains
