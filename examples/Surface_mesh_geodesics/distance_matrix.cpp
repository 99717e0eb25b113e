#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/Geodesic_distance_solver.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using vertex_descriptor = boost::graph_traits<Mesh>::vertex_descriptor;

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// Rows are computed in parallel if the program is compiled with TBB (in CMake, link CGAL::TBB_support).
using Concurrency_tag = CGAL::Parallel_if_available_tag;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // Twenty vertices. Each is as far as possible from all vertices before it.
  std::vector<vertex_descriptor> samples;
  Geodesics::geodesic_farthest_point_sampling(mesh, 20, std::back_inserter(samples));

  // All distances between the samples: row i has the distances from sample i to the samples i, i+1, ... The solver
  // reads the mesh once and reuses its memory for each row.
  Geodesics::Geodesic_distance_solver<Mesh> solver(mesh);
  double largest = 0, smallest = std::numeric_limits<double>::infinity();
  Geodesics::symmetric_geodesic_distance_matrix<Concurrency_tag>(
    solver, samples, [&](std::size_t, const std::vector<double>& row)
    {
      for(std::size_t k = 1; k < row.size(); ++k)
      {
        largest = (std::max)(largest, row[k]);
        smallest = (std::min)(smallest, row[k]);
      }
    });
  std::cout << "distances of " << samples.size() << " samples: from " << smallest << " to " << largest << std::endl;

  // The number of vertices near each sample: a sparse matrix of all distances up to a radius.
  Geodesics::sparse_geodesic_distance_matrix<Concurrency_tag>(
    solver, samples, vertices(mesh), smallest / 2,
    [&](std::size_t i, const std::vector<std::pair<std::size_t, double>>& row)
    { std::cout << "sample " << i << ": " << row.size() << " vertices" << std::endl; });
  return EXIT_SUCCESS;
}
