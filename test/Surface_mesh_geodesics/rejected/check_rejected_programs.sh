#!/usr/bin/env bash
# Checks that wrong named parameters and wrong maps do not compile, and that the compiler says why. Each case is a call
# and words of the message. The first case is right, so that no other one fails for a reason of its own.
# usage: check_rejected_programs.sh COMPILER WORK_FOLDER [options of the compiler]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
compiler=$1
work=$2
shift 2
options=("$@")
rm -rf "$work"
mkdir -p "$work"

cat > "$work/frame.h" << 'END'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/Surface_mesh_geodesics/polyline_curve.h>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace np = CGAL::parameters;
using namespace CGAL::Surface_mesh_geodesics;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Traits = CGAL::Surface_mesh_shortest_path_traits<CGAL::Simple_cartesian<double>, Mesh>;

// Classes with other maps than the default ones.
template <typename VIM, typename FIM = CGAL::Default, typename VPM = CGAL::Default>
using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits, VIM, CGAL::Default, FIM, VPM>;
template <typename VIM, typename FIM = CGAL::Default, typename VPM = CGAL::Default>
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits, VIM, CGAL::Default, FIM, VPM>;
template <typename Key, typename Value>
using Map = Mesh::Property_map<Key, Value>;
using Point = Mesh::Point;
END
# Compiled once for all cases. The first error is enough.
options=(-std=c++17 -I"$root/include" -Wfatal-errors "${options[@]}")
"$compiler" "${options[@]}" -x c++-header "$work/frame.h" -o "$work/frame.h.gch"

number=0
failures=0
# expect WORDS CALL: `WORDS` is empty for a call that compiles
expect()
{
  number=$((number + 1))
  local source=$work/case_$number.cpp status=0
  cat > "$source" << END
void call(Mesh& tm, Mesh::Property_map<Vertex, double> distance, Mesh::Property_map<Vertex, std::string> text,
          const std::vector<Vertex>& vertices, const std::vector<double>& numbers)
{
  Propagation_statistics counts;
  $2;
  static_cast<void>(tm);
  static_cast<void>(distance);
  static_cast<void>(text);
  static_cast<void>(vertices);
  static_cast<void>(numbers);
  static_cast<void>(counts);
}
END
  "$compiler" "${options[@]}" -fsyntax-only -include "$work/frame.h" "$source" > "$work/messages.txt" 2>&1 || status=$?
  if [ -z "$1" ]; then
    [ "$status" = 0 ] || { echo "does not compile: $2"; head -n 20 "$work/messages.txt"; failures=1; }
  elif [ "$status" = 0 ] || ! grep -qF "$1" "$work/messages.txt"; then
    echo "compiles, or the compiler does not say \"$1\": $2"
    failures=1
  fi
}

solver='Geodesic_distance_solver<Mesh>(tm).compute_distances(vertices, '
distances='geodesic_distances(tm, distance, vertices, '
certificate='certify_geodesic_distances(tm, distance, vertices, '
labels='geodesic_Voronoi_labels(tm, tm.add_property_map<Vertex, std::size_t>("s").first, vertices, '
sampling='geodesic_farthest_point_sampling(tm, 5, std::back_inserter(const_cast<std::vector<Vertex>&>(vertices)), '
relaxation='geodesic_Lloyd_relaxation(tm, vertices, std::back_inserter(const_cast<std::vector<Vertex>&>(vertices)), '
remeshing='geodesic_remeshing(tm, 5, tm, '
store='store_geodesic_distance_matrix(tm, vertices, vertices, "folder", '

expect '' "${distances}np::targets(vertices).source_offsets(numbers).statistics(&counts).vertex_point_map(tm.points()))"

expect "the concurrency tag is Sequential_tag, Parallel_tag or" "geodesic_distances<int>(tm, distance, vertices)"

# The function does not take the parameter: the message names its tag.
for call in "${distances}np::covering_radius(1))" "${solver}np::covering_radius(1))" \
  "${certificate}np::covering_radius(1))" "${labels}np::covering_radius(1))"; do
  expect "does not take the named parameter" "$call"
  grep -qF covering_radius_t "$work/messages.txt" || { echo "the message does not name covering_radius: $call"; failures=1; }
done
expect "does not take the named parameter" "${distances}np::number_of_iterations(3))"
expect "does not take the named parameter" "${distances}np::targets(vertices).threshold_distance(3))"
expect "does not take the named parameter" "${solver}np::nearest_source_map(text))"
expect "does not take the named parameter" "${certificate}np::targets(vertices))"
expect "does not take the named parameter" "${sampling}np::maximum_distance(1.))"
expect "neither a range of faces nor a property map" "${store}np::faces_to_avoid(numbers))"
for call in "$store" "$labels" "$sampling" "$certificate" "$relaxation"; do
  expect '' "${call}np::edges_to_avoid(std::vector<Mesh::Edge_index>()))"
done
# The faces of a new mesh know nothing of edges of the old one.
expect "does not take the named parameter" "${remeshing}np::edges_to_avoid(std::vector<Mesh::Edge_index>()))"

# Borders have faces to avoid, but walls are no borders.
expect '' "border_curves(tm, np::faces_to_avoid(std::vector<Face>()).face_index_map(Map<Face, int>()))"
expect "does not take the named parameter" "border_curves(tm, np::edges_to_avoid(std::vector<Mesh::Edge_index>()))"

for call in "$sampling" "$relaxation"; do
  expect "neither a curve nor a range of curves" "${call}np::first_curves(numbers))"
