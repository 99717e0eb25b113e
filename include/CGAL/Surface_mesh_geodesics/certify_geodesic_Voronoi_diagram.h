// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_Voronoi_certificate.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

namespace internal {

// Checks a diagram by what its members tell, against distances from one site at a time. `Paths` computes these;
// `length(h)` is the length of a halfedge, `separation(a, b)` is how far two locations are apart, and
// `separation.from_border(a)` how far a location is from the border.
template <typename Diagram, typename Paths, typename VertexIndexMap, typename Length, typename Separation>
class Voronoi_certifier
{
  using Triangle_mesh = typename Diagram::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Face_location = typename Diagram::Face_location;
  using Certificate = Geodesic_Voronoi_certificate;
  using Condition = Certificate::Condition;

public:
  Voronoi_certifier(const Diagram& diagram, VertexIndexMap vertex_index_map, Length length, Separation separation)
    : m_diagram(diagram), m_tm(diagram.triangle_mesh()), m_vertex_index_map(vertex_index_map), m_length(length),
      m_separation(separation)
  {}

  // make_paths() makes an object of shortest paths without sources, behind a pointer.
  template <typename MakePaths>
  Certificate run(MakePaths make_paths)
  {
    m_certificate = Certificate();
    find_components();
    if(m_diagram.number_of_sites() == 0)
      return m_certificate;
    collect_samples();
    m_largest_weight = 0;
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
      m_largest_weight = (std::max)(m_largest_weight, std::abs(CGAL::to_double(m_diagram.weight(i))));
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
      check_distances_from(i, make_paths);
    check_boundaries();
    check_areas();
    return m_certificate;
  }

private:
  // A point of the surface, and what the diagram tells of it: the sites that are nearest, and their distance less
  // their weights.
  struct Sample
  {
    vertex_descriptor vertex; // the null vertex for a location
    Face_location location;
    std::size_t first_site, number_of_sites; // in m_sites
    double distance;
    Condition condition;
  };

  static constexpr std::size_t null_site() { return Certificate::null_site(); }
  static double infinity() { return std::numeric_limits<double>::infinity(); }

  // --- components ---

