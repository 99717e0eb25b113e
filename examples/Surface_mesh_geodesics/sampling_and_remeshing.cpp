// Arguments: a mesh, and the number of vertices of the coarse mesh.

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <sstream>
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
  std::size_t n = 100;
  if(argc > 2 && !(std::istringstream(argv[2]) >> n))
  {
    std::cerr << argv[2] << " is no number of vertices" << std::endl;
    return EXIT_FAILURE;
  }
  n = std::min<std::size_t>(n, mesh.number_of_vertices());

  // Each sample is the vertex farthest from all samples before it. More samples make the gaps between them smaller.
  std::vector<vertex_descriptor> samples;
  for(std::size_t k = 10; k <= n; k *= 2)
  {
    // Continue with the samples found so far. The parameters hold a copy of them.
    const double radius = Geodesics::geodesic_farthest_point_sampling(mesh, k, std::back_inserter(samples),
                                                                      CGAL::parameters::first_samples(samples));
    std::cout << samples.size() << " samples: no vertex is farther from them than " << radius << std::endl;
  }

  // Samples, moved to the centers of their cells, are the vertices of a coarse mesh.
  Mesh coarse;
  const Geodesics::Geodesic_remeshing_report report =
      Geodesics::geodesic_remeshing(mesh, n, coarse, CGAL::parameters::number_of_iterations(10));
  if(report.number_of_added_samples > 0)
    std::cout << "added " << report.number_of_added_samples << " samples, as the shape needs more" << std::endl;
  std::cout << "from " << mesh.number_of_vertices() << " to " << coarse.number_of_vertices() << " vertices, "
            << coarse.number_of_faces() << " faces" << std::endl;
  if(!CGAL::IO::write_polygon_mesh("remeshed.off", coarse, CGAL::parameters::stream_precision(17)))
  {
    std::cerr << "Cannot write remeshed.off" << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
