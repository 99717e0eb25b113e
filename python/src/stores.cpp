// Matrices of distances in folders.

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>

#include <future>
#include <string>

namespace geodesics_python {

// Returns the number of rows of the range that are stored, and the number of rows of the range.
static py::tuple store_matrix(const Surface& surface, const Place_arrays& places, const Array<std::int64_t>& targets,
                       const std::string& folder, bool use_float32, bool use_symmetry, double radius,
                       const std::pair<std::size_t, std::size_t>& rows, const std::string& mesh_name, const Call& call)
{
  const Places sources(surface.mesh(), places);
  const std::vector<Vertex> range = to_vertices(targets);
  geodesics::Geodesic_matrix_store_status status;
  Interruptible visitor(call.second);
  const auto np = CGAL::parameters::use_float32(use_float32).use_symmetry(use_symmetry).maximum_distance(radius)
                    .first_row(rows.first).end_row(rows.second).mesh_name(mesh_name)
                    .faces_to_avoid(surface.avoided_faces()).visitor(std::ref(visitor));
  try
  {
    // This thread only listens to Python: if it computed, it would be deaf when it waits for the last files of others.
    visitor.run([&]()
    {
      auto result = std::async(std::launch::async, [&]()
      {
        with_threads(call.first, [&]()
        {
          status = sources.visit([&](const auto& s)
          { return geodesics::store_geodesic_distance_matrix<Threads>(surface.mesh(), s, range, folder, np); });
        });
      });
      while(result.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
        visitor.ask_and_go_further();
      result.get();
    });
  }
  catch(const geodesics::Geodesic_matrix_store_error& error)
  {
    // A folder that does not fit the call is a ValueError, and a file that cannot be read or written an OSError.
    if(error.reason() != geodesics::Geodesic_matrix_store_error::Reason::FILE_ERROR)
      throw std::invalid_argument(error.what());
    PyErr_SetString(PyExc_OSError, error.what());
    throw py::error_already_set();
  }
  return py::make_tuple(status.rows_done, status.rows);
}

// Returns vertices in the order in which the rows of a symmetric matrix take little time.
static py::array_t<std::int64_t> peeling_order(const Surface& surface, const Array<std::int64_t>& range)
{
  const std::vector<Vertex> vertices = to_vertices(range);
  std::vector<Vertex> order;
  Interruptible visitor{py::none()};
  const auto np = CGAL::parameters::faces_to_avoid(surface.avoided_faces()).visitor(std::ref(visitor))
                    .vertex_point_map(interruptible(visitor, surface.mesh().points()));
  visitor.run([&]() { order = geodesics::geodesic_peeling_order(surface.mesh(), vertices, np); });
  return to_ids(order);
}

void bind_stores(Surface_class& surface)
{
  surface.def("store_matrix", &store_matrix).def("peeling_order", &peeling_order);
}

} // namespace geodesics_python
