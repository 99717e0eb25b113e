#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Voronoi_diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;

namespace PMP = CGAL::Polygon_mesh_processing;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Fire stations at four vertices. The first one is fast: its weight is subtracted from its distances. The second one
  // is slow: its weight is negative. The last one is next to the first one, and so slow that its cell is empty.
  const Mesh::size_type n = mesh.number_of_faces();
  const auto corner = [&](Mesh::size_type f) { return target(halfedge(Mesh::Face_index(f), mesh), mesh); };
  const double size = std::sqrt(PMP::area(mesh));
  Voronoi_diagram voronoi(mesh);
  voronoi.add_site(corner(0), 0.1 * size);
  voronoi.add_site(corner(n / 2), -0.1 * size);
  voronoi.add_site(corner(n / 4));
  voronoi.add_site(source(halfedge(Mesh::Face_index(0), mesh), mesh), -size);

  std::size_t number_of_hyperbolas = 0;
  for(const Voronoi_diagram::Arc& arc : voronoi.arcs())
  {
    number_of_hyperbolas += arc.is_segment() ? 0 : 1;
  }
  std::cout << voronoi.arcs().size() << " arcs, " << number_of_hyperbolas << " of them pieces of hyperbolas"
            << std::endl;
  for(std::size_t i = 0; i < voronoi.number_of_sites(); ++i)
  {
    std::cout << "site " << i << ", weight " << voronoi.weight(i)
              << (voronoi.is_empty(i) ? ": empty" : ": area " + std::to_string(voronoi.area(i))) << std::endl;
  }

  // Each face of the cut mesh belongs to one site.
  Mesh cut;
  auto site = cut.add_property_map<Mesh::Face_index, std::size_t>("f:site").first;
  voronoi.cut(cut, site, 1e-3 * size);
  std::cout << "the cut mesh has " << cut.number_of_faces() << " faces instead of " << mesh.number_of_faces() << ", "
            << std::count(site.begin(), site.end(), std::size_t(0)) << " of them in the cell of site 0" << std::endl;
  if(!CGAL::Surface_mesh_geodesics::write_geodesic_Voronoi_diagram("weighted_voronoi.vtk", voronoi, 1e-3 * size))
  {
    std::cerr << "Cannot write weighted_voronoi.vtk" << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
