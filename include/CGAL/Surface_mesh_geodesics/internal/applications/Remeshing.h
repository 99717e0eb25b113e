// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_H

// Approximates a mesh by the dual of the geodesic Voronoi diagram of some of its points: sampling, relaxation, and then
// rounds of "diagram, dual, further samples where the dual is not manifold". (The thesis, section 5.4.4, takes the dual
// of random sites.)
//
// Why rounds come to an end with a manifold dual: a new sample is a point far from all samples in the cells that
// violate a condition, so these shrink until they are small beside the shape: disks whose neighbors meet them once
// (Edelsbrunner and Shah, Triangulating topological spaces, 1997). That argument needs points of faces as samples where
// the vertices of the mesh are too sparse. It does not hold at tips, which Sample_placement treats apart, nor for
// needles, which are so thin that samples all along would be more than the vertices.
//
// Components are independent of each other. Each one ends in one of two ways: its dual is manifold and has the topology
// of the component; or the component keeps its faces, as it would need as many samples as it has vertices, or as it has
// no area and so no dual.
//
// One visitor follows all propagations; once it cancels one, no further one starts.

#include <CGAL/Surface_mesh_geodesics/internal/applications/Dual_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Farthest_point_sampling.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Lloyd_relaxation.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Remeshing_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Sample_placement.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Report is Geodesic_remeshing_report, and Diagram_ is Surface_mesh_geodesic_Voronoi_diagram. An object remeshes once.
// The input is referred to. Sampling, relaxation and rounds work on the same type of mesh and diagram.
//
// A round computes the diagram of all samples that are left, and looks at the cells of each component. If their dual is
// a mesh with the topology of the component, its triangles become part of the result, and its samples are removed. If
// not, the component gets further samples where the dual is wrong (Sample_placement.h). So components do not wait for
// each other, and a round costs no more than what is not done.
template <template <typename...> class Diagram_, typename ConcurrencyTag, typename Report>
class Remeshing
{
  using Dual_report = typename Report::Dual_report;
  using Mesh = Remeshing_input::Mesh;
  using Vertex = Remeshing_input::Vertex;
  using Face = Remeshing_input::Face;
  using Diagram_of_round
    = decltype(make_vertex_site_diagram<Diagram_, ConcurrencyTag>(std::declval<const Mesh&>(),
                                                                   parameters::default_values()));
  using Diagram = typename Diagram_of_round::Diagram;
  using Samples = Remeshing_samples<Diagram>;
  using Triangle = std::array<std::size_t, 3>;
  using Point = Remeshing_input::Kernel::Point_3;

  // Each round adds a sample to each component that is not done, so there is an end without this bound, too: no
  // component gets as many samples as it has vertices. Of CGAL's meshes none needs half of the rounds.
  static constexpr std::size_t largest_number_of_rounds = 100;

public:
  // Computes nothing yet: the work, which visitors follow, is in run(). The report already tells what the input was.
  explicit Remeshing(const Remeshing_input& input)
    : m_input(input), m_mesh(input.mesh()), m_number_of_samples(input.components().size(), 0),
      m_is_done(input.components().size(), false)
  {
    m_report.number_of_split_vertices = input.number_of_splits();
    m_report.number_of_components = input.components().size();
  }

