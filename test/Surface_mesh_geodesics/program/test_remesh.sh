#!/usr/bin/env bash
# surface_mesh_geodesics remesh
source "$(dirname "${BASH_SOURCE[0]}")/support.sh" "$@"
sphere=$data/../../../examples/Surface_mesh_geodesics/data/bumpy_sphere.off

"$program" remesh "$sphere" --number 60 -o coarse.off -o coarse.obj -o coarse.ply 2> note
contains note "to 60 vertices, 116 faces"
for format in off obj ply; do
  is_silent info coarse.$format > info.csv
  contains info.csv vertices,60
  contains info.csv faces,116
  contains info.csv euler_characteristic,2
  contains info.csv borders,0
done
# all vertices are vertices of the sphere
awk 'FNR == 1 { ++file; next } NF == 3 && !/[a-zA-Z]/ { key = ($1 + 0) " " ($2 + 0) " " ($3 + 0) }
  NF != 3 { next } file == 1 { known[key] = 1 } file == 2 && FNR > 2 { ++n; if(!(key in known)) exit 1 }
  END { if(n != 60) exit 1 }' "$sphere" coarse.off
is_silent remesh "$sphere" --number 60 --quiet > out.off
cmp out.off coarse.off
is_silent remesh "$sphere" --number 60 --iterations 0 --quiet > other.off
differ other.off coarse.off

rejects 2 "number" remesh "$sphere"
rejects 2 "--number: '2' is not a whole number of 3 or more" remesh "$sphere" --number 2
rejects 2 "--iterations: '-1' is not a whole number from 0 to 1000000" remesh none.off --number 60 --iterations -1
cp "$sphere" sphere.off
rejects 2 "./sphere.off: this command reads the file" remesh sphere.off --number 60 -o ./sphere.off
cmp sphere.off "$sphere"
rejects 2 "the name must end with one of .off, .obj, .ply" remesh "$sphere" --number 60 -o x.vtk
# too few cells for a closed surface: the program adds some, and says how many
"$program" remesh "$sphere" --number 3 -o few.off 2> note
contains note "added"
contains note "the two surfaces are at most"
is_silent info few.off > info.csv
contains info.csv euler_characteristic,2
contains info.csv borders,0
# more vertices than there are: the surface stays as it is
"$program" remesh "$sphere" --number 99999 -o same.off 2> note
contains note "1 of 1 components have no more vertices than --number gives them; they stay as they are"
contains note "from 2562 to 2562 vertices, 5120 faces"
contains note "the two surfaces are the same, up to rounding, at vertices and centers of faces"
no_remains
