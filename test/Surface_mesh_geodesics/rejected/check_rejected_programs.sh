#!/usr/bin/env bash
# Checks that wrong arguments and wrong maps do not compile, and that the first message of the compiler says why. Each
# case is a call and words of the message. The first case is right, so that no other one fails for a reason of its own.
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
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_isolines.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_path.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>
#include <CGAL/Surface_mesh_geodesics/polyline_curve.h>
#include <CGAL/Surface_mesh_geodesics/shortest_path_curve.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>
#include <boost/property_map/property_map.hpp>
#include <array>
#include <iterator>
#include <map>
#include <string>
#include <utility>
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
using Edge = Mesh::Edge_index;
using Kernel = CGAL::Simple_cartesian<double>;
using Polyhedron = CGAL::Polyhedron_3<Kernel>;
using Mesh_of_the_plane = CGAL::Surface_mesh<Kernel::Point_2>;
struct Empty
{};
// An object that no case has to make: nothing runs.
template <typename T>
T& some();
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

# Something else instead of a mesh, or of the traits of a class.
for call in 'geodesic_distances(std::vector<Point>(), distance, vertices)' 'geodesic_distances(&tm, distance, vertices)' \
  'geodesic_path(std::vector<Point>(), vertices[0], vertices[1], std::back_inserter(text))' \
  'static_cast<void>(sizeof(Geodesic_distance_solver<Traits>))'; do
  expect "the type of the mesh is not a model of FaceListGraph" "$call"
done
for class in Mesh Kernel; do
  expect "is not a model of SurfaceMeshShortestPathTraits" "CGAL::Surface_mesh_geodesic_paths<$class> paths(tm)"
  expect "is not a model of SurfaceMeshShortestPathTraits" "CGAL::Surface_mesh_geodesic_Voronoi_diagram<$class> d(tm)"
done

# Classes without maps of their own, and their arguments.
paths='Paths<CGAL::Default>(tm)'
diagram='Diagram<CGAL::Default>(tm)'
solver_of_mesh='Geodesic_distance_solver<Mesh>(tm)'
face_sites='Map<Face, std::size_t>()'

# Output iterators: a container, or one for other values. (Each list has a right call first.)
expect '' "std::vector<Point> p; geodesic_path(tm, vertices[0], vertices[1], std::back_inserter(p))"
expect '' "std::vector<Vertex> p; geodesic_Lloyd_relaxation(tm, vertices, std::back_inserter(p))"
for call in 'std::vector<Point> p; geodesic_path(tm, vertices[0], vertices[1], p)' \
  'std::vector<Point> p; geodesic_isolines(tm, vertices, numbers, p)' \
  'std::vector<Vertex> p; geodesic_farthest_point_sampling(tm, 5, p)' \
  'std::vector<Vertex> p; geodesic_Lloyd_relaxation(tm, vertices, p)' \
  "std::vector<Vertex> p; $solver_of_mesh.vertices_reached(p)" \
  "std::vector<Point> p; $paths.shortest_path_points_to_source_points(vertices[0], p)" \
  "std::vector<Point> p; $paths.shortest_path_polyline_to_source_points(vertices[0], p)" \
  "std::vector<Point> p; $paths.isolines(1., p)" \
  "std::vector<std::size_t> p; $diagram.nearest_sites(vertices[0], p)" "$diagram.dual(tm)" \
  "std::vector<Point> p; $diagram.edges()[0].polyline(.1, p)" "std::vector<Point> p; $diagram.arcs()[0].sample(.1, p)"
do
  expect "is not an output iterator; to fill a container, pass std::back_inserter" "$call"
done
for call in 'std::vector<Vertex> p; geodesic_path(tm, vertices[0], vertices[1], std::back_inserter(p))' \
  'std::vector<Point> p; geodesic_isolines(tm, vertices, numbers, std::back_inserter(p))' \
  'std::vector<Point> p; geodesic_farthest_point_sampling(tm, 5, std::back_inserter(p))' \
  'std::vector<Point> p; geodesic_Lloyd_relaxation(tm, vertices, std::back_inserter(p))' \
  "std::vector<Point> p; $solver_of_mesh.vertices_reached(std::back_inserter(p))" \
  "std::vector<Vertex> p; $paths.shortest_path_points_to_source_points(vertices[0], std::back_inserter(p))" \
  "std::vector<Point> p; $paths.shortest_path_polyline_to_source_points(vertices[0], std::back_inserter(p))" \
  "std::vector<Point> p; $paths.isolines(1., std::back_inserter(p))" \
  "std::vector<Point> p; $diagram.nearest_sites(vertices[0], std::back_inserter(p))" \
  "std::vector<Point> p; $diagram.dual(std::back_inserter(p))" \
  "std::vector<Vertex> p; $diagram.edges()[0].polyline(.1, std::back_inserter(p))"; do
  expect "does not take what this function writes" "$call"
