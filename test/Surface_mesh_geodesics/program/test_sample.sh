#!/usr/bin/env bash
# surface_mesh_geodesics sample
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

"$program" sample "$grid" --number 4 --first 0 > corners.csv 2> note
equals "$(line corners.csv 1)" sample,vertex,x,y,z
equals "$(column corners.csv sample | paste -sd ' ')" "0 1 2 3"
equals "$(column corners.csv vertex | line /dev/stdin 1)" 0
equals "$(column corners.csv vertex | line /dev/stdin 2)" 15
equals "$(column corners.csv vertex | sort -n | paste -sd ' ')" "0 3 12 15"
contains note "4 samples; the farthest vertex is 0.471405 from its nearest one"
is_silent sample "$grid" --number 4 --first 0 --quiet > again.csv
cmp corners.csv again.csv

# Until all vertices are near enough: no vertex is farther than the radius, and one sample fewer does not suffice.
"$program" sample "$grid" --radius 0.4 --first 0 > near.csv 2> /dev/null
samples=$(column near.csv vertex | paste -sd ,)
is_silent distances "$grid" --source "$samples" > distances.csv
awk -F, 'NR > 1 && $2 > 0.4 { exit 1 }' distances.csv
is_silent distances "$grid" --source "${samples%,*}" > distances.csv
awk -F, 'NR > 1 && $2 > 0.4 { found = 1 } END { exit !found }' distances.csv

# First samples, specified in all ways that vertices can be.
printf '5\n10\n' > first.txt
is_silent sample "$grid" --number 3 --first 0 --first-file first.txt --quiet > first.csv
equals "$(column first.csv vertex | paste -sd ' ')" "0 5 10"
is_silent sample "$grid" --number 2 --first-random 2 --seed 3 --quiet > random.csv
equals "$(column random.csv vertex | sort -u | wc -l)" 2
is_silent sample "$grid" --number 2 --first-random 2 --seed 4 --quiet > other.csv
differ random.csv other.csv

# All vertices, if more samples are requested than there are vertices.
is_silent sample "$grid" --number 100 --quiet > all.csv
equals "$(column all.csv vertex | sort -n | paste -sd ' ')" "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15"

is_silent sample "$grid" --number 5 --quiet -o s.ply -o s.vtk -o s.obj
contains s.vtk "VERTICES 5 10"
contains s.vtk "SCALARS vertex int 1"
contains s.ply "element vertex 5"
equals "$(grep -c '^p ' s.obj)" 5


# Each option for files takes the table.
for options in "distances --source-file" "path --source 0 --target-file" "voronoi --site-file" \
  "sample --number 5 --first-file" "matrix --source 0 --target-file"; do
  is_silent ${options%% *} "$grid" ${options#* } corners.csv --quiet > with_samples.csv
done
equals "$(line with_samples.csv 1)" "source,$(column corners.csv vertex | paste -sd ,)"
"$program" sample "$grid" --number 100 --first 0 > all.csv 2> note
contains note "--number: there are only 16 vertices"
"$program" sample "$data/two_components.off" --number 1 > one.csv 2> note
contains note "1 sample does not reach all vertices; the mesh has 2 components"

# Samples that keep away from the border, and from a curve.
is_silent sample "$data/grid5.off" --number 1 --first-border --quiet > inside.csv
is_near "$(column inside.csv x)" 0.5
is_near "$(column inside.csv y)" 0.5
"$program" sample "$data/grid5.off" --number 1 --first-border -o inside.csv 2> note
contains note "1 sample; the farthest vertex is 0.25 from its nearest one or the nearest curve"
printf '2 0 0 0 1 0 0\n' > side.polylines.txt
is_silent sample "$data/grid5.off" --number 2 --first-curve side.polylines.txt --quiet > away.csv
equals "$(column away.csv y | paste -sd ' ')" "1 1"
# Samples that are moved afterwards: first ones stay, and the border is a curve. In the middle of a square, a sample
# that has its border as a curve rests; without, two samples share the square.
is_silent sample "$data/grid5.off" --number 1 --first-border --iterations 9 --quiet > moved.csv
cmp inside.csv moved.csv
is_silent sample "$data/grid5.off" --number 2 --first 0 --iterations 9 --quiet > moved.csv
equals "$(column moved.csv vertex | line /dev/stdin 1)" 0
is_silent sample "$data/grid5.off" --number 2 --first 0 --quiet > still.csv
differ moved.csv still.csv
"$program" sample "$data/grid5.off" --number 1 --iterations 9 -o moved.csv 2> note
is_near "$(column moved.csv x)" 0.5
is_near "$(column moved.csv y)" 0.5
contains note "1 sample; the farthest vertex is 0.707107 from its nearest one"
rejects 2 "--iterations: '-1' is not a whole number from 0 to 1000000" sample none.off --number 3 --iterations -1

rejects 2 "--first-border: the surface has no border" sample "$data/cube.off" --number 3 --first-border
rejects 3 "none.obj" sample "$grid" --number 3 --first-curve none.obj
cp side.polylines.txt kept.csv
rejects 2 "this command reads the file" sample "$grid" --number 3 --first-curve kept.csv -o kept.csv

rejects 2 "neither --number nor --radius is given" sample "$grid"
rejects 2 "--number: '0' is not a whole number of 1 or more" sample none.off --number 0
rejects 2 "--number: 'abc' is not a whole number of 1 or more" sample none.off --number abc
rejects 2 "'-1' is not a positive number" sample none.off --radius -1
rejects 2 "unrecognised option '--first-point" sample "$grid" --number 3 --first-point 0.1,0.1,0
rejects 2 "more first samples than --number" sample "$grid" --number 1 --first 0,1
no_remains
