#include "Mpi_job.h"

#include "Command_error.h"

#ifdef CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/environment.hpp>
#include <boost/serialization/vector.hpp>

#include <cstddef>
#include <exception>
#include <iostream>
#include <vector>

namespace geodesics_demo {

int Mpi_job::rank() const
{
  return m_world.rank();
}

int Mpi_job::size() const
{
  return m_world.size();
}

void Mpi_job::wait_for_all() const
{
  m_world.barrier();
}

Mesh Mpi_job::mesh(const std::string& file_name, const std::function<Polygon_soup()>& read,
                   const Console& console) const
{
  Polygon_soup soup;
  std::vector<double> coordinates;
  if(rank() == 0)
  {
    soup = read();
    for(const Point& p : soup.points)
      coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  }
  boost::mpi::broadcast(m_world, coordinates, 0);
  boost::mpi::broadcast(m_world, soup.corners, 0);
  boost::mpi::broadcast(m_world, soup.ends, 0);
  boost::mpi::broadcast(m_world, soup.lines, 0);
  boost::mpi::broadcast(m_world, soup.is_marked, 0);
  if(rank() != 0)
    for(std::size_t i = 0; i < coordinates.size(); i += 3)
      soup.points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  return mesh_of_polygons(file_name, soup, console);
}

void run_mpi_job(const std::function<void(const Mpi_job&)>& work)
{
  const boost::mpi::environment environment(boost::mpi::threading::funneled);
  const Mpi_job job;
  try
  {
    work(job);
  }
  catch(const std::exception& error)
  {
    if(job.world().size() == 1)
      throw;
    const auto* const command_error = dynamic_cast<const Command_error*>(&error);
    std::cerr << "surface_mesh_geodesics: error: " << error.what() << std::endl;
    boost::mpi::environment::abort(
      static_cast<int>(command_error != nullptr ? command_error->code() : Exit_code::NO_RESULT));
  }
}

} // namespace geodesics_demo

#else

namespace geodesics_demo {

int Mpi_job::rank() const
{
  return 0;
}

int Mpi_job::size() const
{
  return 1;
}

void Mpi_job::wait_for_all() const
{}

Mesh Mpi_job::mesh(const std::string& file_name, const std::function<Polygon_soup()>& read,
                   const Console& console) const
{
  return mesh_of_polygons(file_name, read(), console);
}

void run_mpi_job(const std::function<void(const Mpi_job&)>&)
{
  throw Command_error(Exit_code::BAD_USAGE, "this program was built without MPI: --mpi is not available");
}

} // namespace geodesics_demo

#endif // CGAL_SURFACE_MESH_GEODESICS_LINKED_WITH_MPI
