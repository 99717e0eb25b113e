// Geodesic Voronoi diagrams, and what the package makes with them: samples and remeshing. (One file, because compiling
// the diagram takes longer than everything else.)

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_Voronoi_cell_colors.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>

namespace geodesics_python {

namespace {

// The faces of a mesh, as rows of three vertices.
py::array_t<std::int64_t> faces_of(const Mesh& mesh)
{
  std::vector<std::int64_t> faces;
  for(const Face f : mesh.faces())
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
      faces.push_back(std::int64_t(std::size_t(v)));
  return to_rows(std::move(faces), 3);
}

py::array_t<double> points_of(const Mesh& mesh)
{
  std::vector<Point> points;
  for(const Vertex v : mesh.vertices())
    points.push_back(mesh.point(v));
  return points_to_array(points);
}

// The cell of each face of a mesh that is cut along a diagram. The cut ends with an exception if Python interrupts it.
struct Cell_map
{
  using key_type = Face;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::writable_property_map_tag;

  friend void put(const Cell_map& map, Face f, std::size_t cell)
  {
    if(!map.visitor.ask_and_go_further())
      throw std::runtime_error("interrupted");
    map.cells[f] = cell;
  }

  Interruptible& visitor;
  Mesh::Property_map<Face, std::size_t> cells;
};

// A diagram that is built, and the surface that it refers to.
template <typename Tag>
class Diagram
{
  using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits, CGAL::Default, CGAL::Default, CGAL::Default,
                                                              CGAL::Default, Tag>;

public:
  Diagram(std::shared_ptr<Surface> surface, const Places& sites, const Array<double>& weights, std::size_t threads,
          const py::object& progress)
    : m_surface(std::move(surface)), m_voronoi(m_surface->mesh())
  {
    if(m_surface->has_lengths())
      m_voronoi.use_edge_lengths(m_surface->lengths());
    sites.visit([&](const auto& range)
    {
      for(std::size_t i = 0; i < range.size(); ++i)
        m_voronoi.add_site(range[i], weights.size() == 0 ? 0. : weights.data()[i]);
    });
    Interruptible visitor(progress);
    visitor.run([&]() { with_threads(threads, [&]() { m_voronoi.build(visitor); }); });
  }

  std::size_t number_of_sites() const { return m_voronoi.number_of_sites(); }

  // The nearest site of each vertex, -1 if none reaches it, and the distances.
  py::tuple at_vertices() const
  {
    std::vector<std::int64_t> labels;
    std::vector<double> distances;
    without_lock([&]() { find_at_vertices(labels, distances); });
    return py::make_tuple(to_array(std::move(labels)), to_array(std::move(distances)));
  }

  py::array_t<double> areas() const
  {
    std::vector<double> result;
    without_lock([&]()
    {
      for(std::size_t i = 0; i < number_of_sites(); ++i)
        result.push_back(m_voronoi.area(i));
    });
    return to_array(std::move(result));
  }

  py::array_t<double> centroids() const
  {
    std::vector<Point> result;
    without_lock([&]()
    {
      for(std::size_t i = 0; i < number_of_sites(); ++i)
        result.push_back(m_voronoi.centroid(i));
    });
    return points_to_array(result);
  }

