#!/usr/bin/env bash
# surface_mesh_geodesics matrix
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
grid=$data/grid4.off # the unit square, 16 vertices, 18 faces; vertex 4 i + j is (i, j) / 3

is_silent matrix "$grid" --source 0,15,3 > square.csv
equals "$(line square.csv 1)" source,0,15,3
equals "$(column square.csv source | paste -sd ' ')" "0 15 3"
equals "$(wc -l < square.csv)" 4
is_near "$(line square.csv 2 | cut -d, -f2)" 0
is_near "$(line square.csv 2 | cut -d, -f3)" 1.4142135623730951
is_near "$(line square.csv 3 | cut -d, -f4)" 1
is_near "$(line square.csv 4 | cut -d, -f2)" 1

# A row equals the output of the subcommand distances.
is_silent matrix "$grid" --source 5 --source-point 0.5,0.5,0 --target all -o rows.csv
is_silent distances "$grid" --source 5 > from_5.csv
is_silent distances "$grid" --source-point 0.5,0.5,0 > from_point.csv
equals "$(line rows.csv 1)" source,0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15
equals "$(line rows.csv 2)" "5,$(column from_5.csv distance | paste -sd ,)"
equals "$(line rows.csv 3 | cut -d, -f2-)" "$(column from_point.csv distance | paste -sd ,)"

# Pairs within a radius: the entries of the whole matrix up to the radius.
is_silent matrix "$grid" --source all > all.csv
is_silent matrix "$grid" --source all --radius 0.5 > pairs.csv
equals "$(line pairs.csv 1)" source,target,distance,source_vertex
awk -F, 'NR > 1 { for(i = 2; i <= NF; ++i) if($i <= 0.5) print NR - 2 "," i - 2 "," $i "," $1 }' all.csv > near.csv
cmp near.csv <(tail -n +2 pairs.csv)

remarks "18 of 36 pairs have no path; the mesh has 2 components" matrix "$data/two_components.off" --source all
contains remarks.out inf
# no pair at all: the table is written, but the question has no answer
status=0
"$program" matrix "$data/two_components.off" --source 0 --target 3,4 > none.csv 2> none.err || status=$?
equals "$status" 1
equals "$(cat none.csv)" $'source,3,4\n0,inf,inf'
contains none.err "error: no source reaches any target; the mesh has 2 components"

rejects 2 "no source is given" matrix "$grid"
rejects 2 "use --target" matrix "$grid" --source-point 0,0,0
# targets are vertices: there is no option for points
rejects 2 "unrecognised option '--target-point" matrix "$grid" --source 0 --target-point 0,0,0
"$program" matrix --help > help
equals "$(grep -c -e --target-point help)" 0
contains help "a file with one vertex index per line"
printf '3\n 15 # a corner\n' > vertices.txt
is_silent matrix "$grid" --source 0 --target-file vertices.txt > from_file.csv
equals "$(line from_file.csv 1)" source,3,15
printf '3\n1 0 0\n' > point.txt
rejects 3 "point.txt, line 2: only a vertex index is allowed here" \
  matrix "$grid" --source 0 --target-file point.txt
rejects 2 "'-2' is not a positive number" matrix "$grid" --source 0 --radius -2
no_remains
