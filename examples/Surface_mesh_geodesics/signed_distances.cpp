#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>
#include <CGAL/boost/graph/generators.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using face_descriptor = boost::graph_traits<Mesh>::face_descriptor;
using Curve = CGAL::Surface_mesh_geodesics::Surface_curve<Mesh>;

int main()
{
  Mesh mesh;
  CGAL::make_grid(20, 20, mesh, [](std::size_t i, std::size_t j)
                  { return Point(double(i), double(j), std::sin(double(i) / 3) * std::cos(double(j) / 3)); }, true);

  // A closed curve through the centers of the edges around a vertex: straight through each face there.
  const vertex_descriptor center(10 * 21 + 10);
  std::vector<std::pair<face_descriptor, std::array<double, 3>>> locations;
  for(auto h : halfedges_around_source(center, mesh))
  {
    std::array<double, 3> b{};
    const face_descriptor f = face(h, mesh);
    std::size_t k = 0;
    for(auto g = halfedge(f, mesh); g != h; g = next(g, mesh))
      ++k;
    b[k] = b[(k + 1) % 3] = .5;
    locations.emplace_back(f, b);
  }
  const Curve curve(mesh, locations, true);

  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  CGAL::Surface_mesh_geodesics::signed_geodesic_distances(mesh, distance, curve);
  std::size_t inside = 0;
  for(vertex_descriptor v : vertices(mesh))
    inside += (distance[v] < 0) == (distance[center] < 0);
  std::cout << "the curve is " << curve.length(mesh) << " long and separates " << inside
            << " vertex from the others" << std::endl;
  std::cout << "center " << distance[center] << ", corner " << distance[*vertices(mesh).begin()] << std::endl;

  // Without its last segment the curve separates nothing.
  try
  {
    const Curve open(mesh, locations);
    CGAL::Surface_mesh_geodesics::signed_geodesic_distances(mesh, distance, open);
  }
  catch(const CGAL::Surface_mesh_geodesics::Invalid_geodesic_input& error)
  {
    std::cout << error.what() << std::endl;
    return EXIT_SUCCESS;
  }
  return EXIT_FAILURE;
}