  // What lengths are relative to is the longest edge of a component, as the others may be far larger. A component has
  // the index of one of its vertices.
  void find_components()
  {
    const std::size_t n = num_vertices(m_tm);
    m_component.resize(n);
    std::vector<std::size_t> rank(n);
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), m_component.data());
    for(std::size_t v = 0; v < n; ++v)
      sets.make_set(v);
    for(const face_descriptor f : faces(m_tm))
      for(const vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, m_tm), m_tm))
        sets.union_set(std::size_t(get(m_vertex_index_map, corner(f))), std::size_t(get(m_vertex_index_map, v)));
    sets.compress_sets(boost::counting_iterator<std::size_t>(0), boost::counting_iterator<std::size_t>(n));
    m_longest_edge.assign(n, 0.);
    for(const face_descriptor f : faces(m_tm))
    {
      double& longest = m_longest_edge[component_of(f)];
      longest = (std::max)(longest, longest_edge(f));
    }
  }

  vertex_descriptor corner(face_descriptor f) const { return target(halfedge(f, m_tm), m_tm); }

  std::size_t component_of(vertex_descriptor v) const { return m_component[get(m_vertex_index_map, v)]; }
  std::size_t component_of(face_descriptor f) const { return component_of(corner(f)); }

  double extent_around(vertex_descriptor v) const { return m_longest_edge[component_of(v)]; }
  double extent_around(face_descriptor f) const { return extent_around(corner(f)); }

  // (A component may have no lengths.)
  static double relative(double excess, double scale) { return excess == 0 ? 0. : excess / scale; }

  // --- samples ---

  void collect_samples()
  {
    for(const auto& arc : m_diagram.arcs())
      for(const double t : {0., 0.125, 0.375, 0.5, 0.625, 0.875, 1.})
        add_sample(arc.point(t), {arc.sites().first, arc.sites().second}, CGAL::to_double(arc.distance(t)),
                   Condition::ARCS);
    for(const auto& v : m_diagram.vertices())
      add_sample(v.location(), v.sites(), CGAL::to_double(v.distance()), Condition::VERTICES);
    for(const vertex_descriptor v : vertices(m_tm))
      if(!is_isolated(v))
      {
        add_sample(Face_location(), {m_diagram.nearest_site(v)},
                   CGAL::to_double(m_diagram.distance_to_nearest_site(v)), Condition::OWNERS);
        m_samples.back().vertex = v;
      }
    for(const face_descriptor f : faces(m_tm))
      add_samples_in_face(f);
  }

  // One point in a face that arcs do not cross, and more in one that they do, all at different places.
  void add_samples_in_face(face_descriptor f)
  {
    const std::size_t number = m_diagram.arcs(f).empty() ? 1 : 8;
    for(std::size_t i = 0; i < number; ++i)
    {
      // A sequence that fills the unit square evenly (multiples of the powers of 0.7548..., the inverse of the
      // real root of x^3 = x + 1), folded to the triangle.
      m_sequence[0] = std::fmod(m_sequence[0] + 0.7548776662466927, 1.);
      m_sequence[1] = std::fmod(m_sequence[1] + 0.5698402909980532, 1.);
      double x = m_sequence[0], y = m_sequence[1];
      if(x + y > 1)
      {
        x = 1 - x;
        y = 1 - y;
      }
      const Face_location l(f, typename Diagram::Barycentric_coordinates{1 - x - y, x, y});
      const double d = CGAL::to_double(m_diagram.distance_to_nearest_site(l));
      add_sample(l, {m_diagram.nearest_site(l)}, d, Condition::OWNERS);
    }
  }

  void add_sample(const Face_location& l, const std::vector<std::size_t>& sites, double distance, Condition condition)
  {
    m_samples.push_back({Graph_traits::null_vertex(), l, m_sites.size(), sites.size(), distance, condition});
    m_sites.insert(m_sites.end(), sites.begin(), sites.end());
  }

  // (a vertex may have edges, but no faces)
  bool is_isolated(vertex_descriptor v) const
  {
    if(CGAL::halfedges_around_target(v, m_tm).empty())
      return true;
    for(const halfedge_descriptor h : CGAL::halfedges_around_target(v, m_tm))
      if(!is_border(h, m_tm))
        return false;
    return true;
  }

  // --- distances ---

  // A site that is at a vertex without faces has no place; it is nearest to nothing else.
  template <typename MakePaths>
  void check_distances_from(std::size_t i, MakePaths make_paths)
  {
    const Face_location site = m_diagram.site(i);
    if(site.first == Graph_traits::null_face())
      return;
    auto paths = make_paths();
    paths->add_source_point(site);
    paths->build_sequence_tree_for_faces();
    const double weight = CGAL::to_double(m_diagram.weight(i));
    for(const Sample& s : m_samples)
    {
      const double d = CGAL::to_double(s.vertex != Graph_traits::null_vertex()
                                         ? paths->shortest_distance_to_source_points(s.vertex).first
                                         : paths->shortest_distance_to_source_points(s.location.first,
                                                                                     s.location.second).first);
      check_sample(s, i, d < 0 ? infinity() : d, weight);
    }
  }

  // In a component that is small beside the weights, differences of distances and weights are rounded more than
  // lengths.
  void check_sample(const Sample& s, std::size_t i, double distance, double weight)
  {
    const double rounding = Tolerance<double>::gap() * (distance + m_largest_weight);
    const double scale = distance + (s.vertex != Graph_traits::null_vertex() ? extent_around(s.vertex)
                                                                            : extent_around(s.location.first));
    const auto first = m_sites.begin() + static_cast<std::ptrdiff_t>(s.first_site);
    const auto last = first + static_cast<std::ptrdiff_t>(s.number_of_sites);
    if(std::find(first, last, i) != last)
      m_certificate.look_at(s.condition, relative(std::abs(distance - weight - s.distance) - rounding, scale), i);
    else if(distance < infinity() && *first == null_site())
      m_certificate.look_at(Condition::NEAREST, infinity(), i);
    else if(distance < infinity())
      m_certificate.look_at(Condition::NEAREST, relative(s.distance - distance + weight - rounding, scale), i);
  }

  // --- boundaries ---

  using Directed_edge = std::pair<typename Diagram::Edge, bool>;
  using Directed_arc = std::pair<typename Diagram::Arc, bool>;

  void check_boundaries()
  {
    for(const auto& e : m_diagram.edges())
      for(std::size_t k = 1; k < e.arcs().size(); ++k)
        m_certificate.look_at(Condition::BOUNDARIES, gap(end_of(e.arcs()[k - 1]), start_of(e.arcs()[k])),
                              e.sites().first);
    std::vector<std::array<int, 2>> uses(m_diagram.edges().size(), std::array<int, 2>{0, 0});
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
      for(const auto& b : m_diagram.boundary(i))
        check_boundary(i, b, uses);
    for(const auto& e : m_diagram.edges())
      if(uses[e.index()] != std::array<int, 2>{1, 1})
        m_certificate.look_at(Condition::BOUNDARIES, infinity(), e.sites().first);
  }

  // A boundary of the cell of a site; counts how many times it uses the sides of edges.
  template <typename Boundary>
  void check_boundary(std::size_t i, const Boundary& b, std::vector<std::array<int, 2>>& uses)
  {
    for(std::size_t k = 0; k < b.edges.size(); ++k)
    {
      const Directed_edge& e = b.edges[k];
      ++uses[e.first.index()][e.second ? 1 : 0];
      const auto sites = e.first.sites();
      const bool is_on_left = (e.second ? sites.second : sites.first) == i;
      m_certificate.look_at(Condition::BOUNDARIES, is_on_left ? 0 : infinity(), i);
      if(k > 0)
        m_certificate.look_at(Condition::BOUNDARIES, gap(end_of(b.edges[k - 1]), start_of(e)), i);
    }
    const Face_location first = start_of(b.edges.front()), last = end_of(b.edges.back());
    if(b.is_closed)
      m_certificate.look_at(Condition::BOUNDARIES, gap(last, first), i);
    else
      m_certificate.look_at(Condition::BOUNDARIES, (std::max)(gap_to_border(first), gap_to_border(last)), i);
  }

  static Face_location start_of(const Directed_arc& a) { return a.first.point(a.second ? 1. : 0.); }
  static Face_location end_of(const Directed_arc& a) { return a.first.point(a.second ? 0. : 1.); }

  static Directed_arc turned(const Directed_arc& a) { return Directed_arc(a.first, !a.second); }

  static Face_location start_of(const Directed_edge& e)
  {
    return e.second ? start_of(turned(e.first.arcs().back())) : start_of(e.first.arcs().front());
  }

  static Face_location end_of(const Directed_edge& e)
  {
    return e.second ? end_of(turned(e.first.arcs().front())) : end_of(e.first.arcs().back());
  }

  // how far two locations are apart, relative to the longest edge.
  double gap(const Face_location& a, const Face_location& b) const
  {
    return relative(m_separation(a, b), extent_around(a.first));
  }

  // how far a location is from the border of the mesh, relative to the longest edge.
  double gap_to_border(const Face_location& l) const
  {
    return relative(m_separation.from_border(l), extent_around(l.first));
  }

  // --- areas ---

  // A cell is in the component of its site.
  void check_areas()
  {
    std::vector<double> expected(m_longest_edge.size(), 0.), sum(expected);
    for(const face_descriptor f : faces(m_tm))
      if(m_diagram.nearest_site(source(halfedge(f, m_tm), m_tm)) != null_site())
        expected[component_of(f)] += area(f);
    const auto scale = [&](std::size_t c) { return expected[c] + m_longest_edge[c] * m_longest_edge[c]; };
    for(std::size_t i = 0; i < m_diagram.number_of_sites(); ++i)
    {
      const face_descriptor f = m_diagram.site(i).first;
      if(f == Graph_traits::null_face())
        continue;
      const double a = CGAL::to_double(m_diagram.area(i));
      sum[component_of(f)] += a;
      m_certificate.look_at(Condition::AREAS, relative(-a, scale(component_of(f))), i);
    }
    for(std::size_t c = 0; c < sum.size(); ++c)
      if(m_longest_edge[c] > 0)
        m_certificate.look_at(Condition::AREAS, relative(std::abs(sum[c] - expected[c]), scale(c)), null_site());
  }

  double area(face_descriptor f) const
  {
    std::array<double, 3> l = lengths(f);
    std::sort(l.begin(), l.end());
    return l[0] * planar_triangle_from_lengths(l[0], l[1], l[2]).apex_y / 2;
  }

  std::array<double, 3> lengths(face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, m_tm), g = next(h, m_tm);
    return {m_length(h), m_length(g), m_length(next(g, m_tm))};
  }

  double longest_edge(face_descriptor f) const
  {
    const std::array<double, 3> l = lengths(f);
    return *std::max_element(l.begin(), l.end());
  }

  const Diagram& m_diagram;
  const Triangle_mesh& m_tm;
  VertexIndexMap m_vertex_index_map;
  Length m_length;
  Separation m_separation;
  std::vector<std::size_t> m_component; // by the index of a vertex
  std::vector<double> m_longest_edge;   // by component
  double m_largest_weight = 0;
  std::array<double, 2> m_sequence{{0.5, 0.5}};
  std::vector<Sample> m_samples;
  std::vector<std::size_t> m_sites; // of the samples
  Certificate m_certificate;
};

