// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_CERTIFIER_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_CERTIFIER_H

// Checks a geodesic Voronoi diagram by the answers of its public members, against paths and bounds that are computed
// apart. What is checked is documented at certify_geodesic_Voronoi_diagram(). `Diagram` is a type with the members of
// Surface_mesh_geodesic_Voronoi_diagram; tests pass one with wrong answers.
//
// Faces that the diagram avoids do not exist here: they have no samples and no area, and their rim is a border. Walls
// are borders, too.
//
// The steps of run():
// 1. find_components() measures the extents that violations are relative to.
// 2. The witness proves the distances of the vertices, and a lower bound everywhere (Site_witness.h).
// 3. Diagram_distance_check compares samples and arcs with the witness.
// 4. check_boundaries() follows the boundary of each cell.
// 5. check_areas() adds up the areas of the cells of each component.
// The public functions call certify_diagram_with_points() or certify_diagram_with_edge_lengths(), at the end.
//
// Violations are relative. Distances are compared with the distance plus the longest edge of the component, positions
// with that edge, areas with the expected area plus its square: the components of a mesh may differ in size by many
// orders of magnitude. Areas are compared as multiples of that square, as the squares of very small or large
// lengths underflow or overflow in the unit of the mesh.

#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_conditions.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_distance_check.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_samples.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Location_separation.h>
#include <CGAL/Surface_mesh_geodesics/internal/applications/Site_witness.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/parallel/Propagation_for_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Component_extents.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// `Length` gives the length of a halfedge in the unit of the mesh; `Separation` is described in Location_separation.h.
//
// The certifier uses the answers of the diagram and its own distances only, no table of the diagram, so that it does
// not share its faults. It records the size of each violation and judges none: the caller compares it with a tolerance.
// The mesh of the diagram is a model of FaceListGraph; the index map has values from 0 to num_vertices() - 1. All maps
// and function objects are copied. The diagram is built by its first query if that is not done, so invalid input is
// thrown from run().
template <typename Diagram, typename VertexIndexMap, typename Length, typename Separation>
class Diagram_certifier
{
  using Triangle_mesh = typename Diagram::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Face_location = typename Diagram::Face_location;
  using Samples = Diagram_samples<Diagram>;
  using Sample = typename Samples::Sample;

public:
  // The diagram is referred to, not copied.
  Diagram_certifier(const Diagram& diagram, VertexIndexMap vertex_index_map, Length length, Separation separation)
    : m_diagram(diagram), m_tm(diagram.triangle_mesh()), m_vertex_index_map(vertex_index_map), m_length(length),
      m_separation(separation)
  {}

  // Checks all conditions. `make_witness()` returns a pointer to a new witness, `make_paths()` one to a new object of
  // shortest paths without source points; both use the lengths of the diagram. The loops of the proof are those of
  // `chunks` (Chunk_team.h). The comparisons run in the calling thread. A witness knows no walls: between walls,
  // samples are compared with distances from each site, and nothing is proved. A diagram without sites has nothing to
  // check. The call may be repeated, with the same result.
  template <typename MakeWitness, typename MakePaths, typename Chunks>
  Diagram_violations run(MakeWitness make_witness, MakePaths make_paths, const Chunks& chunks)
  {
    m_violations = Diagram_violations();
    find_components();
    if(m_diagram.number_of_sites() == 0)
      return m_violations;
    if(has_walls())
      check_distances(make_paths);
    else
    {
      const auto witness = make_witness();
      using Witness = typename std::decay_t<decltype(witness)>::element_type;
      witness->prove(chunks, m_violations[DIAGRAM_DISTANCES]);
      Diagram_distance_check<Diagram, Witness, Diagram_certifier>(m_diagram, *witness, *this, m_violations).run();
    }
    check_boundaries();
    check_areas();
    return m_violations;
  }

  // --- extents, for Diagram_distance_check ---

  double extent_around(vertex_descriptor v) const { return m_components.extent(component_of(v)); }
  double extent_around(face_descriptor f) const { return extent_around(corner(f)); }

  // A site at the rim of what is avoided may be given in a face that is in no component, or in another one.
  double extent_around(const Sample& s) const
  {
    return extent_around(s.vertex != Graph_traits::null_vertex() ? s.vertex : corner_near(s.location));
  }

