// Samples and remeshing.

#include "Surface.h"

#include <CGAL/Surface_mesh_geodesics/geodesic_farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/geodesic_remeshing.h>

#include <functional>
#include <iterator>
#include <stdexcept>

namespace geodesics_python {

namespace {

namespace geodesics = CGAL::Surface_mesh_geodesics;

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
  surface.run_alone(visitor, false, [&]()
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
  surface.run_alone(visitor, false, [&]()
  {
    is_manifold = geodesics::geodesic_remeshing(
      surface.mesh(), n, coarse,
      CGAL::parameters::number_of_iterations(iterations).visitor(std::ref(visitor))).is_manifold();
  });
  if(!is_manifold)
    throw std::runtime_error("the triangles between " + std::to_string(n)
                             + " vertices form no surface; more vertices help");
  std::vector<Point> points;
  for(const Vertex v : coarse.vertices())
    points.push_back(coarse.point(v));
  std::vector<std::int64_t> faces;
  for(const Face f : coarse.faces())
    for(const Vertex v : coarse.vertices_around_face(coarse.halfedge(f)))
      faces.push_back(std::int64_t(std::size_t(v)));
  return py::make_tuple(points_to_array(points), to_rows(std::move(faces), 3));
}

} // namespace

void bind_sampling(Surface_class& surface)
{
  surface.def("sample", &sample).def("remesh", &remesh);
}

} // namespace geodesics_python