  // The pairs of cells with a common edge, the smaller number first.
  py::array_t<std::int64_t> adjacency() const
  {
    std::vector<std::int64_t> pairs;
    without_lock([&]()
    {
      for(std::size_t i = 0; i < number_of_sites(); ++i)
        for(const std::size_t j : m_voronoi.adjacent_sites(i))
          if(i < j)
            pairs.insert(pairs.end(), {std::int64_t(i), std::int64_t(j)});
    });
    return to_rows(std::move(pairs), 2);
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

  // The curves around a cell; a closed one ends with its first point.
  py::list boundaries(std::size_t i, double tolerance) const
  {
    std::vector<std::vector<Point>> curves;
    Interruptible visitor{py::none()};
    visitor.run([&]() { find_boundaries(i, tolerance, visitor, curves); });
    py::list result;
    for(const std::vector<Point>& curve : curves)
      result.append(points_to_array(curve));
    return result;
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
    Mesh mesh;
    Interruptible visitor{py::none()};
    const Cell_map cell{visitor, mesh.add_property_map<Face, std::size_t>("f:cell", 0).first};
    visitor.run([&]() { m_voronoi.cut(mesh, cell, tolerance); });
    std::vector<std::int64_t> cells;
    for(const Face f : mesh.faces())
      cells.push_back(number(cell.cells[f]));
    return py::make_tuple(points_of(mesh), faces_of(mesh), to_array(std::move(cells)));
  }

private:
  template <typename Compute>
  static void without_lock(const Compute& compute)
  {
    Interruptible visitor{py::none()};
    visitor.run(compute);
  }

  void find_at_vertices(std::vector<std::int64_t>& labels, std::vector<double>& distances) const
  {
    for(const Vertex v : m_surface->mesh().vertices())
    {
      labels.push_back(number(m_voronoi.nearest_site(v)));
      const double d = m_voronoi.distance_to_nearest_site(v);
      distances.push_back(labels.back() < 0 ? std::numeric_limits<double>::infinity() : d);
    }
  }

  void find_boundaries(std::size_t i, double tolerance, Interruptible& visitor,
                       std::vector<std::vector<Point>>& curves) const
  {
    for(const auto& boundary : m_voronoi.boundary(i))
    {
      std::vector<Point> points;
      for(const auto& [edge, is_reversed] : boundary.edges)
      {
        if(!visitor.ask_and_go_further())
          return;
        std::vector<Point> part;
        edge.polyline(tolerance, std::back_inserter(part));
        if(is_reversed)
          std::reverse(part.begin(), part.end());
        // (An edge begins where the one before it ends.)
        points.insert(points.end(), part.begin() + (points.empty() || part.empty() ? 0 : 1), part.end());
      }
      // (Rounding may have moved the end, which comes from another face.)
      if(boundary.is_closed && !points.empty())
        points.back() = points.front();
      curves.push_back(std::move(points));
    }
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
    .def("boundaries", &Class::boundaries)
    .def("dual", &Class::dual)
    .def("cut", &Class::cut);
}

py::object diagram(const std::shared_ptr<Surface>& surface, const Array<std::int64_t>& vertex,
                   const Array<std::int64_t>& face, const Array<double>& weights, const Array<double>& site_weights,
                   std::size_t threads, const py::object& progress)
{
  const Places sites(surface->mesh(), vertex, face, weights);
  if(threads > 1)
    return py::cast(std::make_unique<Diagram<Threads>>(surface, sites, site_weights, threads, progress));
  return py::cast(std::make_unique<Diagram<CGAL::Sequential_tag>>(surface, sites, site_weights, threads, progress));
}

// Returns the samples, without the first ones, and the covering radius.
py::tuple sample(Surface& surface, std::size_t n, const Array<std::int64_t>& first, double radius,
                 const py::object& progress)
{
  geodesics::Geodesic_sampling_options<Mesh> options;
  options.first_samples = to_vertices(first);
  options.covering_radius = radius;
  std::vector<std::int64_t> samples;
  double covered = 0;
  Interruptible visitor(progress, n + 1);
  surface.run_alone(visitor, [&]()
  {
    std::vector<Vertex> vertices;
    covered = geodesics::geodesic_farthest_point_sampling(surface.mesh(), n, std::back_inserter(vertices), options,
                                                          CGAL::parameters::visitor(std::ref(visitor)));
    for(const Vertex v : vertices)
      samples.push_back(std::int64_t(std::size_t(v)));
  });
  return py::make_tuple(to_array(std::move(samples)), covered);
}

// Returns the points and the faces of a coarser mesh.
py::tuple remesh(Surface& surface, std::size_t n, unsigned int iterations, const py::object& progress)
{
  Mesh coarse;
  bool is_manifold = false;
  Interruptible visitor(progress, n + iterations + 1);
  surface.run_alone(visitor, [&]()
  {
    is_manifold = geodesics::geodesic_remeshing(
      surface.mesh(), n, coarse,
      CGAL::parameters::number_of_iterations(iterations).visitor(std::ref(visitor))).is_manifold();
  });
  if(!is_manifold)
    throw std::runtime_error("the triangles between " + std::to_string(n)
                             + " vertices form no surface; more vertices help");
  return py::make_tuple(points_of(coarse), faces_of(coarse));
}

} // namespace

void bind_diagrams(py::module_& module, Surface_class& surface)
{
  bind_diagram<CGAL::Sequential_tag>(module, "Diagram");
  if(has_threads())
    bind_diagram<Threads>(module, "Parallel_diagram");
  surface.def("diagram", &diagram).def("sample", &sample).def("remesh", &remesh);
}

} // namespace geodesics_python
