#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

namespace Geodesics = CGAL::Surface_mesh_geodesics;

// Shards are computed in parallel if the program is compiled with TBB (in CMake, link CGAL::TBB_support).
using Concurrency_tag = CGAL::Parallel_if_available_tag;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/bumpy_sphere.off";
  const std::string folder = (argc > 2) ? argv[2] : "stored_distances";
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(filename, mesh) || faces(mesh).empty() || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << "Cannot read a triangle mesh from " << filename << std::endl;
    return EXIT_FAILURE;
  }

  // All distances within a radius, in 32 bits. This call computes a part of the rows only, as a task of an array job
  // does.
  const auto np = CGAL::parameters::use_float32(true).maximum_distance(.1);
  try
  {
    Geodesics::Geodesic_matrix_store_status status = Geodesics::store_geodesic_distance_matrix<Concurrency_tag>(
      mesh, vertices(mesh), vertices(mesh), folder, np.end_row(1000));
    std::cout << "stored " << status.rows_done << " of " << status.rows << " rows of the range" << std::endl;

    // A later call, of this program or of another one, computes what is missing. If it is interrupted, the next one
    // goes on.
    status
      = Geodesics::store_geodesic_distance_matrix<Concurrency_tag>(mesh, vertices(mesh), vertices(mesh), folder, np);
    std::cout << "stored " << status.rows_done << " of " << status.rows << " rows in " << status.shards << " shards"
              << std::endl;

    // The folder is read without the mesh. Python opens the same files with numpy.load().
    const Geodesics::Geodesic_distance_matrix_store matrix(folder);
    std::size_t entries = 0;
    for(std::size_t i = 0; i < matrix.number_of_rows(); i += 100)
      entries += matrix.sparse_row(i).size();
    std::cout << "entries of every hundredth row: " << entries << std::endl;

    const Geodesics::Geodesic_matrix_store_check check = Geodesics::check_geodesic_distance_matrix(mesh, folder);
    std::cout << check.rows_compared << " rows computed anew, " << check.rows_different << " are different, "
              << matrix.damaged_shards().size() << " shards are damaged" << std::endl;
  }
  catch(const std::exception& error) // another mesh, other parameters, or a disk that is full
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
