#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi_diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;

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

  // Sites inside faces, spread over the mesh.
  const Mesh::size_type n = 30, step = (mesh.number_of_faces() + n - 1) / n;
  Voronoi_diagram voronoi(mesh);
  for(Mesh::size_type f = 0; f < mesh.number_of_faces(); f += step)
  {
    voronoi.add_site(Voronoi_diagram::Face_location(Mesh::Face_index(f), {0.2, 0.3, 0.5}));
  }

  std::cout << voronoi.number_of_sites() << " sites, " << voronoi.vertices().size() << " vertices, "
            << voronoi.edges().size() << " edges of " << voronoi.arcs().size() << " arcs" << std::endl;
  for(std::size_t i = 0; i < voronoi.number_of_sites(); ++i)
  {
    std::cout << "site " << i << ": area " << voronoi.area(i) << ", " << (voronoi.is_disk(i) ? "a disk" : "no disk")
              << ", neighbors";
    for(std::size_t j : voronoi.adjacent_sites(i))
    {
      std::cout << ' ' << j;
    }
    std::cout << std::endl;
  }

  // Write files: colored cells and arcs for MeshLab and ParaView, arcs alone as polylines for Blender.
  const double tolerance = 1e-4 * std::sqrt(voronoi.area(0));
  for(const std::string name : {"voronoi.ply", "voronoi.vtk", "voronoi.obj"})
  {
    if(!Geodesics::write_geodesic_Voronoi_diagram(name, voronoi, tolerance))
    {
      std::cerr << "Cannot write " << name << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << "written: " << name << std::endl;
  }
  return EXIT_SUCCESS;
}
