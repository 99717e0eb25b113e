#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using face_descriptor = boost::graph_traits<Mesh>::face_descriptor;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

// A floor of 30 x 20 squares: two walls with doors divide it into three rooms, and the rooms have pillars.
bool is_blocked(int x, int y)
{
  const bool is_first_wall = x == 9 && y != 3 && y != 4, is_second_wall = x == 19 && y != 15;
  const bool is_pillar = (x == 4 && y >= 8 && y <= 11) || (x >= 13 && x <= 15 && y >= 9 && y <= 10)
                      || (x == 24 && (y == 6 || y == 12));
  return is_first_wall || is_second_wall || is_pillar;
}

int main()
{
  Mesh mesh;
  CGAL::make_grid(30, 20, mesh, [](std::size_t i, std::size_t j) { return Point(double(i), double(j), 0.); }, true);

  // The faces to avoid: both triangles of each square that is blocked.
  std::vector<face_descriptor> obstacles;
  for(face_descriptor f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    const Point center = CGAL::centroid(mesh.point(source(h, mesh)), mesh.point(target(h, mesh)),
                                        mesh.point(target(next(h, mesh), mesh)));
    if(is_blocked(int(std::floor(center.x())), int(std::floor(center.y()))))
      obstacles.push_back(f);
  }

  // Distances of all vertices from the lower left corner.
  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  const vertex_descriptor start = *vertices(mesh).begin();
  CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance, start,
                                                   CGAL::parameters::faces_to_avoid(obstacles));
  std::size_t inside = 0;
  for(vertex_descriptor v : vertices(mesh))
    inside += std::isinf(distance[v]);
  std::cout << obstacles.size() << " faces to avoid, " << inside << " vertices inside of them" << std::endl;

  // Paths to the other side.
  Paths paths(mesh);
  paths.avoid_faces(obstacles);
  paths.add_source_point(start);
  std::ofstream os("paths_around_obstacles.polylines.txt");
  os.precision(17);
  for(vertex_descriptor v : vertices(mesh))
  {
    const Point p = mesh.point(v);
    if(p.x() != 30 || std::fmod(p.y(), 5.) != 0)
      continue;
    std::vector<Point> polyline;
    paths.shortest_path_points_to_source_points(v, std::back_inserter(polyline));
    std::cout << "to (" << p.x() << ", " << p.y() << "): " << distance[v] << ", as the crow flies "
              << std::sqrt(CGAL::squared_distance(p, mesh.point(start))) << std::endl;
    os << polyline.size();
    for(const Point& q : polyline)
      os << ' ' << q;
    os << '\n';
  }
  if(!os.flush())
  {
    std::cerr << "Cannot write paths_around_obstacles.polylines.txt" << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
