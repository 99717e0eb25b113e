#ifndef SURFACE_MESH_GEODESICS_DEMO_MPI_JOB_H
#define SURFACE_MESH_GEODESICS_DEMO_MPI_JOB_H

#include "Console.h"
#include "Polygon_soup.h"
#include "Program_mesh.h"

#include <functional>
#include <string>

#ifdef CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI
#include <boost/mpi/communicator.hpp>
#endif

namespace geodesics_demo {

// This process among those that mpirun has started. Without MPI, there is no such object.
class Mpi_job
{
public:
  int rank() const;
  int size() const;

  void wait_for_all() const;

  // Rank 0 calls read(), and all ranks return the mesh of these polygons: one process reads the file. The mesh has the
  // same bits as that of read_mesh().
  Mesh mesh(const std::string& file_name, const std::function<Polygon_soup()>& read, const Console& console) const;

#ifdef CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI
  const boost::mpi::communicator& world() const { return m_world; }

private:
  boost::mpi::communicator m_world;
#endif
};

// Joins the processes that mpirun has started, and calls work(job). If it throws, prints the message and ends all
// processes, as the others may wait for this one. Throws a Command_error if the program was built without MPI.
void run_mpi_job(const std::function<void(const Mpi_job&)>& work);

} // namespace geodesics_demo

#endif // SURFACE_MESH_GEODESICS_DEMO_MPI_JOB_H
