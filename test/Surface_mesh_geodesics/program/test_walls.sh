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

# What has no walls.
rejects 2 "--walls cannot be combined with curves" distances "$grid" --source-border --walls wall.txt
