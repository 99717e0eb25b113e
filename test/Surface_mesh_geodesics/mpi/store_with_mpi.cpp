// Run by test_mpi.sh with mpirun: stores the distances between all vertices of a sphere, with all ranks.
//
// Usage: store_with_mpi FOLDER [options]
//   --float32, --symmetric, --radius R   what is stored
//   --avoid                              some faces and edges are avoided
//   --kill RANK ROWS                     that rank kills itself after so many rows. The others are slow, so that work
//                                        is left when mpirun ends them
//   --throw                              the visitor of rank 0 throws when it is told of rows of other ranks
//   --threads                            several threads in each rank
//   --alone                              without MPI, for the comparison
//   --other-mesh                         of another mesh; each rank has to reject the folder
//
// Rank 0 prints how many rows were computed and found.

#include "test_meshes.h"
#include "test_support.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_mpi.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>
#include <CGAL/tags.h>

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/environment.hpp>

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <thread>
#include <vector>

using namespace test_meshes;
namespace SMG = CGAL::Surface_mesh_geodesics;

namespace {

struct Visitor_error
{};

struct Killing_visitor
  : SMG::Geodesic_default_visitor
{
  void on_rows(std::size_t c, std::size_t f, std::size_t)
  {
    if(throws && std::this_thread::get_id() == main_thread) // which talks to the other ranks
    {
      throw Visitor_error();
    }
    computed = c;
    found = f;
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds_per_row));
    if(computed >= limit)
    {
      std::raise(SIGKILL);
    }
  }

  const std::thread::id main_thread = std::this_thread::get_id();
  bool throws = false;
  int milliseconds_per_row = 0;
  std::size_t computed = 0, found = 0, limit = (std::numeric_limits<std::size_t>::max)();
};

template <typename Tag, typename Parameters>
int run(const boost::mpi::communicator& world, const Mesh& tm, const std::string& folder,
        const Parameters& parameters, Killing_visitor& visitor)
{
  try
  {
    const SMG::Geodesic_matrix_store_status status = SMG::store_geodesic_distance_matrix_mpi<Tag>(
      world, tm, vertices(tm), vertices(tm), folder, parameters.visitor(std::ref(visitor)));
    if(world.rank() == 0)
    {
      std::cout << "computed " << visitor.computed << " found " << visitor.found << std::endl;
    }
    return status.is_complete() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch(const SMG::Geodesic_matrix_store_error& error)
  {
    std::cout << "rank " << world.rank() << ": " << error.what() << std::endl;
    return EXIT_SUCCESS;
  }
  catch(const Visitor_error&)
  {
    std::cout << "rank " << world.rank() << ": the visitor has thrown" << std::endl;
    boost::mpi::environment::abort(EXIT_FAILURE);
    return EXIT_FAILURE;
  }
}

} // namespace

int main(int argc, char* argv[])
{
  boost::mpi::environment environment(argc, argv, boost::mpi::threading::funneled);
  const boost::mpi::communicator world;
  Killing_visitor visitor;
  bool is_alone = false, has_threads = false, use_float32 = false, use_symmetry = false;
  double radius = std::numeric_limits<double>::infinity();
  Mesh tm = to_face_graph(icosphere(3));
  std::vector<face_descriptor> avoided;
  std::vector<Mesh::Edge_index> walls;
  for(int k = 2; k < argc; ++k)
  {
    const std::string option = argv[k];
    if(option == "--float32")
      use_float32 = true;
    else if(option == "--symmetric")
      use_symmetry = true;
    else if(option == "--radius")
      radius = std::atof(argv[++k]);
    else if(option == "--avoid")
    {
      for(const face_descriptor f : faces(tm))
        if(f % 7 == 0)
          avoided.push_back(f);
      for(const Mesh::Edge_index e : edges(tm))
        if(e % 11 == 0)
          walls.push_back(e);
    }
    else if(option == "--throw")
      visitor.throws = world.rank() == 0;
    else if(option == "--threads")
      has_threads = true;
    else if(option == "--alone")
      is_alone = true;
    else if(option == "--other-mesh")
      tm = to_face_graph(icosphere(1));
    else if(option == "--kill" && k + 2 < argc)
    {
      const int rank = std::atoi(argv[++k]);
      const int rows = std::atoi(argv[++k]);
      if(rank == world.rank())
        visitor.limit = static_cast<std::size_t>(rows);
      else
        visitor.milliseconds_per_row = 50;
    }
  }
  const auto parameters
    = CGAL::parameters::use_float32(use_float32).use_symmetry(use_symmetry).maximum_distance(radius)
        .faces_to_avoid(avoided).edges_to_avoid(walls);
  if(is_alone)
  {
    return SMG::store_geodesic_distance_matrix(tm, vertices(tm), vertices(tm), argv[1], parameters).is_complete()
             ? EXIT_SUCCESS
             : EXIT_FAILURE;
  }
  return has_threads ? run<CGAL::Parallel_if_available_tag>(world, tm, argv[1], parameters, visitor)
                     : run<CGAL::Sequential_tag>(world, tm, argv[1], parameters, visitor);
}