  // Returns the distance of two locations, relative to the longest edge of the component of the first one. Both are
  // points of one component.
  double gap(const Face_location& a, const Face_location& b) const
  {
    return relative(m_separation(a, b), extent_around(a.first));
  }

private:
  static constexpr std::size_t no_site() { return Diagram_violation::no_site(); }
  static double infinity() { return std::numeric_limits<double>::infinity(); }

  // Edges at the border are no walls, whatever the user says: nothing changes there.
  bool has_walls() const
  {
    for(const halfedge_descriptor h : halfedges(m_tm))
      if(is_inside(h, m_diagram) && is_inside(opposite(h, m_tm), m_diagram) && m_diagram.avoids_edge(edge(h, m_tm)))
        return true;
    return false;
  }

  // Counts a check of a condition for a site; a violation that is not positive does not count.
  void record(Diagram_condition condition, double violation, std::size_t site)
  {
    m_violations[condition].record(violation, site);
  }

  // --- components ---

  // Components have the index of one of their vertices. Faces to avoid are in none.
  void find_components()
  {
    m_components = Component_extents<double>(num_vertices(m_tm));
    for(const face_descriptor f : faces(m_tm))
    {
      if(m_diagram.avoids_face(f))
        continue;
      std::array<std::size_t, 3> corners{};
      std::size_t k = 0;
      for(const vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, m_tm), m_tm))
        corners[k++] = std::size_t(get(m_vertex_index_map, v));
      m_components.add_face(corners, longest_edge(f, m_tm, m_length));
    }
    m_components.finish();
  }

  // Returns some corner of a face, which tells its component.
  vertex_descriptor corner(face_descriptor f) const { return target(halfedge(f, m_tm), m_tm); }

  // The face of a site at the rim may be one to avoid, which is in no component; the corner that is nearest by its
  // coordinate is at the rim, too.
  vertex_descriptor corner_near(const Face_location& l) const
  {
    halfedge_descriptor h = halfedge(l.first, m_tm), best = h;
    double largest = -1;
    for(std::size_t k = 0; k < 3; ++k, h = next(h, m_tm))
      if(CGAL::to_double(l.second[k]) > largest)
      {
        largest = CGAL::to_double(l.second[k]);
        best = h;
      }
    return source(best, m_tm);
  }

  std::size_t component_of(vertex_descriptor v) const { return m_components.component(get(m_vertex_index_map, v)); }
  std::size_t component_of(face_descriptor f) const { return component_of(corner(f)); }

  // Returns `excess / scale`, but 0 for no excess on a component all of whose edges have length 0. Any positive excess
  // is infinite there.
  static double relative(double excess, double scale) { return excess == 0 ? 0. : excess / scale; }

  // --- distances from one site at a time, where there are walls ---

  // Compares all samples with the distances from each site. One site after the other, as the windows of a propagation
  // take far more memory than the samples. Takes the time of a propagation for each site.
  template <typename MakePaths>
  void check_distances(MakePaths make_paths)
  {
    const Samples samples(m_diagram);
    const double largest_weight = largest_weight_of(m_diagram);
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
      check_distances_from(i, samples, make_paths, largest_weight);
  }

  // A site at a vertex without faces has no location; it is the nearest one of that vertex only, which is not a sample.
  template <typename MakePaths>
  void check_distances_from(std::size_t i, const Samples& samples, MakePaths make_paths, double largest_weight)
  {
    const Face_location site = m_diagram.site(i);
    if(site.first == Graph_traits::null_face())
      return;
    // A new object for each site, whose windows are freed at the end of this function.
    auto paths = make_paths();
    if(m_diagram.site_curve(i) != nullptr)
      paths->add_source_curve(*m_diagram.site_curve(i));
    else
      paths->add_source_point(site);
    paths->build_sequence_tree_for_faces();
    const double weight = CGAL::to_double(m_diagram.weight(i));
    for(const Sample& s : samples.samples())
    {
      const double d = CGAL::to_double(s.vertex != Graph_traits::null_vertex()
                                         ? paths->shortest_distance_to_source_points(s.vertex).first
                                         : paths->shortest_distance_to_source_points(s.location.first,
                                                                                     s.location.second).first);
      check_sample(s, samples, i, d < 0 ? infinity() : d, weight, largest_weight);
    }
  }

  // Compares the distance of a sample from site i, infinity if the site does not reach it, with what the diagram says:
  // it is that of the sample if the diagram names i among the nearest sites, and not smaller otherwise.
  //
  // If the diagram names a site that does not reach the sample, the difference is NaN, which counts as infinite. If it
  // names no site for a point that site i reaches, the violation is infinite, too.
  void check_sample(const Sample& s, const Samples& samples, std::size_t i, double distance, double weight,
                    double largest_weight)
  {
    const auto violation = [&](double difference)
    { return violation_of_distance(difference, distance, extent_around(s), largest_weight); };
    const auto first = samples.sites().begin() + static_cast<std::ptrdiff_t>(s.first_site);
    const auto last = first + static_cast<std::ptrdiff_t>(s.number_of_sites);
    if(std::find(first, last, i) != last)
      record(s.condition, violation(std::abs(distance - weight - s.distance)), i);
    else if(distance < infinity() && *first == no_site())
      record(DIAGRAM_NEAREST, infinity(), i);
    else if(distance < infinity())
      record(DIAGRAM_NEAREST, violation(s.distance - distance + weight), i);
  }

  // --- boundaries ---

  // With each edge or arc: is it run through from its end to its start?
  using Directed_edge = std::pair<typename Diagram::Edge, bool>;
  using Directed_arc = std::pair<typename Diagram::Arc, bool>;

  // How often boundaries run through an edge forward and backward.
  using Uses = std::array<int, 2>;

  // Arcs of an edge meet, edges of a boundary meet, each edge is run through once in each direction, and each arc is in
  // one edge. The counts of uses find an edge that is missing in a boundary, or is in one twice, whatever its place is.
  void check_boundaries()
  {
    std::vector<int> uses_of_arc(m_diagram.arcs().size(), 0);
    for(const auto& e : m_diagram.edges())
      for(const auto& a : e.arcs())
        if(a.first.index() < uses_of_arc.size())
          ++uses_of_arc[a.first.index()];
        else
          record(DIAGRAM_BOUNDARIES, infinity(), e.sites().first);
    for(const int n : uses_of_arc)
      record(DIAGRAM_BOUNDARIES, n == 1 ? 0 : infinity(), no_site());
    for(const auto& e : m_diagram.edges())
      for(std::size_t k = 1; k < e.arcs().size(); ++k)
        record(DIAGRAM_BOUNDARIES, gap(end_of(e.arcs()[k - 1]), start_of(e.arcs()[k])), e.sites().first);
    std::vector<Uses> uses(m_diagram.edges().size(), Uses{0, 0});
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
      for(const auto& b : m_diagram.boundary(i))
        check_boundary(i, b, uses);
    for(const auto& e : m_diagram.edges())
      if(uses[e.index()] != Uses{1, 1})
        record(DIAGRAM_BOUNDARIES, infinity(), e.sites().first);
  }

  // Checks one part of the boundary of the cell of site i, and counts its uses of edges. Requires: the part has an
  // edge.
  template <typename Boundary>
  void check_boundary(std::size_t i, const Boundary& b, std::vector<Uses>& uses)
  {
    for(std::size_t k = 0; k < b.edges.size(); ++k)
    {
      const Directed_edge& e = b.edges[k];
      ++uses[e.first.index()][e.second ? 1 : 0];
      const auto sites = e.first.sites();
      const bool is_on_left = (e.second ? sites.second : sites.first) == i;
      record(DIAGRAM_BOUNDARIES, is_on_left ? 0 : infinity(), i);
      if(k > 0)
        record(DIAGRAM_BOUNDARIES, gap(end_of(b.edges[k - 1]), start_of(e)), i);
    }
    const Face_location first = start_of(b.edges.front()), last = end_of(b.edges.back());
    if(b.is_closed)
      record(DIAGRAM_BOUNDARIES, gap(last, first), i);
    else
      record(DIAGRAM_BOUNDARIES, (std::max)(gap_to_border(first), gap_to_border(last)), i);
  }

  // The start and the end of an arc or an edge, in the direction in which it is run through. An edge that is run
  // through backward starts with its last arc, backward.
  static Face_location start_of(const Directed_arc& a) { return a.first.point(a.second ? 1. : 0.); }
  static Face_location end_of(const Directed_arc& a) { return a.first.point(a.second ? 0. : 1.); }

  static Directed_arc reversed(const Directed_arc& a) { return Directed_arc(a.first, !a.second); }

  static Face_location start_of(const Directed_edge& e)
  {
    return e.second ? start_of(reversed(e.first.arcs().back())) : start_of(e.first.arcs().front());
  }

  static Face_location end_of(const Directed_edge& e)
  {
    return e.second ? end_of(reversed(e.first.arcs().front())) : end_of(e.first.arcs().back());
  }

  // Returns the distance of a location from the border of the mesh, relative to the longest edge.
  double gap_to_border(const Face_location& l) const
  {
    return relative(m_separation.from_border(l), extent_around(l.first));
  }

  // --- areas ---

  // Checks that the areas of the cells of a component add up to that of its faces, if a site reaches it, and that none
  // is negative. A cell is in the component of its site. So a gap or an overlap of cells shows even where no sample
  // lies, unless another one makes up for it.
  //
  // Areas are divided by the square of a power of two near the extent of their component, which changes no digit. What
  // the diagram says is a number of the squared unit of the mesh. It is rounded to a multiple of the least number,
  // which is allowed. It tells nothing if the area is above the largest number or far below the least one.
  void check_areas()
  {
    std::vector<double> expected(num_vertices(m_tm), 0.), sum(expected), rounding(expected);
    for(const face_descriptor f : faces(m_tm))
      if(!m_diagram.avoids_face(f) && extent_around(f) > 0 && is_reached(f))
        expected[component_of(f)] += area(f, power_of_two(extent_around(f)));
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
    {
      const Face_location site = m_diagram.site(i);
      if(site.first == Graph_traits::null_face() || !(extent_around(corner_near(site)) > 0))
        continue;
      const std::size_t c = component_of(corner_near(site));
      // The unit is divided by twice, as its square may overflow or vanish.
      const double unit = power_of_two(m_components.extent(c)), a = CGAL::to_double(m_diagram.area(i)) / unit / unit;
      sum[c] += a;
      rounding[c] += std::numeric_limits<double>::denorm_min() / unit / unit;
      record(DIAGRAM_AREAS, relative_area(-a, expected[c], c), i);
    }
    for(std::size_t c = 0; c < sum.size(); ++c)
      if(m_components.component(c) == c && m_components.extent(c) > 0 && rounding[c] < infinity()
         && is_number(expected[c], power_of_two(m_components.extent(c))))
        record(DIAGRAM_AREAS, relative_area(std::abs(sum[c] - expected[c]) - rounding[c], expected[c], c), no_site());
  }

  // Does a site reach a face? All of the surface that is connected with it is reached then. Without walls, a corner of
  // the face tells; a corner at a wall may be reached on its other side only.
  bool is_reached(face_descriptor f) const
  {
    const auto third = static_cast<typename Diagram::FT>(1. / 3);
    const Face_location middle(f, typename Diagram::Barycentric_coordinates{third, third, third});
    halfedge_descriptor h = halfedge(f, m_tm);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, m_tm))
      if(is_at_wall(h, m_diagram))
        return m_diagram.nearest_site(middle) != no_site();
    return m_diagram.nearest_site(source(h, m_tm)) != no_site();
  }

  // Returns the largest power of two that is not greater than a positive number.
  static double power_of_two(double x) { return std::ldexp(1., std::ilogb(x)); }

  // Returns a difference of areas relative to the expected area plus the square of the extent of component c.
  double relative_area(double difference, double expected, std::size_t c) const
  {
    const double extent = m_components.extent(c) / power_of_two(m_components.extent(c));
    return difference / (expected + extent * extent);
  }

  // Returns whether an area, given in squares of `unit`, is at most the largest number in the squared unit of the mesh.
  static bool is_number(double area, double unit) { return area * unit * unit < infinity(); }

  // Returns the area of a face in squares of `unit`, from its lengths. It is accurate for needles, as the shortest one
  // is the base. Formula: base times height over 2, with the height of planar_triangle_from_lengths(). Requires: unit >
  // 0.
  double area(face_descriptor f, double unit) const
  {
    std::array<double, 3> l = lengths(f);
    for(double& x : l)
      x /= unit;
    std::sort(l.begin(), l.end());
    return l[0] * planar_triangle_from_lengths(l[0], l[1], l[2]).apex_y / 2;
  }

  std::array<double, 3> lengths(face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, m_tm), g = next(h, m_tm);
    return {m_length(h), m_length(g), m_length(next(g, m_tm))};
  }

  const Diagram& m_diagram;
  const Triangle_mesh& m_tm;
  VertexIndexMap m_vertex_index_map;
  Length m_length;
  Separation m_separation;
  Component_extents<double> m_components{0}; // by the index of a vertex
  Diagram_violations m_violations;
};

