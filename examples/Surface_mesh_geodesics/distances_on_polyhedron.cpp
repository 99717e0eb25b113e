#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <unordered_map>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Polyhedron_3<Kernel>; // its vertices and faces have no indices
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

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

  // Any writable property map can store the distances, for example one on top of a standard container.
  std::unordered_map<vertex_descriptor, double> distances;
  const vertex_descriptor source = *vertices(mesh).first;
  Geodesics::geodesic_distances(mesh, boost::make_assoc_property_map(distances), source);

  vertex_descriptor farthest = source;
  for(vertex_descriptor v : vertices(mesh))
    if(distances[v] > distances[farthest] && std::isfinite(distances[v])) // infinite if no path reaches v
      farthest = v;
  std::cout << "the point farthest from " << source->point() << " is " << farthest->point() << ", at the distance "
            << distances[farthest] << std::endl;
  return EXIT_SUCCESS;
}
