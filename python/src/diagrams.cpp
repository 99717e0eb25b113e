// Geodesic Voronoi diagrams, and what the package makes with them: samples (in one thread), relaxation, remeshing. (One
// file, as diagrams take long to compile.)

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>

#include <pybind11/stl.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <iterator>
#include <limits>

namespace geodesics_python {

namespace {

// A diagram that is built, and the surface that it refers to. As a number of Python, null_site() is -1.
class Diagram
{
  using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits, CGAL::Default, CGAL::Default, CGAL::Default,
                                                              CGAL::Default, Threads>;

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

  // The nearest site of each vertex, -1 if none reaches it, and the distances.
  py::tuple at_vertices() const
  {
    std::vector<std::int64_t> labels;
    std::vector<double> distances;
    for(const Vertex v : m_surface->mesh().vertices())
    {
      labels.push_back(std::int64_t(m_voronoi.nearest_site(v)));
      const double d = m_voronoi.distance_to_nearest_site(v);
      distances.push_back(labels.back() < 0 ? std::numeric_limits<double>::infinity() : d);
    }
    return py::make_tuple(to_array(std::move(labels)), to_array(std::move(distances)));
  }

  py::array_t<double> areas() const
  {
    return of_sites<double>([&](std::size_t i, auto& areas) { areas.push_back(m_voronoi.area(i)); });
  }

  py::array_t<bool> are_disks() const
  {
    return of_sites<char>([&](std::size_t i, auto& bits) { bits.push_back(m_voronoi.is_disk(i)); }).view("bool");
  }

  py::array_t<double> centroids() const
  {
    return of_sites<double>([&](std::size_t i, auto& rows)
    {
      const Point p = m_voronoi.centroid(i);
      rows.insert(rows.end(), {p.x(), p.y(), p.z()});
    }, 3);
  }

  // The pairs of cells with a common edge, the smaller number first.
  py::array_t<std::int64_t> adjacency() const
  {
    return of_sites<std::int64_t>([&](std::size_t i, auto& rows)
    {
      for(const std::size_t j : m_voronoi.adjacent_sites(i))
        if(i < j)
          rows.insert(rows.end(), {std::int64_t(i), std::int64_t(j)});
    }, 2);
  }

  // Red, green and blue of each cell, from 0 to 255.
  py::array_t<std::int64_t> colors() const
  {
    std::vector<std::int64_t> result;
    for(const auto& c : without_lock([&]() { return geodesics::geodesic_Voronoi_cell_colors(m_voronoi); }))
      result.insert(result.end(), {c.red(), c.green(), c.blue()});
    return to_rows(std::move(result), 3);
  }

  // The curves around a cell: for each its points, their faces, their coordinates there, the vertices of the diagram
  // that they are, or -1, and whether it is closed.
  py::list boundary_polylines(std::size_t i, double tolerance, bool closes_at_border) const
  {
    py::list result;
    for(const auto& line : without_lock([&]() { return m_voronoi.boundary_polylines(i, tolerance, closes_at_border); }))
    {
      Line arrays;
      for(const auto& location : line.locations)
        arrays.add(m_voronoi.point(location), location);
      std::vector<std::int64_t> vertices(line.vertices.begin(), line.vertices.end());
      result.append(arrays.to_tuple() + py::make_tuple(to_array(std::move(vertices)), line.is_closed));
    }
    return result;
  }

  double energy() const { return without_lock([&]() { return m_voronoi.energy(); }); }

  // The findings about the dual, in the order of DualReport.
  py::tuple check_dual() const
  {
    const auto r = without_lock([&]() { return geodesics::check_geodesic_dual(m_voronoi); });
    return py::make_tuple(r.is_manifold(), r.is_triangulation(), r.is_polygon_mesh, r.cells_that_are_not_disks,
                          r.cells_with_several_boundaries, r.cells_without_triangle, r.pairs_with_several_edges,
                          r.pairs_without_triangle, r.triples_with_several_vertices, r.vertices_of_many_cells);
  }

  // The triples of sites around the vertices of the diagram.
  py::array_t<std::int64_t> dual() const
  {
    std::vector<std::int64_t> numbers;
    const auto add = [&](const auto& triple) { numbers.insert(numbers.end(), triple.begin(), triple.end()); };
    Interruptible{py::none()}.run([&]() { m_voronoi.dual(boost::make_function_output_iterator(add)); });
    return to_rows(std::move(numbers), 3);
  }

  // The mesh cut along the diagram: points, faces, the cell of each face.
  py::tuple cut(double tolerance) const
  {
    return mesh_with_numbers<std::size_t>([&](Mesh& mesh, const auto& map) { m_voronoi.cut(mesh, map, tolerance); });
  }

  // One cell: points, faces, the face of the surface that each face lies in.
  py::tuple cell_mesh(std::size_t i, double tolerance) const
  {
    return mesh_with_numbers<Face>([&](Mesh& mesh, const auto& map) { m_voronoi.cell_mesh(i, mesh, map, tolerance); });
  }

private:
  // Numbers, or rows of numbers, of the sites: add(i, numbers) adds those of site i.
  template <typename T, typename Add>
  py::array_t<T> of_sites(const Add& add, std::size_t columns = 1) const
  {
    std::vector<T> numbers;
    Interruptible visitor{py::none()};
    visitor.run([&]()
    {
      for(std::size_t i = 0; i < m_voronoi.number_of_sites() && visitor.ask_and_go_further(); ++i)
        add(i, numbers);
    });
    return to_rows(std::move(numbers), columns);
  }

