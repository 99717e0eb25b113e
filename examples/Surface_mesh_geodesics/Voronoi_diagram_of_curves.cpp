#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>
#include <CGAL/Surface_mesh_geodesics/write_geodesic_Voronoi_diagram.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Curve = CGAL::Surface_mesh_geodesics::Surface_curve<Mesh>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Diagram = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits>;

int main()
{
  // An island: which points are nearest to its coast, to a river, and to a well?
  Mesh mesh;
  CGAL::make_grid(20, 20, mesh, [](std::size_t i, std::size_t j)
                  { return Point(double(i), double(j), std::sin(double(i) / 3) * std::cos(double(j) / 3)); }, true);
  const auto vertex = [](std::size_t i, std::size_t j)
  { return vertex_descriptor(static_cast<vertex_descriptor::size_type>(j * 21 + i)); };
  std::vector<vertex_descriptor> river;
  for(std::size_t i = 4; i <= 12; ++i)
    river.push_back(vertex(i, 16 - i));

  std::vector<Curve> sites = CGAL::Surface_mesh_geodesics::border_curves(mesh);
  sites.emplace_back(mesh, river);
  sites.emplace_back(mesh, vertex(14, 13)); // a curve of one location is a point
  const std::vector<std::string> names{"coast", "river", "well"};

  Diagram diagram(mesh, sites);
  const std::size_t segments = static_cast<std::size_t>(
    std::count_if(diagram.arcs().begin(), diagram.arcs().end(), [](const Diagram::Arc& a) { return a.is_segment(); }));
  std::cout << diagram.vertices().size() << " vertices, " << diagram.edges().size() << " edges, "
            << (segments > 0 && segments < diagram.arcs().size() ? "segments and curved arcs" : "arcs of one kind")
            << std::endl;
  for(std::size_t i = 0; i < sites.size(); ++i)
    std::cout << names[i] << ": area " << diagram.area(i) << std::endl;
  CGAL::Surface_mesh_geodesics::write_geodesic_Voronoi_diagram("voronoi_of_curves.ply", diagram);
  std::cout << "written: voronoi_of_curves.ply" << std::endl;

  // The nearest site of each vertex alone needs no diagram.
  auto label = mesh.add_property_map<vertex_descriptor, std::size_t>("v:site").first;
  CGAL::Surface_mesh_geodesics::geodesic_Voronoi_labels(mesh, label, sites);
  std::cout << "vertices:";
  for(std::size_t i = 0; i < sites.size(); ++i)
    std::cout << " " << names[i] << " " << std::count(label.begin(), label.end(), i);
  std::cout << std::endl;
  return EXIT_SUCCESS;
}