  // Finds the points and triangles of the new mesh, from n samples. The relaxation ends after the given number of
  // iterations, or when no sample moves farther than the threshold among the named parameters. If the visitor cancels,
  // the report is not complete, and write() must not be called.
  template <typename Visitor, typename NamedParameters>
  Report run(std::size_t n, std::size_t number_of_iterations, Visitor& users_visitor, const NamedParameters& np)
  {
    Visitor_of_several_runs<Visitor> visitor(users_visitor);
    sample_farthest_points(m_mesh, n, std::back_inserter(m_samples.vertices), Sampling_options<Mesh>(),
                           parameters::visitor(std::ref(visitor)));
    if(visitor.is_canceled())
      return Report();
    m_report.number_of_samples = m_samples.vertices.size();
    // A component without a vertex to choose stays as it is. Its dual would be the intrinsic Delaunay triangulation of
    // its vertices, whose triangles leave the surface where edges of the mesh are sharp.
    count(m_samples, m_number_of_samples);
    m_number_of_first_samples = m_number_of_samples;
    for(std::size_t c = 0; c < m_is_done.size(); ++c)
      if(m_number_of_samples[c] >= m_input.components()[c].number_of_vertices)
      {
        ++m_report.number_of_components_of_samples;
        keep(c);
      }
    remove_samples_of_done_components();
    // Components that are done need no relaxation: their samples are gone. The new mesh ends where samples on the
    // border are, so these stay: it would shrink otherwise. (A relaxation that the visitor cancels returns like any
    // other.)
    relax_sites<Diagram_, ConcurrencyTag>(m_mesh, m_samples.vertices, number_of_iterations, visitor, np,
                                          [this](Vertex v) { return bool(CGAL::is_border(v, m_mesh)); });
    if(visitor.is_canceled())
      return Report();
    auto diagram = make_vertex_site_diagram<Diagram_, ConcurrencyTag>(m_mesh, parameters::default_values());
    while(!std::all_of(m_is_done.begin(), m_is_done.end(), [](bool is_done) { return is_done; }))
    {
      diagram.set_sites(m_samples.vertices);
      diagram.add_points(m_samples.points);
      if(visitor.is_canceled() || !diagram.diagram().build(visitor))
        return Report();
      ++m_report.number_of_rounds;
      finish_or_refine(diagram.diagram());
    }
    m_report.number_of_vertices = m_points.size();
    m_report.is_complete = true;
    return m_report;
  }

  // Adds the new mesh to the output, and leaves what the output has held before.
  // Requires: run() has returned a complete report.
  template <typename OutputMesh>
  void write(OutputMesh& output) const
  {
    using Output_point = typename boost::property_traits<
      typename boost::property_map<OutputMesh, CGAL::vertex_point_t>::type>::value_type;
    static_assert(!Is_of_the_plane<Output_point>::value, "the points of the output are points of the plane");
    std::vector<Output_point> points;
    for(const Point& p : m_points)
      points.push_back(Output_point(p.x(), p.y(), p.z()));
    Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, m_triangles, output);
  }