// How far locations are apart in space, and from the border of the mesh.
template <typename Diagram, typename VertexPointMap>
class Separation_in_space
{
  using Face_location = typename Diagram::Face_location;
  using Vector = std::array<double, 3>;

public:
  Separation_in_space(const Diagram& diagram, VertexPointMap vpm) : m_diagram(diagram)
  {
    const auto& tm = diagram.triangle_mesh();
    for(const auto h : halfedges(tm))
      if(is_border(h, tm))
        m_border.push_back({vector(get(vpm, source(h, tm))), vector(get(vpm, target(h, tm)))});
  }

  double operator()(const Face_location& a, const Face_location& b) const
  {
    const Vector p = vector(m_diagram.point(a)), q = vector(m_diagram.point(b));
    return (std::max)(norm(difference(p, q)) - rounding_of(p, q), 0.);
  }

  // Takes time linear in the number of border edges.
  double from_border(const Face_location& l) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    const Vector p = vector(m_diagram.point(l));
    for(const std::array<Vector, 2>& edge : m_border)
    {
      const Vector along = difference(edge[1], edge[0]), to_p = difference(p, edge[0]);
      const double square = product(along, along);
      const double t = square > 0 ? (std::min)((std::max)(product(along, to_p) / square, 0.), 1.) : 0.;
      const double d = norm(difference(to_p, {t * along[0], t * along[1], t * along[2]}));
      smallest = (std::min)(smallest, (std::max)(d - rounding_of(p, edge[0]), 0.));
    }
    return smallest;
  }