// `shape` tells where the lengths of edges come from (Face_shapes.h), and threads of `ConcurrencyTag` share the proof.
//
// Certifies a diagram with paths of the type Paths<Traits, ...>, which is Surface_mesh_geodesic_paths with the maps
// among the named parameters. `prepare(paths)` is called for each new object of paths, before sources are added.
//
// Paths is a parameter because this room does not include the public class. Traits and maps have to be those of the
// diagram. An object of paths can neither be copied nor moved, hence the pointers. Throws Invalid_geodesic_input if the
// mesh or a site is invalid.
template <template <typename...> class Paths, typename Traits, typename ConcurrencyTag, typename Diagram,
          typename Length, typename Separation, typename Shape, typename Prepare, typename NamedParameters>
Diagram_violations certify_diagram(const Diagram& diagram, Length length, Separation separation, Shape shape,
                                   Prepare prepare, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto& tm = diagram.triangle_mesh();
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto him = CGAL::get_initialized_halfedge_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, tm));
  using Paths_with_maps = Paths<Traits, decltype(vim), decltype(him), decltype(fim), decltype(vpm)>;
  // The diagram tells which faces and edges it avoids, and nothing else about them: distances around them are computed
  // apart.
  std::vector<typename boost::graph_traits<typename Diagram::Triangle_mesh>::face_descriptor> avoided;
  std::vector<typename boost::graph_traits<typename Diagram::Triangle_mesh>::edge_descriptor> walls;
  for(const auto f : faces(tm))
    if(diagram.avoids_face(f))
      avoided.push_back(f);
  for(const auto e : edges(tm))
    if(diagram.avoids_edge(e))
      walls.push_back(e);
  const auto make_paths = [&]
  {
    auto paths = std::make_unique<Paths_with_maps>(tm, vim, him, fim, vpm);
    paths->avoid_faces(avoided); // before lengths are given
    paths->avoid_edges(walls);
    prepare(*paths);
    return paths;
  };
  using Witness = Site_witness<Diagram, decltype(vim), decltype(fim)>;
  const auto make_witness = [&] { return std::make_unique<Witness>(diagram, vim, fim, shape); };
  return Diagram_certifier<Diagram, decltype(vim), Length, Separation>(diagram, vim, length, separation)
    .run(make_witness, make_paths, typename Chunks_for_tag<typename Available_tag<ConcurrencyTag>::type>::type());
}

