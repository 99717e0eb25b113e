#!/usr/bin/env bash
# surface_mesh_geodesics path
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

# The table of lengths.
is_silent path "$grid" --source 0,12 --target 15,4 --target-point 0.5,1,0 > paths.csv
equals "$(line paths.csv 1)" target,source,length,points,target_vertex,target_face,target_b0,target_b1,target_b2,source_vertex
equals "$(column paths.csv target_vertex | paste -sd ' ')" "15 4 "
equals "$(column paths.csv source_vertex | paste -sd ' ')" "12 0 12"
equals "$(column paths.csv target | paste -sd ' ')" "0 1 2"
is_near "$(column paths.csv length | line /dev/stdin 1)" 1
is_near "$(column paths.csv length | line /dev/stdin 2)" 0.33333333333333331
is_near "$(column paths.csv length | line /dev/stdin 3)" 1.1180339887498949
equals "$(column paths.csv source | line /dev/stdin 1)" 1
equals "$(column paths.csv source | line /dev/stdin 2)" 0

# The points of a path: on the straight line, from the target to the source, with the length of the table.
is_silent path "$grid" --source 0 --target-point 1,0.2,0 --points > points.csv
equals "$(line points.csv 1 | cut -d, -f1-6)" target,source,point,x,y,z
awk -F, 'NR == 2 && ($4 - 1)^2 + ($5 - 0.2)^2 > 1e-24 { exit 1 }
  NR > 1 && (($5 - 0.2 * $4)^2 > 1e-24 || $6 != 0) { exit 1 }
  END { if($4^2 + $5^2 > 1e-24) exit 1 }' points.csv
length=$(awk -F, 'NR > 2 { s += sqrt(($4 - x)^2 + ($5 - y)^2) } { x = $4; y = $5 }
  END { printf "%.17g", s }' points.csv)
is_near "$length" 1.0198039027185569

# Around the corner of the L, through its inner vertex.
is_silent path "$data/L_shape.off" --source 0 --target all -o all.csv -o all.obj -o all.vtk -o all.ply \
  -o all.polylines.txt
number_of_vertices=$(line "$data/L_shape.off" 2 | cut -d ' ' -f 1)
equals "$(column all.csv target | wc -l)" "$number_of_vertices"
equals "$(column all.csv length | line /dev/stdin 1)" 0
# a path from the source to itself is not a line
equals "$(wc -l < all.polylines.txt)" $((number_of_vertices - 1))
equals "$(grep -c '^l ' all.obj)" $((number_of_vertices - 1))
contains all.vtk "LINES $((number_of_vertices - 1)) "
contains all.vtk "SCALARS length double 1"
contains all.ply "property double length"
# the sums of the lengths of the lines are those of the table
awk -F, 'NR > 2 { print $3 }' all.csv > lengths
awk '{ s = 0; for(i = 5; i < NF; i += 3) s += sqrt(($i - $(i-3))^2 + ($(i+1) - $(i-2))^2 + ($(i+2) - $(i-1))^2)
  getline length_in_table < "lengths"
  if((s - length_in_table)^2 > 1e-24 || NF != 3 * $1 + 1) exit 1 }' all.polylines.txt

# Nothing but the path from a source to itself.
remarks "all paths are single points, which only tables have" path "$grid" --source 0 --target 0 -o point.obj

# A target that no source reaches.
remarks "no source reaches 3 of 6 targets; the first one is vertex 3; the mesh has 2 components" \
  path "$data/two_components.off" --source 0 --target all
contains remarks.out "3,-1,inf,0,3,"
rejects 1 "no source reaches vertex 4; the mesh has 2 components" \
  path "$data/two_components.off" --source 0 --target 4 -o none.obj
[ ! -e none.obj ]

rejects 2 "no source is given" path "$grid" --target 0
rejects 2 "no target is given" path "$grid" --source 0
rejects 2 "there is no vertex 99" path "$grid" --source 0 --target 99
printf '0\n1 2\n' > two_numbers.txt
rejects 3 "two_numbers.txt, line 2: a point consists of three finite numbers" \
  path "$grid" --source 0 --target-file two_numbers.txt
printf '40 0.2 0.2 0.6\n' > no_face.txt
rejects 3 "'40' is not a face index" path "$grid" --source 0 --target-file no_face.txt
printf '4 0.2 0.2 0.2\n' > no_sum.txt
rejects 3 "the sum of the barycentric coordinates is not 1" path "$grid" --source 0 --target-file no_sum.txt
printf '# nothing\n' > no_location.txt
rejects 3 "the file contains no location" path "$grid" --source 0 --target-file no_location.txt
rejects 3 "none.txt: the file does not exist" path "$grid" --source 0 --target-file none.txt
rejects 3 ".: is a folder, not a file" path "$grid" --source 0 --target-file .
rejects 2 "--target: 'x' is not a vertex index" path none.off --source 0 --target 1,x
rejects 2 "--target-point 0,1e400,0: a point consists of three finite numbers" path none.off --source 0 --target-point 0,1e400,0
rejects 2 "--target-random: '0' is not a whole number of 1 or more" path none.off --source 0 --target-random 0
remarks "--points has no effect without an output .csv" path "$grid" --source 0 --target 1 --points -o path.obj
no_remains
