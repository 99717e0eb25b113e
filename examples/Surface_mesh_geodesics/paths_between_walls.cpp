#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using edge_descriptor = boost::graph_traits<Mesh>::edge_descriptor;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

// Three walls without thickness, along edges of a floor of 12 x 8 squares.
bool is_on_wall(const Point& p)
{
  return (p.x() == 4 && p.y() < 6) || (p.x() == 8 && p.y() > 2) || (p.y() == 4 && p.x() > 8 && p.x() < 11);
}

int main()
{
  Mesh mesh;
  CGAL::make_grid(12, 8, mesh, [](std::size_t i, std::size_t j) { return Point(double(i), double(j), 0.); }, true);
  std::vector<edge_descriptor> walls;
  for(edge_descriptor e : edges(mesh))
    if(is_on_wall(CGAL::midpoint(mesh.point(source(e, mesh)), mesh.point(target(e, mesh)))))
      walls.push_back(e);

  const auto vertex_at = [](std::size_t x, std::size_t y)
  { return vertex_descriptor(Mesh::size_type(y * 13 + x)); }; // make_grid() makes rows of 13 vertices
  const vertex_descriptor start = vertex_at(1, 1);
  Paths paths(mesh);
  paths.avoid_edges(walls);
  paths.add_source_point(start);
  for(vertex_descriptor v : {vertex_at(3, 1), vertex_at(5, 1), vertex_at(11, 1), vertex_at(10, 6)})
    std::cout << "to (" << mesh.point(v).x() << ", " << mesh.point(v).y()
              << "): " << paths.shortest_distance_to_source_points(v).first << ", as the crow flies "
              << std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(start))) << std::endl;
  return EXIT_SUCCESS;
}