private:
  template <typename Point>
  static Vector vector(const Point& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  // Far from the origin, two locations of a point have coordinates that differ in their last digits: each coordinate is
  // a sum of three products.
  static double rounding_of(const Vector& a, const Vector& b)
  {
    return 8 * std::numeric_limits<double>::epsilon() * (std::max)(norm(a), norm(b));
  }

  static Vector difference(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static double norm(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

  const Diagram& m_diagram;
  std::vector<std::array<Vector, 2>> m_border;
};

// The same on a surface that has no points: upper bounds, from the coordinates that belong to the same vertex.
template <typename Diagram, typename Length>
class Separation_by_coordinates
{
  using Face_location = typename Diagram::Face_location;
  using Triangle_mesh = typename Diagram::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using Corners = std::array<typename Graph_traits::vertex_descriptor, 3>;

public:
  Separation_by_coordinates(const Diagram& diagram, Length length) : m_tm(diagram.triangle_mesh()), m_length(length) {}

  double operator()(const Face_location& a, const Face_location& b) const
  {
    const Corners of_a = corners(a.first), of_b = corners(b.first);
    double sum = 0;
    for(std::size_t k = 0; k < 3; ++k)
      sum += std::abs(CGAL::to_double(a.second[k]) - coordinate(b, of_b, of_a[k]))
           + std::abs(CGAL::to_double(b.second[k]) - coordinate(a, of_a, of_b[k]));
    return sum * (std::max)(longest_edge(a.first), longest_edge(b.first));
  }

  double from_border(const Face_location& l) const
  {
    double smallest = std::numeric_limits<double>::infinity();
    auto h = halfedge(l.first, m_tm);
    for(std::size_t k = 0; k < 3; ++k, h = next(h, m_tm))
    {
      if(is_border(opposite(h, m_tm), m_tm))
        smallest = (std::min)(smallest, std::abs(CGAL::to_double(l.second[(k + 2) % 3])));
      for(const auto g : CGAL::halfedges_around_source(h, m_tm))
        if(is_border(g, m_tm))
          smallest = (std::min)(smallest, std::abs(1 - CGAL::to_double(l.second[k])));
    }
    return smallest * longest_edge(l.first);
  }

private:
  Corners corners(typename Graph_traits::face_descriptor f) const
  {
    const auto h = halfedge(f, m_tm);
    return {source(h, m_tm), target(h, m_tm), target(next(h, m_tm), m_tm)};
  }

  static double coordinate(const Face_location& l, const Corners& of_l, typename Graph_traits::vertex_descriptor v)
  {
    double sum = 0; // (a vertex may be several corners of a face)
    for(std::size_t k = 0; k < 3; ++k)
      sum += of_l[k] == v ? CGAL::to_double(l.second[k]) : 0.;
    return sum;
  }

  double longest_edge(typename Graph_traits::face_descriptor f) const
  {
    const auto h = halfedge(f, m_tm), g = next(h, m_tm);
    return (std::max)(m_length(h), (std::max)(m_length(g), m_length(next(g, m_tm))));
  }

  const Triangle_mesh& m_tm;
  Length m_length;
};

// Both functions: `length` tells the length of a halfedge, `separation` how far two locations are apart, and `prepare`
// sets the lengths of an object of shortest paths.
template <typename Traits, typename Diagram, typename Length, typename Separation, typename Prepare,
          typename NamedParameters>
Geodesic_Voronoi_certificate certify_Voronoi_diagram(const Diagram& diagram, Length length, Separation separation,
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
  using Paths = Surface_mesh_geodesic_paths<Traits, decltype(vim), decltype(him), decltype(fim), decltype(vpm)>;
  const auto make_paths = [&]
  {
    auto paths = std::make_unique<Paths>(tm, vim, him, fim, vpm);
    prepare(*paths);
    return paths;
  };
  return Voronoi_certifier<Diagram, Paths, decltype(vim), Length, Separation>(diagram, vim, length, separation)
    .run(make_paths);
}

} // namespace internal

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks a geodesic Voronoi diagram.

The distances from each site are computed with `Surface_mesh_geodesic_paths`, from one site at a time, and compared with
what the diagram tells:

- that points of its arcs, and its vertices, are equally far from their sites, and how far;
- that no other site is nearer to any of them;
- which site is nearest to each vertex of the mesh and to points of all faces, one in each face and eight in those that
  arcs cross;
- that the boundaries of cells hang together, that they are closed or end at the border of the mesh, that cells
  are on the left of them, and that each edge has one cell on each side;
- that areas are not negative, and that their sum is the area of the mesh, or of its components that have a site.

Distances are checked at these points, not between them; see \ref Surface_mesh_geodesics_certification for what this
proves.

Takes the time of a propagation that keeps its windows for each site, and of a query for each site and each point; the
memory is that of one propagation, beside the diagram. The diagram is computed first if that has not been done.

<b>Thread safety.</b> The function may be called by several threads at once, on the same diagram as well; see
`geodesic_distances()`.

\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param diagram the diagram
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{a property map associating points to the vertices of the mesh, that of the diagram}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of the mesh as key type and
                   the point type of the traits as value type}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tm)`}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_index_map}
    \cgalParamDescription{a property map associating to each vertex of the mesh a unique index between `0`
                          and `num_vertices(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the vertex descriptor of the mesh
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{face_index_map}
    \cgalParamDescription{a property map associating to each face of the mesh a unique index between `0`
                          and `num_faces(tm) - 1`}
    \cgalParamType{a class model of `ReadablePropertyMap` with the face descriptor of the mesh
                   as key type and `std::size_t` as value type}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
  \cgalParamNBegin{halfedge_index_map}
    \cgalParamDescription{is not read}
    \cgalParamType{as for the diagram}
    \cgalParamDefault{an automatically indexed internal map}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return what has been found. A wrong diagram is no reason to throw.

\throws Invalid_geodesic_input if the mesh or a site is invalid
*/
template <typename Traits, typename VIM, typename HIM, typename FIM, typename VPM,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_Voronoi_certificate
certify_geodesic_Voronoi_diagram(const Surface_mesh_geodesic_Voronoi_diagram<Traits, VIM, HIM, FIM, VPM>& diagram,
                                 const CGAL_NP_CLASS& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using halfedge_descriptor = typename boost::graph_traits<typename Traits::Triangle_mesh>::halfedge_descriptor;
  const auto& tm = diagram.triangle_mesh();
  auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                              get_const_property_map(CGAL::vertex_point, tm));
  using Point = typename boost::property_traits<decltype(vpm)>::value_type;
  const auto length = [&](halfedge_descriptor h)
  { return internal::distance_in_space<Point>(get(vpm, source(h, tm)), get(vpm, target(h, tm))); };
  using Diagram = Surface_mesh_geodesic_Voronoi_diagram<Traits, VIM, HIM, FIM, VPM>;
  const internal::Separation_in_space<Diagram, decltype(vpm)> separation(diagram, vpm);
  return internal::certify_Voronoi_diagram<Traits>(diagram, length, separation, [](auto&) {}, np);
}

