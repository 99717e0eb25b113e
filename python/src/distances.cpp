// Distances from points and from curves, matrices of distances, certificates.

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/certify_geodesic_distances.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesics/signed_geodesic_distances.h>

#include <pybind11/stl.h>

#include <boost/property_map/function_property_map.hpp>

#include <type_traits>

namespace geodesics_python {

struct Distance_engine
{
  std::unique_ptr<Sequential_solver> sequential;
  std::unique_ptr<Parallel_solver> parallel;
};

namespace {

// Returns a solver of the surface; makes it if it is not there. Call it inside Surface::run_alone().
template <typename Solver>
Solver& solver_of(Surface& surface, std::unique_ptr<Solver> Distance_engine::*member, Interruptible& visitor)
{
  if(surface.distance_engine == nullptr)
    surface.distance_engine = std::make_shared<Distance_engine>();
  std::unique_ptr<Solver>& solver = *surface.distance_engine.*member;
  const Mesh& mesh = surface.mesh();
  if(solver == nullptr && surface.has_lengths())
    solver.reset(new Solver(Solver::from_edge_lengths(mesh, interruptible(visitor, surface.lengths()))));
  else if(solver == nullptr && !surface.avoided_faces().empty())
    solver.reset(new Solver(Solver::avoiding_faces(mesh, surface.avoided_faces())));
  else if(solver == nullptr)
    solver.reset(new Solver(mesh, interruptible(visitor, mesh.points())));
  return *solver;
}

// The named parameters that distances and their certificate have in common.
auto parameters_of(const Array<double>& offsets, double radius)
{
  return CGAL::parameters::maximum_distance(radius).source_offsets(
    std::vector<double>(offsets.data(), offsets.data() + offsets.size()));
}

// Curves, and points among them. Python gives the places of each curve, and whether it is closed.
struct Curves
{
  using Arrays = std::vector<std::pair<Place_arrays, bool>>;

  Curves(const Mesh& mesh, const Arrays& arrays)
  {
    for(const auto& given : arrays)
      Places(mesh, given.first).visit([&](const auto& range) { curves.emplace_back(mesh, range, given.second); });
  }

  template <typename Use>
  auto visit(Use use) const { return use(curves); }

  // Where a shortest path to a vertex begins; a null face where none leads.
  template <typename Solver>
  Location foot(const Solver& solver, const Mesh& mesh, Vertex v) const
  {
    const auto [i, segment, parameter] = solver.nearest_curve_point(v);
    if(i == Solver::no_source)
      return {Mesh::null_face(), {}};
    return curves[i].segments().empty() ? Paths::face_location(curves[i].vertex(), mesh)
                                        : curves[i].location(segment, parameter);
  }

