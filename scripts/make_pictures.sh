#!/usr/bin/env bash
# Makes all pictures of the README and of the manual. For the renderings it builds the examples that write the data, and
# runs them on the mesh of the examples and on a scan of CGAL's data. Other scripts make the drawings of the theory,
# the plots of the committed results, and the pictures of the program's page and of curves.
# Writes everything but the pictures below build/. Look at each picture before you commit it.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
work=$build/pictures
figures=$root/doc/Surface_mesh_geodesics/fig
examples=$build/examples/Surface_mesh_geodesics

bash "$root/scripts/install_needs.sh" g++ cmake make libcgal-dev libcgal-demo libboost-program-options-dev \
  libjs-three python3-vtk9 python3-matplotlib xvfb chromium
# The main job also unpacks the scan.
bash "$root/scripts/run_main_job.sh" > /dev/null
scan=$build/cgal_data/data/meshes/bunny00.off
programs=(distances_as_colored_mesh paths_from_several_sources Voronoi_diagram_of_scan weighted_Voronoi_diagram
  sampling_and_remeshing logarithmic_map)
cmake --build "$build" --parallel "${JOBS:-$(nproc)}" --target "${programs[@]}"

mkdir -p "$work"
cd "$work"
ln -sfn "$root/examples/Surface_mesh_geodesics/data" data
"$examples/distances_as_colored_mesh" "$scan"
"$examples/paths_from_several_sources"
"$examples/Voronoi_diagram_of_scan" "$scan"
"$examples/weighted_Voronoi_diagram"
"$examples/sampling_and_remeshing" "$scan" 1500

# render PICTURE FILE [options]
render()
{
  local picture=$1
  shift
  /usr/bin/python3 "$root/scripts/render_picture.py" "$1" "$figures/$picture" --size 800x760 "${@:2}"
}
render bunny_bands.png distances.ply --view=-0.25,0.15,-1
render bunny_bands_small.png distances.ply --view=-0.25,0.15,-1 --size 109x104
render sphere_paths.png data/bumpy_sphere.off --lines paths.polylines.txt --view=-0.1,-0.9,0 --up 0,0,1
render bunny_Voronoi.png voronoi.vtk
render weighted_Voronoi.png weighted_voronoi.vtk
render bunny_remeshed.png remeshed.off --edges
/usr/bin/python3 "$root/scripts/draw_theory_figures.py"
/usr/bin/python3 "$root/scripts/draw_plots.py"

cmake "$build" -DSurface_mesh_geodesics_PROGRAM=ON > /dev/null
cmake --build "$build" --parallel "${JOBS:-$(nproc)}" --target surface_mesh_geodesics_program
program=$build/demo/Surface_mesh_geodesics/surface_mesh_geodesics
bash "$root/scripts/picture_pages.sh" "$program" "$scan" "$work" "$figures"
bash "$root/scripts/curve_pictures.sh" "$program" "$scan" "$work" "$figures"
"$examples/logarithmic_map"
"$program" distances data/bumpy_sphere.off --quiet --source 0 -o sphere.ply
render sphere_polar_grid.png sphere.ply --isolines polar_grid.polylines.txt --view=0.1,-0.55,-0.9
echo "The pictures are in $figures"
