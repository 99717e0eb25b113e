// Distances, matrices of distances, certificates.

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace geodesics_python {

struct Distance_engine
{
  std::unique_ptr<Sequential_solver> sequential;
  std::unique_ptr<Parallel_solver> parallel;
};

namespace {

// Returns a solver of the surface; makes it if it is not there. Call it inside Surface::run_alone().
template <typename Solver>
Solver& solver_of(Surface& surface, std::unique_ptr<Solver> Distance_engine::*member)
{
  if(surface.distance_engine == nullptr)
    surface.distance_engine = std::make_shared<Distance_engine>();
  std::unique_ptr<Solver>& solver = *surface.distance_engine.*member;
  if(solver == nullptr)
    solver.reset(surface.has_lengths() ? new Solver(Solver::from_edge_lengths(surface.mesh(), surface.lengths()))
                                       : new Solver(Solver::avoiding_faces(surface.mesh(), surface.avoided_faces())));
  return *solver;
}

Sequential_solver& sequential_solver(Surface& surface) { return solver_of(surface, &Distance_engine::sequential); }

// The named parameters that distances and their certificate have in common.
auto parameters_of(const Array<double>& offsets, double radius)
{
  return CGAL::parameters::maximum_distance(radius).source_offsets(
    std::vector<double>(offsets.data(), offsets.data() + offsets.size()));
}

struct Answer
{
  std::vector<double> distance;
  std::vector<std::int64_t> nearest;
};

// Computes the distances of all vertices, or of the targets if there are some.
template <typename Solver, typename NamedParameters>
Answer answer_of(Solver& solver, const Surface& surface, const Places& sources, const std::vector<Vertex>& targets,
                 bool with_nearest, const NamedParameters& np)
{
  Answer answer;
  const bool is_complete
    = sources.visit([&](const auto& range) { return solver.compute_distances(range, np.targets(targets)); });
  if(!is_complete)
    return answer;
  const std::size_t n = targets.empty() ? surface.mesh().number_of_vertices() : targets.size();
  answer.distance.reserve(n);
  answer.nearest.reserve(with_nearest ? n : 0);
  const auto add = [&](Vertex v)
  {
    answer.distance.push_back(solver.distance(v));
    if(with_nearest)
    {
      const std::size_t i = solver.nearest_source(v);
      answer.nearest.push_back(i == Solver::no_source ? -1 : static_cast<std::int64_t>(i));
    }
  };
  if(targets.empty())
    for(const Vertex v : surface.mesh().vertices())
      add(v);
  else
    for(const Vertex v : targets)
      add(v);
  return answer;
}

py::tuple distances(Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                    const Array<double>& weights, const Array<double>& offsets, const Array<std::int64_t>& target,
                    double radius, bool with_nearest, std::size_t threads, const py::object& progress)
{
  const Places sources(surface.mesh(), vertex, face, weights);
  const std::vector<Vertex> targets = to_vertices(target);
  Interruptible visitor(progress);
  const auto np = parameters_of(offsets, radius).visitor(std::ref(visitor));
  Answer answer;
  surface.run_alone(visitor, [&]()
  {
    if(threads <= 1 || !has_threads())
      answer = answer_of(sequential_solver(surface), surface, sources, targets, with_nearest, np);
    else
      with_threads(threads, [&]()
      {
        Parallel_solver& solver = solver_of(surface, &Distance_engine::parallel);
        answer = answer_of(solver, surface, sources, targets, with_nearest, np);
      });
  });
  return py::make_tuple(to_array(std::move(answer.distance)), to_array(std::move(answer.nearest)));
}

// Receives the rows of a matrix, one at a time, and lets Python end those that have begun.
template <typename Put>
struct Row_output
{
  template <typename Row>
  bool operator()(std::size_t i, const Row& row)
  {
    put(i, row);
    visitor.set_part_done(double(++number_done));
    return visitor.ask_and_go_further();
  }

  bool go_further() const { return visitor.ask_sometimes_and_go_further(); }

  Interruptible& visitor;
  Put put;
  std::size_t number_done = 0;
};

template <typename Put>
Row_output<Put> row_output(Interruptible& visitor, const Put& put)
{
  return {visitor, put};
}

// Writes the rows of a matrix into an array.
py::array_t<double> matrix(Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                           const Array<double>& weights, const Array<std::int64_t>& targets, std::size_t threads,
                           const py::object& progress)
{
  const Places sources(surface.mesh(), vertex, face, weights);
  const std::vector<Vertex> range = to_vertices(targets);
  py::array_t<double> result({sources.size(), range.size()});
  double* const numbers = result.mutable_data();
  Interruptible visitor(progress, sources.size());
  surface.run_alone(visitor, [&]()
  {
    const auto output = row_output(visitor, [&](std::size_t i, const std::vector<double>& row)
    { std::copy(row.begin(), row.end(), numbers + i * range.size()); });
    with_threads(threads, [&]()
    {
      sources.visit([&](const auto& s)
      { return geodesics::geodesic_distance_matrix<Threads>(sequential_solver(surface), s, range, output); });
    });
  });
  return result;
}

// Returns the arrays of a matrix of compressed sparse rows: pointers to rows, columns, distances.
py::tuple sparse_matrix(Surface& surface, const Array<std::int64_t>& vertex, const Array<std::int64_t>& face,
                        const Array<double>& weights, const Array<std::int64_t>& targets, double radius,
                        std::size_t threads, const py::object& progress)
{
  const Places sources(surface.mesh(), vertex, face, weights);
  const std::vector<Vertex> range = to_vertices(targets);
  std::vector<std::vector<std::pair<std::size_t, double>>> rows(sources.size());
  Interruptible visitor(progress, sources.size());
  surface.run_alone(visitor, [&]()
  {
    const auto output
      = row_output(visitor, [&](std::size_t i, const auto& row) { rows[i].assign(row.begin(), row.end()); });
    with_threads(threads, [&]()
    {
      sources.visit([&](const auto& s)
      {
        return geodesics::sparse_geodesic_distance_matrix<Threads>(sequential_solver(surface), s, range, radius,
                                                                   output);
      });
    });
  });
  std::vector<std::int64_t> pointers(1, 0), columns;
  std::vector<double> values;
  for(auto& row : rows)
  {
    for(const auto& [column, value] : row)
    {
      columns.push_back(static_cast<std::int64_t>(column));
      values.push_back(value);
    }
    pointers.push_back(static_cast<std::int64_t>(columns.size()));
    row = {};
  }
  return py::make_tuple(to_array(std::move(pointers)), to_array(std::move(columns)), to_array(std::move(values)));
}

constexpr unsigned int number_of_reverse_runs = 4;

// Returns (worst violation, list of (condition, violation, vertex or -1, number of checks)).
py::tuple certify(Surface& surface, const Array<double>& d, const Array<std::int64_t>& vertex,
                  const Array<std::int64_t>& face, const Array<double>& weights, const Array<double>& offsets,
                  double radius, std::size_t threads, const py::object& progress)
{
  using Certificate = geodesics::Geodesic_distance_certificate<Mesh>;
  const Places sources(surface.mesh(), vertex, face, weights);
  const double* const numbers = d.data();
  const auto map = boost::make_function_property_map<Vertex>([numbers](Vertex v) { return numbers[std::size_t(v)]; });
  std::unique_ptr<Certificate> certificate;
  Interruptible visitor(progress, 1 + number_of_reverse_runs);
  const auto np
    = parameters_of(offsets, radius).visitor(std::ref(visitor)).number_of_iterations(number_of_reverse_runs);
  const auto certify_from = [&](const auto& s)
  {
    return std::make_unique<Certificate>(
      surface.has_lengths() ? geodesics::certify_geodesic_distances_from_edge_lengths<Threads>(
                                surface.mesh(), surface.lengths(), map, s, np)
                            : geodesics::certify_geodesic_distances<Threads>(surface.mesh(), map, s, np));
  };
  surface.run_alone(visitor, [&]()
  { with_threads(threads, [&]() { certificate = sources.visit(certify_from); }); });
  py::list conditions;
  for(std::size_t i = 0; i < Certificate::number_of_conditions; ++i)
  {
    const auto c = static_cast<Certificate::Condition>(i);
    const Vertex v = certificate->worst_vertex(c);
    conditions.append(py::make_tuple(Certificate::name(c), certificate->worst_violation(c),
                                     v == Mesh::null_vertex() ? std::int64_t(-1) : std::int64_t(std::size_t(v)),
                                     certificate->number_of_checks(c)));
  }
  return py::make_tuple(certificate->worst_violation(), conditions);
}

} // namespace

void bind_distances(Surface_class& surface)
{
  surface.def("distances", &distances)
    .def("matrix", &matrix)
    .def("sparse_matrix", &sparse_matrix)
    .def("certify", &certify);
}

} // namespace geodesics_python