  std::vector<geodesics::Surface_curve<Mesh>> curves;
};

// Distances, positions of the nearest sources, and feet on curves.
struct Answer
{
  std::vector<double> distances;
  std::vector<std::int64_t> nearest;
  Line feet;
};

// Computes the distances of all vertices, or of the targets if there are some.
template <typename Solver, typename Sources, typename NamedParameters>
Answer answer_of(Solver& solver, const Surface& surface, const Sources& sources, const std::vector<Vertex>& targets,
                 bool with_nearest, const NamedParameters& np)
{
  Answer answer;
  const bool is_complete
    = sources.visit([&](const auto& range) { return solver.compute_distances(range, np.targets(targets)); });
  if(!is_complete)
    return answer;
  std::vector<Vertex> asked(targets);
  if(targets.empty())
    asked.assign(surface.mesh().vertices().begin(), surface.mesh().vertices().end());
  answer.distances.reserve(asked.size());
  answer.nearest.reserve(with_nearest ? asked.size() : 0);
  for(const Vertex v : asked)
  {
    answer.distances.push_back(solver.distance(v));
    if(!with_nearest)
      continue;
    answer.nearest.push_back(static_cast<std::int64_t>(solver.nearest_source(v))); // -1 for no_source
    if constexpr(std::is_same_v<Sources, Curves>)
      answer.feet.add(CGAL::ORIGIN, sources.foot(solver, surface.mesh(), v));
  }
  return answer;
}

template <typename Sources, typename Arrays>
py::tuple distances(Surface& surface, const Arrays& arrays, const Array<double>& offsets,
                    const Array<std::int64_t>& target, double radius, bool with_nearest, const Call& call)
{
  const Sources sources(surface.mesh(), arrays);
  const std::vector<Vertex> targets = to_vertices(target);
  Interruptible visitor(call.second);
  const auto np = parameters_of(offsets, radius).visitor(std::ref(visitor));
  Answer answer;
  surface.run_alone(visitor, call.first, [&]()
  {
    const auto compute
      = [&](auto& solver) { answer = answer_of(solver, surface, sources, targets, with_nearest, np); };
    constexpr bool has_choice = has_threads && std::is_same_v<Sources, Places>; // curves take one thread
    if constexpr(has_choice)
      if(call.first > 1)
        return compute(solver_of(surface, &Distance_engine::parallel, visitor));
    compute(solver_of(surface, &Distance_engine::sequential, visitor));
  });
  return py::make_tuple(to_array(std::move(answer.distances)), to_array(std::move(answer.nearest)))
    + answer.feet.to_tuple();
}

// The distances from curves that separate the surface, negative on one side.
py::array_t<double> signed_distances(Surface& surface, const Curves::Arrays& arrays, double radius, const Call& call)
{
  const Curves given(surface.mesh(), arrays);
  std::vector<double> d(surface.mesh().number_of_vertices());
  Interruptible visitor(call.second);
  const auto np = CGAL::parameters::maximum_distance(radius).visitor(std::ref(visitor))
                    .faces_to_avoid(surface.avoided_faces());
  const auto map = boost::make_iterator_property_map(d.begin(), get(boost::vertex_index, surface.mesh()));
  surface.run_alone(visitor, 1, [&] { geodesics::signed_geodesic_distances(surface.mesh(), map, given.curves, np); });
  return to_array(std::move(d));
}

// The closed curves along the border of the faces that are not avoided: the points, faces and weights of their corners.
py::list border_curves(const Surface& surface)
{
  py::list result;
  const auto np = CGAL::parameters::faces_to_avoid(surface.avoided_faces());
  for(const auto& curve : geodesics::border_curves(surface.mesh(), np))
  {
    Line corners;
    for(const auto& segment : curve.segments())
      corners.add(CGAL::ORIGIN, {segment.face, segment.source});
    result.append(corners.to_tuple());
  }
  return result;
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
Row_output(Interruptible&, const Put&) -> Row_output<Put>;

// Writes the rows of a matrix into an array.
py::array_t<double> matrix(Surface& surface, const Place_arrays& places, const Array<std::int64_t>& targets,
                           const Call& call)
{
  const Places sources(surface.mesh(), places);
  const std::vector<Vertex> range = to_vertices(targets);
  py::array_t<double> result({sources.size(), range.size()});
  double* const numbers = result.mutable_data();
  Interruptible visitor(call.second, sources.size());
  const Row_output output{visitor, [&](std::size_t i, const std::vector<double>& row)
                          { std::copy(row.begin(), row.end(), numbers + i * range.size()); }};
  surface.run_alone(visitor, call.first, [&]()
  {
    const Sequential_solver& solver = solver_of(surface, &Distance_engine::sequential, visitor);
    sources.visit([&](const auto& s)
    { return geodesics::geodesic_distance_matrix<Threads>(solver, s, range, output); });
  });
  return result;
}

// Returns the arrays of a matrix of compressed sparse rows: pointers to rows, columns, distances.
py::tuple sparse_matrix(Surface& surface, const Place_arrays& places, const Array<std::int64_t>& targets,
                        double radius, const Call& call)
{
  const Places sources(surface.mesh(), places);
  const std::vector<Vertex> range = to_vertices(targets);
  std::vector<std::vector<std::pair<std::size_t, double>>> rows(sources.size());
  Interruptible visitor(call.second, sources.size());
  const Row_output output{visitor, [&](std::size_t i, const auto& row) { rows[i].assign(row.begin(), row.end()); }};
  surface.run_alone(visitor, call.first, [&]()
  {
    const Sequential_solver& solver = solver_of(surface, &Distance_engine::sequential, visitor);
    sources.visit([&](const auto& s)
    { return geodesics::sparse_geodesic_distance_matrix<Threads>(solver, s, range, radius, output); });
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
py::tuple certify(Surface& surface, const Array<double>& d, const Place_arrays& places, const Array<double>& offsets,
                  double radius, const Call& call)
{
  using Certificate = geodesics::Geodesic_distance_certificate<Mesh>;
  const Places sources(surface.mesh(), places);
  const double* const numbers = d.data();
  const auto map = boost::make_function_property_map<Vertex>([numbers](Vertex v) { return numbers[std::size_t(v)]; });
  std::unique_ptr<Certificate> certificate;
  Interruptible visitor(call.second, 1 + number_of_reverse_runs);
  const auto np = parameters_of(offsets, radius).faces_to_avoid(surface.avoided_faces()).visitor(std::ref(visitor))
                    .number_of_iterations(number_of_reverse_runs);
  const auto certify_from = [&](const auto& s)
  {
    return std::make_unique<Certificate>(
      surface.has_lengths() ? geodesics::certify_geodesic_distances_from_edge_lengths<Threads>(
                                surface.mesh(), surface.lengths(), map, s, np)
                            : geodesics::certify_geodesic_distances<Threads>(surface.mesh(), map, s, np));
  };
  surface.run_alone(visitor, call.first, [&]() { certificate = sources.visit(certify_from); });
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
  surface.def("distances", &distances<Places, Place_arrays>).def("curve_distances", &distances<Curves, Curves::Arrays>)
    .def("signed_distances", &signed_distances).def("border_curves", &border_curves)
    .def("matrix", &matrix).def("sparse_matrix", &sparse_matrix).def("certify", &certify);
}

} // namespace geodesics_python
