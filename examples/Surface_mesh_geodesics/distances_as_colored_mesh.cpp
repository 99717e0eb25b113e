// Writes distances to files: a table, and a mesh with colored bands for MeshLab, ParaView or Blender.
// Arguments: a mesh, and the index of the source vertex.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/IO/Color.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

// From dark violet to light yellow, in alternating light and dark bands. The borders of the bands are isolines.
CGAL::IO::Color color_of_distance(double distance, double largest)
{
  if(!std::isfinite(distance))
    return CGAL::IO::gray(); // no path reaches this vertex
  const double t = (largest > 0) ? distance / largest : 0.;
  const bool is_light = static_cast<int>(30 * t) % 2 == 0;
  return CGAL::IO::Color().set_hsv(262 - 210 * t, 70, (is_light ? 1. : 0.68) * (55 + 44 * t * t));
}

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }
  Mesh::size_type source = 0;
  if((argc > 2 && !(std::istringstream(argv[2]) >> source)) || source >= mesh.number_of_vertices())
  {
    std::cerr << "There is no vertex " << argv[2] << " in " << filename << std::endl;
    return EXIT_FAILURE;
  }

  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  CGAL::Real_timer timer;
  timer.start();
  CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance, vertex_descriptor(source));
  timer.stop();

  double largest = 0;
  for(vertex_descriptor v : vertices(mesh))
    if(std::isfinite(distance[v]))
      largest = (std::max)(largest, distance[v]);
  std::cout << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces() << " faces, "
            << 1000 * timer.time() << " ms, largest distance " << largest << std::endl;

  std::ofstream csv("distances.csv"), ply("distances.ply", std::ios::binary);
  csv.precision(17);
  csv << "vertex,distance\n";
  auto color = mesh.add_property_map<vertex_descriptor, CGAL::IO::Color>("v:color").first;
  for(vertex_descriptor v : vertices(mesh))
  {
    csv << v.idx() << ',' << distance[v] << '\n';
    color[v] = color_of_distance(distance[v], largest);
  }
  CGAL::IO::set_binary_mode(ply);
  if(!csv.flush() || !CGAL::IO::write_PLY(ply, mesh) || !ply.flush()) // with all properties, including the distances
  {
    std::cerr << "Cannot write distances.csv or distances.ply" << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "written: distances.csv, distances.ply" << std::endl;
  return EXIT_SUCCESS;
}
