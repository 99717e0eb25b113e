#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/trace_geodesic.h>

#include <cmath>
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
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// Writes a line of a file of polylines.
void write(std::ostream& os, const std::vector<Kernel::Point_3>& line)
{
  os << line.size();
  for(const Kernel::Point_3& p : line)
    os << ' ' << p;
  os << '\n';
}

// Writes a polar grid around the source: circles, which are isolines, and rays. A ray is a straightest geodesic, as far
// as it is a shortest path.
void write_polar_grid(std::ostream& os, const Mesh& mesh, const Paths& paths, vertex_descriptor source)
{
  const double radius = paths.farthest_vertex().second;
  std::vector<std::vector<Kernel::Point_3>> circles;
  for(int i = 1; i < 12; ++i)
    paths.isolines(i * radius / 12, std::back_inserter(circles));
  for(const std::vector<Kernel::Point_3>& circle : circles)
    write(os, circle);
  for(int i = 0; i < 24; ++i)
  {
    const auto geodesic = Geodesics::trace_geodesic(mesh, source, i * CGAL_PI / 12, radius);
    std::vector<Kernel::Point_3> ray;
    double length = 0;
    for(std::size_t k = 0; k < geodesic.points.size(); ++k)
    {
      const Kernel::Point_3 p(geodesic.points[k][0], geodesic.points[k][1], geodesic.points[k][2]);
      const auto& at = geodesic.locations[k];
      if(k > 0)
        length += std::sqrt(CGAL::squared_distance(ray.back(), p));
      if(paths.shortest_distance_to_source_points(at.first, at.second).first < length - 1e-9 * radius)
        break; // another path is shorter
      ray.push_back(p);
    }
    write(os, ray);
  }
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

  std::ofstream grid("polar_grid.polylines.txt");
  grid.precision(17);
  write_polar_grid(grid, mesh, paths, source);
  if(!grid.flush())
  {
    std::cerr << "Cannot write polar_grid.polylines.txt" << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