private:
  // Counts samples by components. Requires: `number` has an entry for each component.
  void count(const Samples& samples, std::vector<std::size_t>& number) const
  {
    std::fill(number.begin(), number.end(), 0);
    for(const Vertex v : samples.vertices)
      ++number[m_input.component_of(v)];
    for(const auto& p : samples.points)
      ++number[m_input.component_of(p.first)];
  }

  // The components that are done get no sites any more, so the diagrams of later rounds leave them out.
  void remove_samples_of_done_components()
  {
    const auto remove = [this](auto& samples, auto element_of)
    {
      samples.erase(std::remove_if(samples.begin(), samples.end(), [&](const auto& sample)
                    { return bool(m_is_done[m_input.component_of(element_of(sample))]); }), samples.end());
    };
    remove(m_samples.vertices, [](Vertex v) { return v; });
    remove(m_samples.points, [](const auto& location) { return location.first; });
  }

  // Takes the triangles of each component whose dual is right, and adds samples to the others: one round.
  //
  // A triangle belongs to the component of its first corner, as the three cells meet. Samples are counted before they
  // are added: a component that would get too many ends here, and its samples are dropped.
  void finish_or_refine(const Diagram& diagram)
  {
    Dual_check<Diagram, Dual_report> check(diagram);
    std::vector<std::vector<Triangle>> triangles(m_is_done.size());
    for(const Triangle& t : check.triangles())
      triangles[component_of_site(diagram, t[0])].push_back(t);
    Samples further = further_samples(diagram, check);
    std::vector<std::size_t> number_of_new(m_is_done.size(), 0);
    count(further, number_of_new);
    for(std::size_t c = 0; c < m_is_done.size(); ++c)
    {
      if(m_is_done[c])
        continue;
      // The report has no finding here, except that the triangles may fail for a reason that no list shows. Where the
      // points of a component are on a line, its cells are empty, so there are neither findings nor triangles. CGAL
      // takes no triangles for a polygon mesh, and the component would be lost.
      if(number_of_new[c] == 0 && !triangles[c].empty()
         && Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(triangles[c]))
        finish(c, diagram, triangles[c]);
      else if(number_of_new[c] == 0 || m_report.number_of_rounds == largest_number_of_rounds
              || m_number_of_samples[c] + number_of_new[c] >= m_input.components()[c].number_of_vertices)
        give_up(c);
    }
    m_samples.vertices.insert(m_samples.vertices.end(), further.vertices.begin(), further.vertices.end());
    m_samples.points.insert(m_samples.points.end(), further.points.begin(), further.points.end());
    count(m_samples, m_number_of_samples);
    remove_samples_of_done_components();
  }

  // The samples that the findings ask for, those that part the corners of a triangle without area, and the first sample
  // of each component that has none. The samples for findings come first, as they may part the corners as well.
  Samples further_samples(const Diagram& diagram, Dual_check<Diagram, Dual_report>& check) const
  {
    // The triangles without area come last, as a sample for another finding is likely to part their corners.
    Sample_placement<Diagram> placement(diagram, m_samples);
    placement.add(check.report());
    for(Triangle t : check.triangles())
      if(is_degenerate(diagram, t))
      {
        std::sort(t.begin(), t.end());
        placement.add_at_vertex(t);
      }
    Samples further = placement.new_samples();
    for(std::size_t c = 0; c < m_is_done.size(); ++c)
      if(!m_is_done[c] && m_number_of_samples[c] == 0)
        further.vertices.push_back(m_mesh.source(m_mesh.halfedge(m_input.components()[c].faces.front())));
    return further;
  }

  static Point point_of_site(const Diagram& diagram, std::size_t i) { return diagram.point(diagram.site(i)); }

  std::size_t component_of_site(const Diagram& diagram, std::size_t i) const
  {
    return m_input.component_of(diagram.site(i).first);
  }

  // Exact: whether the three points are on a line. Points of the surface may be so in space although they are not on a
  // geodesic line, for instance on both sides of a thin plate.
  static bool is_degenerate(const Diagram& diagram, const Triangle& t)
  {
    using Exact = Exact_predicates_inexact_constructions_kernel;
    const auto exact = [&](std::size_t i)
    {
      const Point p = point_of_site(diagram, i);
      return Exact::Point_3(p.x(), p.y(), p.z());
    };
    return CGAL::collinear(exact(t[0]), exact(t[1]), exact(t[2]));
  }

  // Takes the dual of a component. All conditions hold for its cells, so it has the topology of the component.
  void finish(std::size_t c, const Diagram& diagram, const std::vector<Triangle>& triangles)
  {
    const std::size_t number_before = m_points.size();
    add_faces(triangles, [&](std::size_t i) { return point_of_site(diagram, i); });
    // Samples with empty cells are not counted: they are nearer to others than rounding tells.
    m_report.number_of_added_samples
      += (std::max)(m_points.size() - number_before, m_number_of_first_samples[c]) - m_number_of_first_samples[c];
    m_is_done[c] = true;
  }

  // Keeps a component that has no dual, or whose dual needs too many samples. Reports where it is: its first point, as
  // a component has no name that the user knows.
  void give_up(std::size_t c)
  {
    const auto& faces = m_input.components()[c].faces;
    const Point& p = m_mesh.point(m_mesh.source(m_mesh.halfedge(faces.front())));
    m_report.kept_components.push_back({{p.x(), p.y(), p.z()}, m_input.components()[c].number_of_vertices,
                                        faces.size()});
    keep(c);
  }

  // Takes the faces of a component as they are. If two edges join the same two vertices, three indices do not tell a
  // face; then the faces are divided.
  void keep(std::size_t c)
  {
    const auto& component = m_input.components()[c];
    std::vector<Triangle> faces;
    for(const Face f : component.faces)
    {
      const auto h = m_mesh.halfedge(f);
      faces.push_back({m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))});
    }
    const auto point = [&](std::size_t v) { return m_mesh.point(Vertex(static_cast<Mesh::size_type>(v))); };
    if(Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(faces))
      add_faces(faces, point);
    else
      keep_divided(component.faces);
    m_is_done[c] = true;
  }

  // Where the two edges are, neither their ends nor the soup of triangles tell one from the other. With a new vertex on
  // each edge, no two edges have the same ends. The points of the surface stay the same.
  //
  // Takes the six parts into which the medians of each face divide it. Numbers: vertices, then edges, then faces.
  void keep_divided(const std::vector<Face>& its_faces)
  {
    const std::size_t first_edge = m_mesh.num_vertices(), first_face = first_edge + m_mesh.num_edges();
    std::vector<Triangle> parts;
    std::map<std::size_t, Point> point;
    for(const Face f : its_faces)
    {
      const auto h = m_mesh.halfedge(f);
      const Point a = m_mesh.point(m_mesh.source(h)), b = m_mesh.point(m_mesh.target(h)),
                  c = m_mesh.point(m_mesh.target(m_mesh.next(h)));
      const std::size_t center = first_face + f;
      point[center] = CGAL::centroid(a, b, c);
      for(const auto g : CGAL::halfedges_around_face(h, m_mesh))
      {
        const Vertex from = m_mesh.source(g), to = m_mesh.target(g);
        const std::size_t middle = first_edge + m_mesh.edge(g);
        point[from] = m_mesh.point(from);
        point[middle] = CGAL::midpoint(m_mesh.point(from), m_mesh.point(to));
        parts.push_back({from, middle, center});
        parts.push_back({middle, to, center});
      }
    }
    add_faces(parts, [&](std::size_t i) { return point.at(i); });
  }

  // All results of a remeshing come here: triangles of a dual, named by samples, and faces that are kept, named by
  // vertices. Components have no vertex in common, so each
  // gets points of its own, although the numbers begin anew.
  //
  // Adds triangles whose corners have numbers, and a point for each number, in the order in which they are named.
  template <typename Point_of>
  void add_faces(const std::vector<Triangle>& triangles, Point_of point_of)
  {
    std::map<std::size_t, std::size_t> index;
    for(const Triangle& t : triangles)
    {
      Triangle indices;
      for(std::size_t k = 0; k < 3; ++k)
      {
        const auto inserted = index.insert({t[k], m_points.size()});
        if(inserted.second)
          m_points.push_back(point_of(t[k]));
        indices[k] = inserted.first->second;
      }
      m_triangles.push_back(indices);
    }
  }

  const Remeshing_input& m_input;
  const Mesh& m_mesh;
  // The invariants between two rounds: samples are in components that are not done, and number_of_samples counts them.
  // Points and triangles are those of the components that are done.
  Samples m_samples;
  // By component: in all, and before any was added.
  std::vector<std::size_t> m_number_of_samples, m_number_of_first_samples;
  std::vector<bool> m_is_done; // by component
  std::vector<Point> m_points;
  std::vector<Triangle> m_triangles; // their corners are indices of points
  Report m_report;
};

