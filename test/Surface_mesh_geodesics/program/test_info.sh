#!/usr/bin/env bash
# surface_mesh_geodesics info
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"

is_silent info "$data/grid4.off" > grid.csv
equals "$(line grid.csv 1)" property,value
for entry in vertices,16 edges,33 faces,18 isolated_vertices,0 components,1 borders,1 euler_characteristic,1 \
  faces_without_area,0 x_min,0 x_max,1 z_max,0; do
  equals "$(grep -c "^$entry\$" grid.csv)" 1
done
is_near "$(awk -F, '$1 == "area" { print $2 }' grid.csv)" 1
is_near "$(awk -F, '$1 == "shortest_edge" { print $2 }' grid.csv)" 0.33333333333333331
is_near "$(awk -F, '$1 == "longest_edge" { print $2 }' grid.csv)" 0.47140452079103168
is_silent info "$data/grid4.off" -o file.csv > out
[ ! -s out ]
cmp grid.csv file.csv

is_silent info "$data/tetra.off" > tetra.csv
contains tetra.csv euler_characteristic,2
contains tetra.csv borders,0
is_silent info "$data/two_components.off" > parts.csv
contains parts.csv components,2
is_silent info "$data/isolated_vertex.off" > isolated.csv
contains isolated.csv isolated_vertices,1

rejects 2 "the name must end with one of .csv" info "$data/grid4.off" -o x.ply
no_remains
