#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

namespace Geodesics = CGAL::Surface_mesh_geodesics;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  const vertex_descriptor source = target(halfedge(*faces(mesh).begin(), mesh), mesh);
  Paths paths(mesh);
  paths.add_source_point(source);

  // The logarithmic map: the distance of each vertex, and the angle at which its shortest path leaves the source.
  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  auto direction = mesh.add_property_map<vertex_descriptor, double>("v:direction").first;
  paths.shortest_distances_to_source_points(distance);
  paths.directions_at_source(direction);

  // Some of them as points of the tangent plane at the source.
  const Mesh::size_type step = mesh.number_of_vertices() / 6 + 1;
  for(Mesh::size_type i = 0; i < mesh.number_of_vertices(); i += step)
  {
    const vertex_descriptor v(i);
    if(!(distance[v] >= 0)) // no path reaches it
      continue;

    // The exponential map: the straightest geodesic with this direction and this length. It ends at the vertex unless
    // the shortest path bends on the way.
    const auto geodesic = Geodesics::trace_geodesic(mesh, source, direction[v], distance[v]);
    const auto& end = geodesic.points.back();
    const Kernel::Point_3 p(end[0], end[1], end[2]);
    std::cout << "vertex " << i << ": (" << distance[v] * std::cos(direction[v]) << ", "
              << distance[v] * std::sin(direction[v]) << "), the geodesic ends "
              << (CGAL::squared_distance(p, mesh.point(v)) < 1e-20 ? "there" : "elsewhere") << std::endl;
  }
  return EXIT_SUCCESS;
}