// Throws Invalid_geodesic_input if a mesh cannot be copied, or its copy cannot be remeshed: with the positions of
// vertices and faces that the user knows, and before CGAL's functions meet faces that contradict each other. Takes
// linear time.
//
// Returns a flag for each face in the order of faces(tm), set for the faces to avoid; none if there are no such faces.
// They are not checked: distances ignore what is wrong with them, too.
template <typename TriangleMesh, typename NamedParameters>
std::vector<char> check_mesh(const TriangleMesh& tm, const NamedParameters& np)
{
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  const std::vector<char> is_avoided = avoided_faces(tm, fim, np);
  Intrinsic_surface<double, TriangleMesh, decltype(vim), decltype(fim)> surface(tm, vim, fim,
                                                                                  Obstacles{is_avoided, {}});
  surface.read(shape_from_points<double>(tm, np));
  std::vector<char> flags;
  if(!is_avoided.empty())
    for(const auto f : faces(tm))
      flags.push_back(is_avoided[static_cast<std::size_t>(get(fim, f))]);
  return flags;
}

// Reads and remeshes a mesh, with the named parameters of geodesic_remeshing(), and adds the result to the output if
// the visitor does not cancel. Throws Invalid_geodesic_input, before the output changes.
template <template <typename...> class Diagram, typename ConcurrencyTag, typename Report, typename TriangleMesh,
          typename OutputMesh, typename Visitor, typename NamedParameters>
Report remesh(const TriangleMesh& tm, std::size_t n, OutputMesh& output, Visitor& visitor, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const std::size_t number_of_iterations
    = value_parameter<std::size_t>(np, internal_np::number_of_iterations, 5);
  const double threshold = number_parameter(np, internal_np::threshold_distance, 0.);
  const std::vector<char> is_avoided = check_mesh(tm, np);
  const Remeshing_input input(tm, choose_parameter(get_parameter(np, internal_np::vertex_point),
                                                   get_const_property_map(CGAL::vertex_point, tm)),
                              is_avoided);
  Remeshing<Diagram, ConcurrencyTag, Report> remeshing(input);
  const Report report
    = remeshing.run(n, number_of_iterations, visitor, parameters::threshold_distance(threshold));
  if(report.is_complete)
    remeshing.write(output);
  return report;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_REMESHING_H
