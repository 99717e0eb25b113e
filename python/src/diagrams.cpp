// Geodesic Voronoi diagrams, built by one thread or by several, and what the package makes with them: samples (in one
// thread), relaxation, remeshing. (One file, as diagrams take long to compile.)

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>

#include <pybind11/stl.h>

#include <iterator>
#include <limits>

namespace geodesics_python {

namespace {

// A diagram that is built, and the surface that it refers to.
template <typename Tag>
class Diagram
{
  using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits, CGAL::Default, CGAL::Default, CGAL::Default,
                                                              CGAL::Default, Tag>;

public:
  Diagram(std::shared_ptr<Surface> surface, const Places& sites, const Array<double>& weights, const Call& call)
    : m_surface(std::move(surface)), m_voronoi(m_surface->mesh())
  {
    m_voronoi.avoid_faces(m_surface->avoided_faces());
    if(m_surface->has_lengths())
      m_voronoi.use_edge_lengths(m_surface->lengths());
    sites.visit([&](const auto& range)
    {
      for(std::size_t i = 0; i < range.size(); ++i)
        m_voronoi.add_site(range[i], weights.size() == 0 ? 0. : weights.data()[i]);
    });
    Interruptible visitor(call.second);
    visitor.run([&]() { with_threads(call.first, [&]() { m_voronoi.build(visitor); }); });
  }

  std::size_t number_of_sites() const { return m_voronoi.number_of_sites(); }

  // The nearest site of each vertex, -1 if none reaches it, and the distances.
  py::tuple at_vertices() const
  {
    std::vector<std::int64_t> labels;
    std::vector<double> distances;
    without_lock([&]()
    {
      for(const Vertex v : m_surface->mesh().vertices())
      {
        labels.push_back(number(m_voronoi.nearest_site(v)));
        const double d = m_voronoi.distance_to_nearest_site(v);
        distances.push_back(labels.back() < 0 ? std::numeric_limits<double>::infinity() : d);
      }
    });
    return py::make_tuple(to_array(std::move(labels)), to_array(std::move(distances)));
  }

  py::array_t<double> areas() const { return at_sites<double>([&](std::size_t i) { return m_voronoi.area(i); }); }
  py::array_t<bool> are_disks() const { return at_sites<bool>([&](std::size_t i) { return m_voronoi.is_disk(i); }); }

  py::array_t<double> centroids() const
  {
    return rows_of_sites<double>(3, [this](std::size_t i, std::vector<double>& row)
    {
      const Point p = m_voronoi.centroid(i);
      row.insert(row.end(), {p.x(), p.y(), p.z()});
    });
  }

  // The pairs of cells with a common edge, the smaller number first.
  py::array_t<std::int64_t> adjacency() const
  {
    return rows_of_sites<std::int64_t>(2, [this](std::size_t i, std::vector<std::int64_t>& rows)
    {
      for(const std::size_t j : m_voronoi.adjacent_sites(i))
        if(i < j)
          rows.insert(rows.end(), {std::int64_t(i), std::int64_t(j)});
    });
  }

  // Red, green and blue of each cell, from 0 to 255.
  py::array_t<std::int64_t> colors() const
  {
    std::vector<std::int64_t> result;
    without_lock([&]()
    {
      for(const CGAL::IO::Color& c : geodesics::geodesic_Voronoi_cell_colors(m_voronoi))
        result.insert(result.end(), {c.red(), c.green(), c.blue()});
    });
    return to_rows(std::move(result), 3);
  }

  // The curves around a cell: for each its points, their faces, their coordinates there, the vertices of the diagram
  // that they are, or -1, and whether it is closed.
  py::list boundary_polylines(std::size_t i, double tolerance, bool closes_at_border) const
  {
    std::vector<typename Voronoi::Boundary_polyline> lines;
    without_lock([&]() { lines = m_voronoi.boundary_polylines(i, tolerance, closes_at_border); });
    py::list result;
    for(const auto& line : lines)
    {
      Line arrays;
      std::vector<std::int64_t> vertices;
      for(const auto& location : line.locations)
        arrays.add(m_voronoi.point(location), location);
      for(const std::size_t v : line.vertices)
        vertices.push_back(number(v));
      result.append(arrays.to_tuple() + py::make_tuple(to_array(std::move(vertices)), line.is_closed));
    }
    return result;
  }

