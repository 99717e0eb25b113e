// Matrices of distances in folders.

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix_store.h>

#include <functional>
#include <stdexcept>
#include <string>

namespace geodesics_python {

namespace {

// Tells Python of rows, each of which takes long. (A model of GeodesicPropagationVisitor.)
class Row_visitor
{
public:
  explicit Row_visitor(Interruptible& interruptible) : m_interruptible(interruptible) {}

  void on_propagation_begin(std::size_t number_of_rows) { m_number_of_rows = number_of_rows; }

  void on_progress(std::size_t number_of_rows, double)
  {
    m_interruptible.set_part_done(double(number_of_rows) / double(m_number_of_rows));
  }

  bool go_further() { return m_interruptible.ask_and_go_further(); }
  void on_propagation_end() {}

private:
  Interruptible& m_interruptible;
  std::size_t m_number_of_rows = 1;
};

// A folder that does not fit the call is a ValueError, and a file that cannot be read or written an OSError.
[[noreturn]] void throw_to_python(const geodesics::Geodesic_matrix_store_error& error)
{
  using Reason = geodesics::Geodesic_matrix_store_error::Reason;
  if(error.reason() != Reason::FILE_ERROR)
    throw std::invalid_argument(error.what());
  PyErr_SetString(PyExc_OSError, error.what());
  throw py::error_already_set();
}

// Returns the number of rows of the range that are stored, and the number of rows of the range.
py::tuple store_matrix(const Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                       const Array<double>& weights, const Array<std::int64_t>& targets, const std::string& folder,
                       bool use_float32, bool use_symmetry, double radius, std::size_t first_row, std::size_t end_row,
                       const std::string& mesh_name, std::size_t threads, const py::object& progress)
{
  const Places sources(surface.mesh(), vertex, face, weights);
  const std::vector<Vertex> range = to_vertices(targets);
  geodesics::Geodesic_matrix_store_status status;
  Interruptible interruptible(progress);
  Row_visitor visitor(interruptible);
  const auto np = CGAL::parameters::use_float32(use_float32)
                    .use_symmetry(use_symmetry)
                    .maximum_distance(radius)
                    .first_row(first_row)
                    .end_row(end_row)
                    .mesh_name(mesh_name)
                    .visitor(std::ref(visitor));
  try
  {
    interruptible.run([&]()
    {
      with_threads(threads, [&]()
      {
        status = sources.visit([&](const auto& s)
        { return geodesics::store_geodesic_distance_matrix<Threads>(surface.mesh(), s, range, folder, np); });
      });
    });
  }
  catch(const geodesics::Geodesic_matrix_store_error& error)
  {
    throw_to_python(error);
  }
  return py::make_tuple(status.rows_done, status.rows);
}

// Returns vertices in the order in which the rows of a symmetric matrix take little time.
py::array_t<std::int64_t> peeling_order(const Surface& surface, const Array<std::int64_t>& range)
{
  std::vector<Vertex> order;
  {
    const py::gil_scoped_release release;
    order = geodesics::geodesic_peeling_order(surface.mesh(), to_vertices(range));
  }
  return to_ids(order);
}

} // namespace

void bind_stores(Surface_class& surface)
{
  surface.def("store_matrix", &store_matrix);
  surface.def("peeling_order", &peeling_order);
}

} // namespace geodesics_python
