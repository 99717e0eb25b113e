#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <cstdlib>
#include <iostream>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  const vertex_descriptor source = *vertices(mesh).begin();
  CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance, source);

  for(vertex_descriptor v : vertices(mesh))
    std::cout << v << ": " << distance[v] << "\n"; // inf if no path leads to v
  return EXIT_SUCCESS;
}