  double energy() const
  {
    double result = 0;
    without_lock([&]() { result = m_voronoi.energy(); });
    return result;
  }

  // The findings about the dual, in the order of DualReport.
  py::tuple check_dual() const
  {
    geodesics::Geodesic_dual_report r;
    without_lock([&]() { r = geodesics::check_geodesic_dual(m_voronoi); });
    return py::make_tuple(r.is_manifold(), r.is_triangulation(), r.is_polygon_mesh, r.cells_that_are_not_disks,
                          r.cells_with_several_boundaries, r.cells_without_triangle, r.pairs_with_several_edges,
                          r.pairs_without_triangle, r.triples_with_several_vertices, r.vertices_of_many_cells);
  }

  // The triples of sites around the vertices of the diagram.
  py::array_t<std::int64_t> dual() const
  {
    std::vector<std::array<std::size_t, 3>> triples;
    without_lock([&]() { m_voronoi.dual(std::back_inserter(triples)); });
    std::vector<std::int64_t> numbers;
    for(const auto& triple : triples)
      for(const std::size_t i : triple)
        numbers.push_back(number(i));
    return to_rows(std::move(numbers), 3);
  }

  // The mesh cut along the diagram: points, faces, the cell of each face.
  py::tuple cut(double tolerance) const
  {
    return mesh_with_numbers<std::size_t>(
      [&](Mesh& mesh, const auto& map) { m_voronoi.cut(mesh, map, tolerance); }, number);
  }

  // One cell: points, faces, the face of the surface that each face lies in.
  py::tuple cell_mesh(std::size_t i, double tolerance) const
  {
    return mesh_with_numbers<Face>([&](Mesh& mesh, const auto& map) { m_voronoi.cell_mesh(i, mesh, map, tolerance); },
                                   [](Face f) { return std::int64_t(std::size_t(f)); });
  }

private:
  // A number for each site.
  template <typename T, typename Compute>
  py::array_t<T> at_sites(const Compute& compute) const
  {
    py::array_t<T> result(static_cast<py::ssize_t>(number_of_sites()));
    T* const numbers = result.mutable_data();
    without_lock([&]()
    {
      for(std::size_t i = 0; i < number_of_sites(); ++i)
        numbers[i] = compute(i);
    });
    return result;
  }

  // Rows of numbers: add(i, numbers) adds those of site i.
  template <typename T, typename Add>
  py::array_t<T> rows_of_sites(std::size_t columns, const Add& add) const
  {
    std::vector<T> numbers;
    without_lock([&]()
    {
      for(std::size_t i = 0; i < number_of_sites(); ++i)
        add(i, numbers);
    });
    return to_rows(std::move(numbers), columns);
  }

  // Returns a mesh that make(mesh, map) fills, with the number of what the map has for each face.
  template <typename T, typename Make, typename Number>
  static py::tuple mesh_with_numbers(const Make& make, const Number& number_of)
  {
    Mesh mesh;
    Interruptible visitor{py::none()};
    const auto values = mesh.add_property_map<Face, T>("f:value").first;
    visitor.run([&]() { make(mesh, interruptible(visitor, values)); });
    std::vector<std::int64_t> numbers;
    for(const Face f : mesh.faces())
      numbers.push_back(number_of(values[f]));
    return mesh_to_tuple(mesh) + py::make_tuple(to_array(std::move(numbers)));
  }

  static std::int64_t number(std::size_t site) { return site == Voronoi::null_site() ? -1 : std::int64_t(site); }

