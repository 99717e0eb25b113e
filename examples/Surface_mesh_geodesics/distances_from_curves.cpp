#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/Surface_curve.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Curve = CGAL::Surface_mesh_geodesics::Surface_curve<Mesh>;
using Solver = CGAL::Surface_mesh_geodesics::Geodesic_distance_solver<Mesh>;

int main()
{
  // A hilly island of 30 x 20 squares.
  Mesh mesh;
  const auto height = [](double x, double y) { return 2 * std::sin(x / 3) * std::cos(y / 4); };
  CGAL::make_grid(30, 20, mesh, [&](std::size_t i, std::size_t j)
                  { return Point(double(i), double(j), height(double(i), double(j))); }, true);

  // The coast.
  std::vector<Curve> curves = CGAL::Surface_mesh_geodesics::border_curves(mesh);
  std::cout << "the coast is " << curves[0].length(mesh) << " long" << std::endl;

  // The place that is farthest from it.
  Solver solver(mesh);
  solver.compute_distances(curves);
  vertex_descriptor center = *vertices(mesh).begin();
  for(vertex_descriptor v : vertices(mesh))
    if(solver.distance(v) > solver.distance(center))
      center = v;
  std::cout << "vertex " << center.idx() << " is " << solver.distance(center) << " from the coast" << std::endl;

  // Where the shortest path to it leaves the coast.
  const auto foot = solver.nearest_curve_point(center);
  std::cout << "its nearest point is on segment " << foot.segment << " of " << curves[0].segments().size()
            << " at the parameter " << foot.parameter << std::endl;

  // A well there, which counts as 2 farther away, and a river along edges.
  curves.emplace_back(mesh, center);
  std::vector<vertex_descriptor> river;
  for(vertex_descriptor v : vertices(mesh))
    if(mesh.point(v).x() == 8)
      river.push_back(v);
  curves.emplace_back(mesh, river);
  solver.compute_distances(curves, CGAL::parameters::source_offsets(std::vector<double>{0, 2, 0}));
  std::vector<std::size_t> number(curves.size(), 0);
  for(vertex_descriptor v : vertices(mesh))
    ++number[solver.nearest_source(v)];
  std::cout << "nearest water: coast " << number[0] << ", well " << number[1] << ", river " << number[2] << std::endl;
  return EXIT_SUCCESS;
}
