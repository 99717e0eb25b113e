#!/usr/bin/env bash
# surface_mesh_geodesics --walls
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

# A wall from the border to the point (1, 2) / 3: paths lead around its free end, and run along it.
printf '# from the border\n4, 5\n\n6 5\n' > wall.txt
around=$(awk 'BEGIN { printf "%.17g", (sqrt(5) + sqrt(8)) / 3 }')
is_silent path "$grid" --source 0 --target 12 --walls wall.txt -o path.csv -o path.polylines.txt
is_near "$(column path.csv length)" "$around"
is_silent path "$grid" --source 4 --target 6 --walls wall.txt -o along.csv
is_near "$(column along.csv length)" "$(awk 'BEGIN { printf "%.17g", 2 / 3 }')"
is_silent distances "$grid" --source 0 --walls wall.txt -o distances.csv --lines lines.obj
is_near "$(column distances.csv distance | line /dev/stdin 13)" "$around"
# The foot of the wall is on both sides, and the nearer one counts.
is_near "$(column distances.csv distance | line /dev/stdin 5)" "$(awk 'BEGIN { printf "%.17g", 1 / 3 }')"
is_silent distances "$grid" --source 0 --walls wall.txt -o again.csv
cmp again.csv distances.csv

# From border to border: no way, but the wall itself is reached. Faces may be avoided as well.
printf '4 5\n5 6\n6 7\n' > across.txt
remarks "8 of 16 vertices are not reached; the mesh has 1 component, and paths avoid faces or edges" \
  distances "$grid" --source 0 --walls across.txt -o across.csv
rejects 1 "no source reaches vertex 12; the mesh has 1 component, and paths avoid faces or edges" \
  path "$grid" --source 0 --target 12 --walls across.txt
seq 0 17 > all.txt
rejects 3 "inside of the faces to avoid" distances "$grid" --source 5 --avoid all.txt --walls wall.txt

# Certificates, matrices, labels and samples. The matrix is that of the table of distances.
is_silent check "$grid" --source 0 --walls wall.txt -o certificate.csv
is_silent check "$grid" --source 0 --walls wall.txt --distances again.csv -o certificate.csv
is_silent distances "$grid" --source 0 -o straight.csv
rejects 1 "the distances are not certified" check "$grid" --source 0 --walls wall.txt --distances straight.csv \
  -o uncertified.csv
is_silent matrix "$grid" --source 0 --target 12,4 --walls wall.txt -o matrix.csv
is_near "$(line matrix.csv 2 | cut -d, -f2)" "$around"
is_near "$(line matrix.csv 2 | cut -d, -f3)" "$(awk 'BEGIN { printf "%.17g", 1 / 3 }')"
is_silent voronoi "$grid" --site 0,15 --walls across.txt --vertices -o labels.csv
equals "$(column labels.csv site | line /dev/stdin 13)" 1
is_silent sample "$grid" --quiet --number 2 --first 0 --walls wall.txt -o samples.csv
equals "$(column samples.csv vertex | line /dev/stdin 2)" 12

# A stored matrix names the walls, so it can be verified without the file, and continued only with it.
"$program" matrix "$grid" --quiet --source all --walls wall.txt --store stored > status.csv
equals "$(column status.csv rows_done)" 16
contains stored/manifest.json '"edges_to_avoid"'
"$program" matrix --verify stored --quiet > verified.csv
equals "$(column verified.csv failures | head -n 2 | paste -sd ' ')" "0 0"
rejects 3 "and those of this call have the hash" matrix "$grid" --source all --store stored --resume
rejects 2 "a stored matrix tells the edges to avoid: no --walls" matrix --status stored --walls wall.txt
echo "$grid" > meshes.txt
rejects 2 "--walls names the edges of one mesh: not with --meshes" \
  matrix --meshes meshes.txt --source all --store rows --walls wall.txt

# The wall is a curve: both sides of it are sources. Behind a wall from border to border, the border is near.
printf 'v 0.3333333333333333 0 0\nv 0.3333333333333333 0.6666666666666666 0\nl 1 2\n' > wall.obj
is_silent distances "$grid" --source-curve wall.obj --walls wall.txt -o from_wall.csv
is_silent distances "$grid" --source-curve wall.obj -o from_curve.csv
equals "$(column from_wall.csv distance)" "$(column from_curve.csv distance)"
is_silent distances "$grid" --source-border --walls across.txt -o from_border.csv

# Wrong files.
rejects 3 "none.txt" distances "$grid" --source 0 --walls none.txt
printf '4 5\n4 5 6\n' > three.txt
rejects 3 "three.txt, line 2: an edge is given by two vertices" distances "$grid" --source 0 --walls three.txt
printf '4 x\n' > word.txt
rejects 3 "word.txt, line 1: 'x' is not the index of a vertex" distances "$grid" --source 0 --walls word.txt
printf '4 16\n' > outside.txt
rejects 3 "outside.txt, line 1: there is no vertex 16, but 16 vertices, counted from 0" \
  path "$grid" --source 0 --target 1 --walls outside.txt
printf '0 15\n' > far.txt
rejects 3 "far.txt, line 1: no edge joins the vertices 0 and 15" distances "$grid" --source 0 --walls far.txt
cp wall.txt kept.csv
rejects 2 "this command reads the file" distances "$grid" --source 0 --walls kept.csv -o kept.csv
cmp kept.csv wall.txt

# A diagram. A wall from border to border divides the square: the site on it has what is left of it, and a half of the
# part on the right. Cells go on along the wall, and meshes are cut along it.
is_silent voronoi "$grid" --site 5,13 --walls across.txt -o cells.csv -o cells.off -o cells.ply -o cells.polylines.txt \
  --along-border
is_near "$(column cells.csv area | line /dev/stdin 1)" "$(awk 'BEGIN { printf "%.17g", 2 / 3 }')"
is_near "$(column cells.csv area | line /dev/stdin 2)" "$(awk 'BEGIN { printf "%.17g", 1 / 3 }')"
equals "$(column cells.csv is_disk)" "$(printf '%s\n' 0 1)"
equals "$(wc -l < cells.polylines.txt)" 3
is_silent voronoi "$grid" --site 5,13 --walls across.txt --vertices -o of_diagram.csv -o cells.off
is_silent voronoi "$grid" --site 5,13 --walls across.txt --vertices -o of_labels.csv
equals "$(column of_diagram.csv distance)" "$(column of_labels.csv distance)"
is_silent voronoi "$grid" --site-curve wall.obj --site 12 --walls wall.txt -o of_curves.csv
remarks "8 of 16 vertices are not reached; the mesh has 1 component, and paths avoid faces or edges" \
  voronoi "$grid" --site 0 --walls across.txt -o one.csv
is_near "$(column one.csv area)" "$(awk 'BEGIN { printf "%.17g", 1 / 3 }')"
