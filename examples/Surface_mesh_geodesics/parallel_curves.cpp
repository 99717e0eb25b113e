#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using Paths = CGAL::Surface_mesh_geodesic_paths<Traits>;

int main()
{
  // A hilly island of 30 x 20 squares.
  Mesh mesh;
  const auto height = [](double x, double y) { return 2 * std::sin(x / 3) * std::cos(y / 4); };
  CGAL::make_grid(30, 20, mesh, [&](std::size_t i, std::size_t j)
                  { return Point(double(i), double(j), height(double(i), double(j))); }, true);

  // All points of the coast are sources.
  Paths paths(mesh);
  const auto coast = CGAL::Surface_mesh_geodesics::border_curves(mesh)[0];
  paths.add_source_curve(coast);

  // Curves parallel to the coast: the distance is known at each point, so nothing is interpolated.
  for(double distance : {2., 5., 8.})
  {
    std::vector<std::vector<Point>> lines;
    paths.isolines(distance, std::back_inserter(lines));
    double length = 0;
    for(const std::vector<Point>& line : lines)
      for(std::size_t i = 1; i < line.size(); ++i)
        length += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
    std::cout << lines.size() << " line at the distance " << distance << " from the coast, " << length << " long"
              << std::endl;
  }

  // The shortest path from the farthest vertex meets the coast at a right angle.
  const auto farthest = paths.farthest_vertex();
  std::vector<Point> points;
  paths.shortest_path_points_to_source_points(farthest.first, std::back_inserter(points));
  const Kernel::Vector_3 last = points[points.size() - 2] - points.back();
  const auto place = paths.nearest_location_of_sources(farthest.first);
  std::cout << "vertex " << farthest.first.idx() << " is " << farthest.second
            << " from the coast, whose nearest point is (" << points.back() << ")" << std::endl;

  // The coast runs along an edge of the face where the path ends.
  const auto h = halfedge(place.first, mesh);
  for(const auto g : CGAL::halfedges_around_face(h, mesh))
    if(CGAL::is_border_edge(g, mesh))
    {
      const Kernel::Vector_3 edge = mesh.point(target(g, mesh)) - mesh.point(source(g, mesh));
      std::cout << "the cosine of the angle there is less than 1e-12: " << std::boolalpha
                << (std::abs(edge * last) < 1e-12 * std::sqrt(edge.squared_length() * last.squared_length()))
                << std::endl;
    }
  return EXIT_SUCCESS;
}
