// A program written for CGAL::Heat_method_3 needs only these changes:
//
//   -#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
//   +#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>
//
//   -CGAL::Heat_method_3::estimate_geodesic_distances(mesh, distance, source);
//   +CGAL::Surface_mesh_geodesics::geodesic_distances(mesh, distance, source);
//
// This example calls both functions and compares the estimates with the distances.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distances.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;
using Distance_map = Mesh::Property_map<vertex_descriptor, double>;

namespace Heat_method = CGAL::Heat_method_3;
namespace Geodesics = CGAL::Surface_mesh_geodesics;

// Prints the mean and the largest relative error of estimates.
void print_errors(const std::string& name, const Mesh& mesh, const Distance_map& estimate, const Distance_map& exact)
{
  double sum = 0, largest = 0;
  std::size_t number = 0;
  for(vertex_descriptor v : vertices(mesh))
  {
    if(exact[v] > 0 && std::isfinite(exact[v])) // skips the source and vertices that no path reaches
    {
      const double error = std::abs(estimate[v] - exact[v]) / exact[v];
      sum += error;
      largest = (std::max)(largest, error);
      ++number;
    }
  }
  std::cout << name << ": mean error " << 100 * sum / static_cast<double>(number) << " %, largest error "
            << 100 * largest << " %" << std::endl;
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
  Distance_map exact = mesh.add_property_map<vertex_descriptor, double>("v:exact").first;
  Distance_map direct = mesh.add_property_map<vertex_descriptor, double>("v:direct").first;
  Distance_map intrinsic = mesh.add_property_map<vertex_descriptor, double>("v:intrinsic").first;
  const vertex_descriptor source = *vertices(mesh).begin();

  Geodesics::geodesic_distances(mesh, exact, source);
  Heat_method::estimate_geodesic_distances(mesh, direct, source, Heat_method::Direct());
  Heat_method::estimate_geodesic_distances(mesh, intrinsic, source); // on the intrinsic Delaunay triangulation

  print_errors("heat method, faces of the mesh", mesh, direct, exact);
  print_errors("heat method, intrinsic Delaunay", mesh, intrinsic, exact);
  return EXIT_SUCCESS;
}