done

# Maps of other elements.
expect '' "geodesic_distances_from_edge_lengths(tm, Map<Edge, float>(), distance, vertices)"
for call in "geodesic_distances_from_edge_lengths(tm, distance, distance, vertices)" \
  "geodesic_distances_from_edge_lengths(tm, numbers, distance, vertices)" \
  "geodesic_distances_from_edge_lengths(tm, Map<Edge, std::string>(), distance, vertices)" \
  "trace_geodesic_from_edge_lengths(tm, distance, vertices[0], 0., 1.)" \
  "certify_geodesic_distances_from_edge_lengths(tm, distance, distance, vertices)" \
  "certify_geodesic_Voronoi_diagram_from_edge_lengths($diagram, distance)" \
  "Geodesic_distance_solver<Mesh>::from_edge_lengths(tm, distance)" \
  "$paths.use_edge_lengths(distance)" "$paths.use_edge_lengths(numbers)" "$diagram.use_edge_lengths(distance)"; do
  expect "the lengths are not a property map from the edges of the mesh to numbers" "$call"
done
expect "its keys are not the faces of the mesh" "${distances}np::faces_to_avoid(Map<Vertex, bool>()))"
expect "its keys are not the edges of the mesh" "${distances}np::edges_to_avoid(Map<Face, bool>()))"
expect "its keys are not the edges of the mesh" "trace_geodesic(tm, vertices[0], 0., 1., np::edges_to_avoid(Map<Face, bool>()))"
for class in "$paths" "$diagram"; do
  expect "neither a range of faces nor a property map" "$class.avoid_faces(std::vector<Edge>())"
  expect "its keys are not the faces of the mesh" "$class.avoid_faces(Map<Vertex, bool>())"
  expect "neither a range of edges nor a property map" "$class.avoid_edges(3)"
  expect "its keys are not the edges of the mesh" "$class.avoid_edges(Map<Vertex, bool>())"
done
expect '' "$paths.shortest_distances_to_source_points(distance)"
for map in 'Map<Face, double>()' numbers text; do
  expect "distances cannot be written to this argument" "$paths.shortest_distances_to_source_points($map)"
  expect "directions cannot be written to this argument" "$paths.directions_at_source($map)"
done
for map in distance vertices; do
  expect "the points are not a property map from the vertices of the mesh to points" "Geodesic_distance_solver<Mesh>(tm, $map)"
done
expect "to points in space" "geodesic_distances(some<Mesh_of_the_plane>(), distance, vertices)"
expect "distances cannot be read from this argument" "certify_geodesic_distances(tm, text, vertices)"
expect "vertex_point_map is not a property map" "trace_geodesic(tm, vertices[0], 0., 1., np::vertex_point_map(distance))"

# Maps that cannot be written.
const_map='std::map<Vertex, double> m; boost::const_associative_property_map<std::map<Vertex, double>> p(m);'
expect "cannot be written to this argument" "$const_map geodesic_distances(tm, p, vertices)"
expect "cannot be written to this argument" "geodesic_distances(tm, boost::static_property_map<double, Vertex>(1), vertices)"
expect '' "std::map<Vertex, double> m; geodesic_distances(tm, boost::make_assoc_property_map(m), vertices)"

# Sources, targets and locations of another kind.
expect "several sources are a range of these" "geodesic_distances(tm, distance, std::make_pair(Face(0), Kernel::Point_2(0, 0)))"
expect "several sources are a range of these" "geodesic_distances(tm, distance, std::make_pair(Face(0), std::array<double, 2>()))"
expect "a location is a vertex descriptor or a pair" "trace_geodesic(tm, Point(), 0., 1.)"
expect "a location is a vertex descriptor or a pair" "trace_geodesic(tm, some<Surface_curve<Mesh>>(), 0., 1.)"
expect "the vector of a direction has three coordinates" "geodesic_direction(tm, vertices[0], Kernel::Vector_2(1, 0))"
expect "the vector of a direction has three coordinates" "geodesic_direction(tm, vertices[0], 1.)"
for call in 'geodesic_distance_matrix(tm, vertices, std::vector<Point>(), [](std::size_t, const std::vector<double>&) {})' \
  'geodesic_distance_matrix(tm, vertices, vertices[0], [](std::size_t, const std::vector<double>&) {})' \
  'symmetric_geodesic_distance_matrix(tm, std::vector<Point>(), [](std::size_t, const std::vector<double>&) {})' \
  'geodesic_peeling_order(tm, std::vector<Point>())'; do
  expect "are not a range of vertices of the mesh" "$call"