  std::shared_ptr<Surface> m_surface;
  Voronoi m_voronoi;
};

template <typename Tag>
void bind_diagram(py::module_& module, const char* name)
{
  using Class = Diagram<Tag>;
  py::class_<Class>(module, name)
    .def("at_vertices", &Class::at_vertices)
    .def("areas", &Class::areas)
    .def("centroids", &Class::centroids)
    .def("adjacency", &Class::adjacency)
    .def("colors", &Class::colors)
    .def("boundary_polylines", &Class::boundary_polylines)
    .def("are_disks", &Class::are_disks)
    .def("energy", &Class::energy)
    .def("dual", &Class::dual)
    .def("check_dual", &Class::check_dual)
    .def("cut", &Class::cut)
    .def("cell_mesh", &Class::cell_mesh);
}

py::object diagram(const std::shared_ptr<Surface>& surface, const Place_arrays& places,
                   const Array<double>& site_weights, const Call& call)
{
  const Places sites(surface->mesh(), places);
  if(call.first > 1)
    return py::cast(std::make_unique<Diagram<Threads>>(surface, sites, site_weights, call));
  return py::cast(std::make_unique<Diagram<CGAL::Sequential_tag>>(surface, sites, site_weights, call));
}

// Calls a Python function after each iteration of a relaxation. (A model of GeodesicRelaxationVisitor.)
class Relaxation_visitor : public Interruptible
{
public:
  // `on_iteration` may be None.
  Relaxation_visitor(py::object progress, std::size_t number_of_runs, py::object on_iteration)
    : Interruptible(std::move(progress), number_of_runs), m_on_iteration(std::move(on_iteration))
  {}

  void on_iteration(std::size_t iteration, double largest_move, double energy)
  {
    if(go_further() && !m_on_iteration.is_none())
      call_python([&]() { m_on_iteration(iteration, largest_move, energy); });
  }

private:
  py::object m_on_iteration;
};

// How many iterations, the threshold, and a function that is called after each one, or None.
using Relaxation = std::tuple<unsigned int, double, py::object>;

// Calls compute(tag, named parameters) in one thread with Sequential_tag, or in several with Threads.
template <typename Compute>
void relax_alone(Surface& surface, std::size_t number_of_runs, const Relaxation& relaxation, const Call& call,
                 const Compute& compute)
{
  const auto& [iterations, threshold, on_iteration] = relaxation;
  Relaxation_visitor visitor(call.second, number_of_runs + iterations, on_iteration);
  const auto np
    = CGAL::parameters::visitor(std::ref(visitor)).number_of_iterations(iterations).threshold_distance(threshold);
  surface.run_alone(visitor, call.first, [&]()
  {
    if(call.first > 1)
      compute(Threads(), np);
    else
      compute(CGAL::Sequential_tag(), np);
  });
}

// Returns the samples, without the first ones, and the covering radius.
py::tuple sample(Surface& surface, std::size_t n, const Array<std::int64_t>& first, double radius,
                 const py::object& progress)
{
  std::vector<Vertex> samples;
  double covered = 0;
  Interruptible visitor(progress, n + 1);
  const auto np
    = CGAL::parameters::first_samples(to_vertices(first)).covering_radius(radius).visitor(std::ref(visitor));
  surface.run_alone(visitor, 1, [&]()
  { covered = geodesics::geodesic_farthest_point_sampling(surface.mesh(), n, std::back_inserter(samples), np); });
  return py::make_tuple(to_ids(samples), covered);
}

py::array_t<std::int64_t> relax(Surface& surface, const Array<std::int64_t>& sites, const Relaxation& relaxation,
                                const Call& call)
{
  const std::vector<Vertex> before = to_vertices(sites);
  std::vector<Vertex> after;
  relax_alone(surface, 1, relaxation, call, [&](auto tag, const auto& np)
  { geodesics::geodesic_Lloyd_relaxation<decltype(tag)>(surface.mesh(), before, std::back_inserter(after), np); });
  return to_ids(after);
}

// Returns the points and the faces of a coarser mesh.
py::tuple remesh(Surface& surface, std::size_t n, const Relaxation& relaxation, const Call& call)
{
  Mesh coarse;
  relax_alone(surface, n + 1, relaxation, call, [&](auto tag, const auto& np)
  { geodesics::geodesic_remeshing<decltype(tag)>(surface.mesh(), n, coarse, np); });
  return mesh_to_tuple(coarse);
}

} // namespace

void bind_diagrams(py::module_& module, Surface_class& surface)
{
  bind_diagram<CGAL::Sequential_tag>(module, "Diagram");
  if(has_threads)
    bind_diagram<Threads>(module, "Parallel_diagram");
  surface.def("diagram", &diagram).def("sample", &sample).def("relax", &relax).def("remesh", &remesh);
}

} // namespace geodesics_python