done

# Numbers are no points of the surface.
expect "a point of the surface is a vertex descriptor" "geodesic_distance(tm, 0, 5)"
expect "a point of the surface is a vertex descriptor" "geodesic_path(tm, vertices[0], 5, std::back_inserter(text))"

# The maps of classes.
standard=CGAL::Default
for class in Diagram Paths; do
  expect '' "static_cast<void>(sizeof($class<$standard>))"
  expect '' "static_cast<void>(sizeof($class<Map<Vertex, int>, Map<Face, unsigned short>, Map<Vertex, Point>>))"
  for map in 'std::vector<std::size_t>' 'std::map<Vertex, int>' 'Map<Vertex, double>' 'Map<Vertex, Point>' \
    'Map<Face, int>' 'Map<Vertex, std::string>'; do
    expect "VIM is not a property map from the vertices of the mesh to indices" "static_cast<void>(sizeof($class<$map>))"
  done
  for map in 'std::vector<std::size_t>' 'Map<Vertex, std::size_t>' 'Map<Face, double>'; do
    expect "FIM is not a property map from the faces of the mesh to indices" "static_cast<void>(sizeof($class<$standard, $map>))"
  done
  for map in 'std::vector<Point>' 'std::map<Vertex, Point>' 'Map<Vertex, double>' 'Map<Face, Point>'; do
    expect "VPM is not a property map from the vertices of the mesh to points" "static_cast<void>(sizeof($class<$standard, $standard, $map>))"
  done
done

# The value has another type.
expect "is not a range of the documented elements" "${distances}np::targets(*vertices.begin()))"
expect "is not a range of the documented elements" "${distances}np::targets(numbers))"
expect "is not a range of the documented elements" "${distances}np::source_offsets(std::vector<std::string>()))"
expect "is not a range of the documented elements" "${labels}np::site_weights(1.))"
expect "is not a range of the documented elements" "${sampling}np::first_samples(numbers))"
expect "does not convert to double" "${sampling}np::covering_radius(std::string()))"
expect "does not convert to double" "${store}np::maximum_distance(1.).maximum_distance(std::string()))"
expect "does not convert to the documented type" "${store}np::rows_per_shard(std::string()))"
expect "does not convert to the documented type" "${store}np::mesh_name(1.))"
expect "is not a property map of vertices" "${distances}np::nearest_source_map(text))"
expect "is not a property map of vertices" "${distances}np::nearest_source_map(numbers))"
expect "is not a property map of vertices" "${labels}np::vertex_distance_map(std::ref(distance)))"
expect "are not integers" "${distances}np::nearest_source_map(distance))"
expect "are not integers of at least 32 bits" "${distances}np::nearest_source_map(Map<Vertex, unsigned char>()))"
expect "does not convert to the documented type" "${store}np::rows_per_shard(2.5))"
expect "does not convert to the documented type" "${store}np::use_symmetry(\"no\"))"
expect '' "${store}np::rows_per_shard(5).use_float32(true).mesh_name(\"a\"))"
expect "are not of type bool" "${distances}np::faces_to_avoid(Map<Face, int>()))"
expect "are not of type bool" "${distances}np::edges_to_avoid(Map<Mesh::Edge_index, int>()))"
expect "is neither a range of edges" "${distances}np::edges_to_avoid(vertices))"
expect "is not a model of GeodesicPropagationVisitor" "${distances}np::visitor(3))"
expect "vertex_index_map is not a property map" "${distances}np::vertex_index_map(distance))"
expect "vertex_index_map is not a property map" "${labels}np::vertex_index_map(numbers))"
expect "face_index_map is not a property map" "${sampling}np::face_index_map(Map<Vertex, int>()))"
expect "face_index_map is not a property map" "${store}np::vertex_index_map(Map<Vertex, int>()).face_index_map(distance))"
expect "vertex_point_map is not a property map" "${certificate}np::vertex_point_map(distance))"
expect "vertex_point_map is not a property map" "${distances}np::vertex_point_map(std::vector<Point>()))"
expect "is not a property map of vertices" "${labels}np::vertex_distance_map(Map<Vertex, int>()))"

# The arguments themselves: the order is wrong, or the type.
expect "cannot be written to this argument" "geodesic_distances(tm, vertices, distance)"
expect "cannot be written to this argument" "geodesic_distances(tm, text, vertices)"
expect "cannot be written to this argument" "geodesic_distances(tm, Map<Vertex, int>(), vertices)"
expect "cannot be written to this argument" "geodesic_Voronoi_labels(tm, vertices, distance)"
expect "cannot be written to this argument" "geodesic_Voronoi_labels(tm, distance, vertices)"
expect "cannot be read from this argument" "certify_geodesic_distances(tm, vertices, distance)"
expect "several sources are a range of these" "geodesic_distances(tm, distance, text)"
expect "several sources are a range of these" "geodesic_distances(tm, distance, numbers)"
expect "the levels are a range of numbers" "geodesic_isolines(tm, vertices, .5, std::back_inserter(text))"
expect "are a range of the points of the mesh" "polyline_curve(tm, vertices)"
expect "a function of the position of its source" "geodesic_distance_matrix(tm, vertices, vertices, [](int) {})"
expect "takes a pointer" "${distances}np::statistics(counts))"
expect "takes a pointer" "${solver}np::statistics(std::ref(counts)))"

[ "$failures" = 0 ] || exit 1
echo "The compiler rejects wrong parameters and maps, and says why."