/*!
\ingroup PkgSurfaceMeshGeodesicsFunctions

checks a geodesic Voronoi diagram that uses the lengths of edges instead of points. All else is as for the function
above.

\tparam EdgeLengthMap see `geodesic_distances_from_edge_lengths()`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param diagram the diagram
\param edge_length_map the lengths, those of the diagram
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as above

\return what has been found

\throws Invalid_geodesic_input if the mesh, a length or a site is invalid
*/
template <typename Traits, typename VIM, typename HIM, typename FIM, typename VPM, typename EdgeLengthMap,
          typename CGAL_NP_TEMPLATE_PARAMETERS>
Geodesic_Voronoi_certificate certify_geodesic_Voronoi_diagram_from_edge_lengths(
  const Surface_mesh_geodesic_Voronoi_diagram<Traits, VIM, HIM, FIM, VPM>& diagram, EdgeLengthMap edge_length_map,
  const CGAL_NP_CLASS& np = parameters::default_values())
{
  using halfedge_descriptor = typename boost::graph_traits<typename Traits::Triangle_mesh>::halfedge_descriptor;
  const auto& tm = diagram.triangle_mesh();
  const auto length = [&](halfedge_descriptor h) { return CGAL::to_double(get(edge_length_map, edge(h, tm))); };
  using Diagram = Surface_mesh_geodesic_Voronoi_diagram<Traits, VIM, HIM, FIM, VPM>;
  const internal::Separation_by_coordinates<Diagram, decltype(length)> separation(diagram, length);
  return internal::certify_Voronoi_diagram<Traits>(
    diagram, length, separation, [&](auto& paths) { paths.use_edge_lengths(edge_length_map); }, np);
}

} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_CERTIFY_GEODESIC_VORONOI_DIAGRAM_H