done
expect "the sites are not a range of vertices of the mesh" "std::vector<Vertex> p; geodesic_Lloyd_relaxation(tm, std::vector<Point>(), std::back_inserter(p))"
expect '' "$diagram.add_sites(vertices); $diagram.add_sites(std::vector<Surface_curve<Mesh>>())"
expect "the sites are not a range of vertices" "$diagram.add_sites(std::vector<Point>())"
expect "for a single site, call add_site()" "$diagram.add_sites(vertices[0])"

# Curves: made of other things, or on another mesh.
expect '' "Surface_curve<Mesh> c(tm, vertices); shortest_path_curve(tm, vertices)"
expect "what a curve is made of: a range of vertex descriptors" "Surface_curve<Mesh> c(tm, std::vector<Point>())"
expect "what a curve is made of: a range of vertex descriptors" "Surface_curve<Mesh> c(tm, 3)"
expect "is not a range of halfedges" "Surface_curve<Mesh>::along_halfedges(tm, std::vector<Edge>())"
expect "the points are not a range of vertex descriptors" "shortest_path_curve(tm, std::vector<Point>())"
expect "the points are not a range of vertex descriptors" "shortest_path_curve(tm, vertices[0], vertices[1])"
expect "are a range of the points of the mesh" "polyline_curve(tm, Point())"
expect "from the vertices of the mesh to points" "some<Surface_curve<Mesh>>().length(tm, distance)"
other_curve='some<Surface_curve<Polyhedron>>()'
for call in "geodesic_distances(tm, distance, $other_curve)" "signed_geodesic_distances(tm, distance, $other_curve)" \
  "geodesic_distances(tm, distance, std::vector<Surface_curve<Polyhedron>>())" \
  "$paths.add_source_curve($other_curve)" "$diagram.add_site($other_curve)"; do
  expect "the curve is on a mesh of another type" "$call"
done

# Visitors that are arguments.
for call in "$paths.build_sequence_tree(visitor)" "$diagram.build(visitor)"; do
  expect '' "Geodesic_default_visitor visitor; $call"
  expect "the visitor is not a model of GeodesicPropagationVisitor" "Empty visitor; $call"
done
expect "the visitor is not a model of GeodesicPropagationVisitor" "auto visitor = [](double) {}; $paths.build_sequence_tree(visitor)"
expect "the visitor of a path has no operator() for each of" "Empty visitor; $paths.shortest_path_sequence_to_source_points(vertices[0], visitor)"

# Meshes that receive faces, and diagrams.
expect '' "$diagram.cut(tm, $face_sites); $diagram.cell_mesh(0, tm, Map<Face, Face>()); geodesic_dual_mesh($diagram, tm)"
for output in 'std::as_const(tm)' 'some<std::vector<Point>>()'; do
  for call in "geodesic_remeshing(tm, 5, $output)" "geodesic_dual_mesh($diagram, $output)" \
    "$diagram.cut($output, $face_sites)" "$diagram.cell_mesh(0, $output, Map<Face, Face>())"; do
    expect "the output is not a mesh to which faces can be added" "$call"
  done
done
for call in "geodesic_remeshing(tm, 5, output)" "geodesic_dual_mesh($diagram, output)"; do
  expect "the points of the output are points of the plane" "Mesh_of_the_plane output; $call"
done
expect "the map of faces cannot be written" "$diagram.cut(tm, distance)"
expect "the map of faces does not take the type" "$diagram.cell_mesh(0, tm, Map<Face, Point>())"
for call in "geodesic_dual_mesh(tm, tm)" "check_geodesic_dual(tm)" "geodesic_Voronoi_cell_colors(tm)" \
  "write_geodesic_Voronoi_diagram(\"a.obj\", tm)"; do
  expect "the diagram is not a Surface_mesh_geodesic_Voronoi_diagram" "$call"
done

[ "$failures" = 0 ] || exit 1
echo "The compiler rejects wrong arguments, and says why."
