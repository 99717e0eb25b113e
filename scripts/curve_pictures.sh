#!/usr/bin/env bash
# Makes pictures of what the program surface_mesh_geodesics computes from curves on a scan: distances with isolines,
# signed distances with isolines on both sides, and a Voronoi diagram. Needs VTK for Python (render_picture.py).
# usage: curve_pictures.sh PROGRAM SCAN WORK_FOLDER OUTPUT_FOLDER
set -euo pipefail
if [ $# -ne 4 ]; then
  sed -n '/^# usage/s/^# //p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1")
scan=$(realpath "$2")
mkdir -p "$3" "$4"
output=$(cd "$4" && pwd)
cd "$3"
rm -f ./*.points.polylines.txt ./*.paths.polylines.txt

# curve NAME POINT...: appends a curve through points to NAME.points.polylines.txt, which the program joins by shortest
# paths, and these paths to NAME.paths.polylines.txt, for the picture
curve()
{
  local name=$1 points
  shift
  points="$*"
  echo "$# ${points//,/ }" >> "$name.points.polylines.txt"
  while [ $# -gt 1 ]; do
    "$program" path "$scan" --quiet --snap --source-point="$2" --target-point="$1" -o link.polylines.txt
    cat link.polylines.txt >> "$name.paths.polylines.txt"
    shift
  done
}

# picture PICTURE FILE NAME [options]: the file, with the curves NAME
picture()
{
  /usr/bin/python3 "$scripts/render_picture.py" "$2" "$output/$1" --curves "$3.paths.polylines.txt" --size 800x760 \
    --view=-0.25,0.15,-1 "${@:4}"
}

flank=(0.28,-0.12,-0.4 0.12,-0.02,-0.4 -0.05,-0.12,-0.4 -0.2,0.02,-0.4)

curve flank "${flank[@]}"
"$program" distances "$scan" --quiet --snap --source-curve flank.points.polylines.txt -o flank.ply --lines flank.vtk \
  --spacing 0.06
picture bunny_curve.png flank.ply flank --isolines flank.vtk

curve waist 0.25,0.1,-0.1 0,-0.02,-0.4 -0.35,-0.1,-0.2 -0.4,-0.1,0.1 -0.1,-0.02,0.4 0.25,0.1,0.15 0.25,0.1,-0.1
"$program" distances "$scan" --quiet --snap --source-curve waist.points.polylines.txt --signed -o waist.ply \
  --lines waist.vtk --spacing 0.06
picture bunny_signed.png waist.ply waist --isolines waist.vtk

curve sites "${flank[@]}"
curve sites 0.2,0.45,-0.1 0.0,0.3,-0.1
curve sites 0.2,0.12,-0.2 -0.05,0.1,-0.3
curve sites 0.35,-0.35,-0.3 0.15,-0.4,-0.3
curve sites -0.05,-0.4,-0.3 -0.2,-0.45,-0.3
curve sites -0.35,0.2,-0.25 -0.4,0,-0.25 -0.3,-0.15,-0.35
curve sites -0.15,0.45,-0.3 -0.15,0.3,-0.3
"$program" voronoi "$scan" --quiet --snap --site-curve sites.points.polylines.txt -o sites.vtk
picture bunny_Voronoi_of_curves.png sites.vtk sites
