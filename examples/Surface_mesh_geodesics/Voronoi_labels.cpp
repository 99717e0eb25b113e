// Argument: a mesh.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_labels.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

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

  std::vector<vertex_descriptor> sites;
  Geodesics::geodesic_farthest_point_sampling(mesh, 6, std::back_inserter(sites));

  // Clusters: each vertex gets the number of its nearest site.
  auto label = mesh.add_property_map<vertex_descriptor, std::size_t>("v:site").first;
  Geodesics::geodesic_Voronoi_labels(mesh, label, sites);
  std::cout << "vertices nearest to each site:";
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    std::cout << " " << std::count(label.begin(), label.end(), i);
  }
  std::cout << std::endl;

  // The same with weights: the first site is nearer by 0.5 than it looks. The distances are wanted, too.
  std::vector<double> weights(sites.size(), 0.);
  weights[0] = 0.5;
  auto distance = mesh.add_property_map<vertex_descriptor, double>("v:distance").first;
  Geodesics::geodesic_Voronoi_labels(mesh, label, sites,
                                     CGAL::parameters::site_weights(weights).vertex_distance_map(distance));
  std::cout << "with a weight:";
  for(std::size_t i = 0; i < sites.size(); ++i)
  {
    std::cout << " " << std::count(label.begin(), label.end(), i);
  }
  std::cout << "; the farthest vertex has the distance " << *std::max_element(distance.begin(), distance.end())
            << std::endl;
  return EXIT_SUCCESS;
}
