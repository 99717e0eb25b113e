// Argument: a mesh. The part below z = 0 is removed, so that the mesh has a border.

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi_diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;

namespace Geodesics = CGAL::Surface_mesh_geodesics;

void remove_lower_part(Mesh& mesh)
{
  std::vector<Mesh::Face_index> lower;
  for(const Mesh::Face_index f : mesh.faces())
  {
    if(mesh.point(target(halfedge(f, mesh), mesh)).z() < 0)
    {
      lower.push_back(f);
    }
  }
  for(const Mesh::Face_index f : lower)
  {
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
  }
  mesh.collect_garbage();
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
  remove_lower_part(mesh);

  std::vector<vertex_descriptor> sites;
  Geodesics::geodesic_farthest_point_sampling(mesh, 5, std::back_inserter(sites));
  Voronoi_diagram voronoi(mesh);
  voronoi.add_sites(sites);

  // The whole boundary of each cell, closed along the border of the mesh, as lines of a file that viewers read.
  std::ofstream file("cells.polylines.txt");
  file.precision(17);
  const double tolerance = 1e-3;
  for(std::size_t i = 0; i < voronoi.number_of_sites(); ++i)
  {
    for(const Voronoi_diagram::Boundary_polyline& loop : voronoi.boundary_polylines(i, tolerance, true))
    {
      file << loop.locations.size();
      for(const Voronoi_diagram::Face_location& location : loop.locations)
      {
        file << ' ' << voronoi.point(location);
      }
      file << '\n';
      const auto number_of_others = std::count(loop.vertices.begin() + 1, loop.vertices.end(), voronoi.null_site());
      std::cout << "cell " << i << ": a loop of " << loop.locations.size() - 1 << " segments through "
                << static_cast<std::ptrdiff_t>(loop.vertices.size()) - 1 - number_of_others
                << " vertices of the diagram" << std::endl;
    }
  }
  return file.good() ? EXIT_SUCCESS : EXIT_FAILURE;
}