// Certifies a diagram of a mesh with points.
template <template <typename...> class Paths, typename Traits, typename ConcurrencyTag, typename Diagram,
          typename NamedParameters>
Diagram_violations certify_diagram_with_points(const Diagram& diagram, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto& tm = diagram.triangle_mesh();
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, tm));
  using Point = typename boost::property_traits<decltype(vpm)>::value_type;
  using halfedge_descriptor = typename boost::graph_traits<typename Diagram::Triangle_mesh>::halfedge_descriptor;
  const auto length = [&](halfedge_descriptor h)
  { return distance_in_space<Point>(get(vpm, source(h, tm)), get(vpm, target(h, tm))); };
  const Separation_in_space<Diagram, decltype(vpm)> separation(diagram, vpm);
  return certify_diagram<Paths, Traits, ConcurrencyTag>(
    diagram, length, separation,
    Shape_from_points<double, typename Diagram::Triangle_mesh, decltype(vpm)>(tm, vpm), [](auto&) {}, np);
}

// Certifies a diagram of a surface that is given by the lengths of its edges.
template <template <typename...> class Paths, typename Traits, typename ConcurrencyTag, typename Diagram,
          typename EdgeLengthMap, typename NamedParameters>
Diagram_violations certify_diagram_with_edge_lengths(const Diagram& diagram, EdgeLengthMap edge_length_map,
                                                     const NamedParameters& np)
{
  using halfedge_descriptor = typename boost::graph_traits<typename Diagram::Triangle_mesh>::halfedge_descriptor;
  const auto& tm = diagram.triangle_mesh();
  const auto length = [&](halfedge_descriptor h) { return CGAL::to_double(get(edge_length_map, edge(h, tm))); };
  const Separation_by_coordinates<Diagram, decltype(length)> separation(diagram, length);
  return certify_diagram<Paths, Traits, ConcurrencyTag>(
    diagram, length, separation,
    Shape_from_edge_lengths<double, typename Diagram::Triangle_mesh, EdgeLengthMap>(tm, edge_length_map),
      [&](auto& paths) { paths.use_edge_lengths(edge_length_map); }, np);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_DIAGRAM_CERTIFIER_H
