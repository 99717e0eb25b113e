// Geodesic Voronoi diagrams.

#include "Engines.h"

#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace geodesics_python {

namespace {

// A diagram that is built, and the surface that it refers to.
class Diagram
{
  using Voronoi = CGAL::Surface_mesh_geodesic_Voronoi_diagram<Traits, CGAL::Default, CGAL::Default, CGAL::Default,
                                                              CGAL::Default, CGAL::Sequential_tag>;

public:
  Diagram(std::shared_ptr<Surface> surface, const Places& sites, const Array<double>& weights,
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
    visitor.run(false, [&]() { m_voronoi.build(visitor); });
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
    for(std::size_t i = 0; i < number_of_sites(); ++i)
      for(const std::size_t j : m_voronoi.adjacent_sites(i))
        if(i < j)
          pairs.insert(pairs.end(), {std::int64_t(i), std::int64_t(j)});
    return to_rows(std::move(pairs), 2);
  }

  // The curves around a cell; a closed one ends with its first point.
  py::list boundaries(std::size_t i, double tolerance) const
  {
    std::vector<std::vector<Point>> curves;
    Interruptible visitor{py::none()};
    visitor.run(false, [&]() { find_boundaries(i, tolerance, visitor, curves); });
    py::list result;
    for(const std::vector<Point>& curve : curves)
      result.append(points_to_array(curve));
    return result;
  }

  // The triples of sites around the vertices of the diagram.
  py::array_t<std::int64_t> dual() const
  {
    std::vector<std::array<std::size_t, 3>> triples;
    m_voronoi.dual(std::back_inserter(triples));
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
    auto cell = mesh.add_property_map<Face, std::size_t>("f:cell", 0).first;
    Interruptible visitor{py::none()};
    visitor.run(false, [&]() { m_voronoi.cut(mesh, cell, tolerance); });
    std::vector<Point> points;
    for(const Vertex v : mesh.vertices())
      points.push_back(mesh.point(v));
    std::vector<std::int64_t> faces, cells;
    for(const Face f : mesh.faces())
    {
      for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f)))
        faces.push_back(std::int64_t(std::size_t(v)));
      cells.push_back(number(cell[f]));
    }
    return py::make_tuple(points_to_array(points), to_rows(std::move(faces), 3), to_array(std::move(cells)));
  }

private:
  template <typename Compute>
  static void without_lock(const Compute& compute)
  {
    const py::gil_scoped_release release;
    compute();
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

  void find_boundaries(std::size_t i, double tolerance, const Interruptible& visitor,
                       std::vector<std::vector<Point>>& curves) const
  {
    for(const auto& boundary : m_voronoi.boundary(i))
    {
      std::vector<Point> points;
      for(const auto& [edge, is_reversed] : boundary.edges)
      {
        if(!visitor.go_further())
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

std::unique_ptr<Diagram> diagram_of(std::shared_ptr<Surface> surface, const Array<std::int64_t>& vertex,
                                    const Array<std::int64_t>& face, const Array<double>& weights,
                                    const Array<double>& site_weights, const py::object& progress)
{
  const Places sites(surface->mesh(), vertex, face, weights);
  return std::make_unique<Diagram>(std::move(surface), sites, site_weights, progress);
}

} // namespace

void bind_diagrams(py::module_& module, Surface_class& surface)
{
  py::class_<Diagram>(module, "Diagram")
    .def("at_vertices", &Diagram::at_vertices)
    .def("areas", &Diagram::areas)
    .def("centroids", &Diagram::centroids)
    .def("adjacency", &Diagram::adjacency)
    .def("boundaries", &Diagram::boundaries)
    .def("dual", &Diagram::dual)
    .def("cut", &Diagram::cut);
  surface.def("diagram", [](std::shared_ptr<Surface> self, const Array<std::int64_t>& vertex,
                            const Array<std::int64_t>& face, const Array<double>& weights,
                            const Array<double>& site_weights, const py::object& progress)
              { return diagram_of(std::move(self), vertex, face, weights, site_weights, progress); });
}

} // namespace geodesics_python
