// A program written for CGAL::Surface_mesh_shortest_path. These lines have changed:
//
//   -#include <CGAL/Surface_mesh_shortest_path.h>
//   +#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
//
//   -using Shortest_paths = CGAL::Surface_mesh_shortest_path<Traits>;
//   +using Shortest_paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>

#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Shortest_paths = CGAL::Surface_mesh_geodesic_paths<Traits>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using halfedge_descriptor = boost::graph_traits<Mesh>::halfedge_descriptor;
using face_descriptor = boost::graph_traits<Mesh>::face_descriptor;

// Counts the elements of a path.
struct Sequence_counter
{
  std::size_t edges = 0, vertices = 0, points_in_faces = 0;

  void operator()(halfedge_descriptor, Kernel::FT) { ++edges; }
  void operator()(vertex_descriptor) { ++vertices; }
  void operator()(face_descriptor, const Traits::Barycentric_coordinates&) { ++points_in_faces; }
};

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Two source points: inside a face, and at the vertex of another face.
  const Traits::Barycentric_coordinates center = {1. / 3, 1. / 3, 1. / 3};
  const face_descriptor first = *faces(mesh).begin(), last = *std::prev(faces(mesh).end());
  Shortest_paths shortest_paths(mesh);
  shortest_paths.add_source_point(first, center);
  const auto second_source = shortest_paths.add_source_point(target(halfedge(last, mesh), mesh));

  // The distance of a point in a face, and its nearest source.
  const face_descriptor middle(static_cast<Mesh::size_type>(mesh.number_of_faces() / 2));
  auto [distance, source] = shortest_paths.shortest_distance_to_source_points(middle, center);
  if(source == shortest_paths.source_points_end())
  {
    std::cerr << "No path leads to a source" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "distance " << distance << " to the source at " << shortest_paths.point(source->first, source->second)
            << std::endl;

  // The same after the removal of a source, with the path as a sequence and as points.
  shortest_paths.remove_source_point(second_source);
  Sequence_counter sequence;
  distance = shortest_paths.shortest_path_sequence_to_source_points(middle, center, sequence).first;
  std::cout << "distance to the first source: " << distance << ", across " << sequence.edges << " edges, through "
            << sequence.vertices << " vertices" << std::endl;

  std::vector<Kernel::Point_3> points;
  shortest_paths.shortest_path_points_to_source_points(middle, center, std::back_inserter(points));
  if(!points.empty())
    std::cout << points.size() << " points from " << points.front() << " to " << points.back() << std::endl;

  return EXIT_SUCCESS;
}