  // Returns a mesh that make(mesh, map) fills, with the number of what the map has for each face.
  template <typename T, typename Make>
  static py::tuple mesh_with_numbers(const Make& make)
  {
    Mesh mesh;
    Interruptible visitor{py::none()};
    const auto values = mesh.add_property_map<Face, T>("f:value").first;
    visitor.run([&]() { make(mesh, interruptible(visitor, values)); });
    std::vector<std::int64_t> numbers;
    for(const Face f : mesh.faces())
      numbers.push_back(std::int64_t(std::size_t(values[f])));
    return mesh_to_tuple(mesh) + py::make_tuple(to_array(std::move(numbers)));
  }

  std::shared_ptr<Surface> m_surface;
  Voronoi m_voronoi;
};

std::unique_ptr<Diagram> diagram(const std::shared_ptr<Surface>& surface, const Place_arrays& places,
                                 const Array<double>& site_weights, const Call& call)
{
  return std::make_unique<Diagram>(surface, Places(surface->mesh(), places), site_weights, call);
}

// Calls a Python function after each iteration of a relaxation. (A model of GeodesicRelaxationVisitor.)
struct Relaxation_visitor : Interruptible
{
  using Interruptible::Interruptible;

  bool go_further() { return ask_and_go_further(); } // also between the steps of an iteration

  void on_iteration(std::size_t iteration, double largest_move, double energy)
  {
    if(go_further() && !function.is_none())
      call_python([&]() { function(iteration, largest_move, energy); });
  }

  py::object function; // or None
};

// How many iterations, the threshold, and a function that is called after each one, or None.
using Relaxation = std::tuple<unsigned int, double, py::object>;

// Calls compute() with the named parameters of a relaxation.
template <typename Compute>
void relax_alone(Surface& surface, std::size_t number_of_runs, const Relaxation& relaxation, const Call& call,
                 const Compute& compute)
{
  const auto& [iterations, threshold, on_iteration] = relaxation;
  Relaxation_visitor visitor(call.second, number_of_runs + iterations);
  visitor.function = on_iteration;
  const auto np
    = CGAL::parameters::visitor(std::ref(visitor)).number_of_iterations(iterations).threshold_distance(threshold);
  surface.run_alone(visitor, call.first, [&]() { compute(np); });
}

// Returns the samples, without the first ones, and the covering radius.
py::tuple sample(Surface& surface, std::size_t n, const Array<std::int64_t>& first, double radius,
                 const py::object& progress)
{
  std::vector<Vertex> samples;
  double covered = 0;
  Interruptible visitor(progress, n + 1);
  const auto np
    = CGAL::parameters::first_samples(to_vertices(first)).covering_radius(radius)
        .faces_to_avoid(surface.avoided_faces()).visitor(std::ref(visitor));
  surface.run_alone(visitor, 1, [&]()
  { covered = geodesics::geodesic_farthest_point_sampling(surface.mesh(), n, std::back_inserter(samples), np); });
  return py::make_tuple(to_ids(samples), covered);
}

py::array_t<std::int64_t> relax(Surface& surface, const Array<std::int64_t>& sites, const Relaxation& relaxation,
                                const Call& call)
{
  const std::vector<Vertex> before = to_vertices(sites);
  std::vector<Vertex> after;
  relax_alone(surface, 1, relaxation, call, [&](const auto& np)
  { geodesics::geodesic_Lloyd_relaxation<Threads>(surface.mesh(), before, std::back_inserter(after),
      CGAL::parameters::faces_to_avoid(surface.avoided_faces()).combine(np)); });
  return to_ids(after);
}

// Returns the points and the faces of a coarser mesh.
py::tuple remesh(Surface& surface, std::size_t n, const Relaxation& relaxation, const Call& call)
{
  Mesh coarse;
  relax_alone(surface, n + 1, relaxation, call, [&](const auto& np)
  { geodesics::geodesic_remeshing<Threads>(surface.mesh(), n, coarse,
      CGAL::parameters::faces_to_avoid(surface.avoided_faces()).combine(np)); });
  return mesh_to_tuple(coarse);
}

} // namespace

void bind_diagrams(py::module_& module, Surface_class& surface)
{
  py::class_<Diagram>(module, "Diagram")
    .def("at_vertices", &Diagram::at_vertices).def("areas", &Diagram::areas).def("centroids", &Diagram::centroids)
    .def("adjacency", &Diagram::adjacency).def("colors", &Diagram::colors).def("are_disks", &Diagram::are_disks)
    .def("boundary_polylines", &Diagram::boundary_polylines).def("energy", &Diagram::energy)
    .def("dual", &Diagram::dual).def("check_dual", &Diagram::check_dual)
    .def("cut", &Diagram::cut).def("cell_mesh", &Diagram::cell_mesh);
  surface.def("diagram", &diagram).def("sample", &sample).def("relax", &relax).def("remesh", &remesh);
}

} // namespace geodesics_python
