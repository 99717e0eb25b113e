// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_SURFACE_MESH_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESICS_SURFACE_MESH_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesics.h>

#include <CGAL/Surface_mesh_geodesics/Geodesic_default_visitor.h>
#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/Surface_mesh_geodesic_paths.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Arc_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Cell_locator.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Path_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Redundant_window_removal.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_cell_measures.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Voronoi_cut_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

namespace Surface_mesh_geodesics {
namespace internal {

// For classes with a member vertices(), which hides those that argument-dependent lookup finds.
template <typename Graph>
auto vertices_of(const Graph& graph)
{
  return vertices(graph);
}

} // namespace internal
} // namespace Surface_mesh_geodesics

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Surface_mesh_geodesic_Voronoi_diagram` represents the geodesic Voronoi diagram of points of a triangle
mesh, the sites: each point of the surface belongs to the cell of the site that is nearest to it, where distances
are lengths of shortest paths on the surface.

The diagram is exact: the curves between cells are not approximated along the edges of the mesh, but computed
inside its faces. An arc is a piece of such a curve in one face, a segment or a piece of a hyperbola. Arcs of
the same two cells, one behind the other, form an edge of the diagram; edges end at vertices of the
diagram, where three cells or more meet, or at the border of the mesh, or are closed.

Distances are propagated from all sites at once, with the algorithm of this package; windows are removed as soon as
it is known that no curve crosses their face \cgalCite{qin2017voronoi}, and faces that curves do cross are cut while
the wavefront moves on. So the memory used is that of the wavefront and of the diagram itself.

<b>Weights.</b> A site may have a weight \f$ w \f$: the distance of a point from it is the geodesic distance less
\f$ w \f$, as in `Apollonius_graph_2`. A site in the cell of another site has an empty cell. Distances are propagated
with the differences from the largest weight, and are exact relative to these: a very large weight in one component
costs digits in the others. Differences have to be finite in `double`, also as multiples of the extent of the mesh.

<b>Ties.</b> Of several sites with the same place and the same weight, the first one has the cell, and the others
are empty. (If the distance of two sites and the difference of their weights are less than about
\f$ 6 \cdot 10^{-14} \f$ of the extent of the mesh together, they may be treated so as well: no distance tells which
of them is nearer.) If two sites are equally far from a vertex at which shortest paths bend, whole regions may be
equally far from both; such a region belongs to one of the two, as decided at that vertex. The curves around it
are then those along which the other site's paths, too, are no longer equally short. Where the diagram is
symmetric, arcs may run along edges and through vertices of the mesh, and more than three cells may meet.

<b>When things are computed.</b> Sites are collected; the diagram is computed by `build()`, or by the first query. Each
function that does so throws what `build()` throws.

<b>Units.</b> Distances, weights and lengths are in the unit of the points, or of the edge lengths, areas in its square.

<b>Thread safety.</b> All member functions that are `const`, and those of `Vertex`, `Arc` and `Edge`, may be called by
several threads at once, also the first time: one of them computes, the others wait. Functions that are not `const` must
not run at the same time as any other one.

<b>Validity.</b> What functions return by reference, and handles, are valid until sites are changed, `clear()`,
`use_edge_lengths()` or `use_points()` is called, or the diagram is destroyed. The mesh must not change in between.

\tparam Traits a model of `SurfaceMeshShortestPathTraits`, with the requirements of `Surface_mesh_geodesic_paths`
\tparam VIM a model of `ReadablePropertyMap` with `vertex_descriptor` as key and `unsigned int` as value type.
        The default is `boost::property_map<Triangle_mesh, boost::vertex_index_t>::%const_type`.
\tparam HIM a model of `ReadablePropertyMap` with `halfedge_descriptor` as key and `unsigned int` as value
        type, not used. The default is
        `boost::property_map<Triangle_mesh, boost::halfedge_index_t>::%const_type`.
\tparam FIM a model of `ReadablePropertyMap` with `face_descriptor` as key and `unsigned int` as value type.
        The default is `boost::property_map<Triangle_mesh, boost::face_index_t>::%const_type`.
\tparam VPM a model of `ReadablePropertyMap` with `vertex_descriptor` as key and `Traits::Point_3` as value
        type. The default is `boost::property_map<Triangle_mesh, CGAL::vertex_point_t>::%const_type`.

\sa `Surface_mesh_geodesic_paths`
*/
template <typename Traits, typename VIM = Default, typename HIM = Default, typename FIM = Default,
          typename VPM = Default>
class Surface_mesh_geodesic_Voronoi_diagram
{
  using Paths = Surface_mesh_geodesic_paths<Traits, VIM, HIM, FIM, VPM>;

public:
  /// \name Types
  /// @{

  /// the triangle mesh type.
  using Triangle_mesh = typename Traits::Triangle_mesh;

  /// the graph traits of the triangle mesh.
  using Graph_traits = boost::graph_traits<Triangle_mesh>;

  /// the vertex descriptor type.
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;

  /// the halfedge descriptor type.
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;

  /// the face descriptor type.
  using face_descriptor = typename Graph_traits::face_descriptor;

#ifndef DOXYGEN_RUNNING
  using Vertex_index_map = typename Paths::Vertex_index_map;
  using Halfedge_index_map = typename Paths::Halfedge_index_map;
  using Face_index_map = typename Paths::Face_index_map;
  using Vertex_point_map = typename Paths::Vertex_point_map;
#else
  /// the vertex index map.
  using Vertex_index_map = VIM;

  /// the halfedge index map.
  using Halfedge_index_map = HIM;

  /// the face index map.
  using Face_index_map = FIM;

  /// the vertex point map.
  using Vertex_point_map = VPM;
#endif

  /// the number type of the traits.
  using FT = typename Traits::FT;

  /// the point type of the traits.
  using Point_3 = typename Traits::Point_3;

  /// an ordered triple of barycentric coordinates.
  using Barycentric_coordinates = typename Traits::Barycentric_coordinates;

  /// a point of a face, as in `Surface_mesh_geodesic_paths`.
  using Face_location = std::pair<face_descriptor, Barycentric_coordinates>;

  /// the number of a site: 0 for the one that was added first.
  using Site_index = std::size_t;

  /// @}

  /// returns the number that stands for "no site", and for "no vertex" of the diagram: the largest `std::size_t`.
  static constexpr std::size_t null_site() { return (std::numeric_limits<std::size_t>::max)(); }

private:
  using Complex = Surface_mesh_geodesics::internal::Voronoi_complex<double>;
  using Removal = Surface_mesh_geodesics::internal::Redundant_window_removal<double, Complex>;
  using Chain = Surface_mesh_geodesics::internal::Voronoi_chain;
  using Internal_arc = Surface_mesh_geodesics::internal::Voronoi_arc<double>;
  using Curve = Surface_mesh_geodesics::internal::Arc_curve;
  using Planar = Surface_mesh_geodesics::internal::Planar_point<double>;
  using Solver
    = Surface_mesh_geodesics::internal::Path_solver<Triangle_mesh, Vertex_index_map, Face_index_map>;
  using Measures = Surface_mesh_geodesics::internal::Voronoi_cell_measures;
  using Vertex_id = Surface_mesh_geodesics::internal::Vertex_id;

public:
  /*!
  A vertex of the diagram: a point with the same distance from three nearest sites or more. Like `Arc` and `Edge`
  it is a small handle, valid until the diagram is destroyed or its sites are changed. All functions take constant time.
  */
  class Vertex
  {
  public:
    /// constructs a handle of no vertex, which can be assigned to and compared, and nothing else.
    Vertex() = default;

    /// returns whether two handles refer to the same vertex of the same diagram.
    friend bool operator==(const Vertex& a, const Vertex& b)
    {
      return a.m_diagram == b.m_diagram && a.m_index == b.m_index;
    }
    /// returns whether they do not.
    friend bool operator!=(const Vertex& a, const Vertex& b) { return !(a == b); }

    /// returns the place of the vertex.
    Face_location location() const { return m_diagram->location_of_node(node()); }

    /// returns the point of the vertex.
    Point_3 point() const { return m_diagram->point(location()); }

    /// returns the sites whose cells meet here, in ascending order: three, or more in symmetric diagrams.
    const std::vector<Site_index>& sites() const { return m_diagram->m_vertex_sites[m_index]; }

    /// returns the distance from the sites, less their weights, in the unit of the mesh.
    FT distance() const { return m_diagram->user_distance(m_diagram->m_complex.nodes()[node()].distance); }

    /// returns the number of the vertex: its position in `Surface_mesh_geodesic_Voronoi_diagram::vertices()`.
    std::size_t index() const { return m_index; }

  private:
    friend class Surface_mesh_geodesic_Voronoi_diagram;
    Vertex(const Surface_mesh_geodesic_Voronoi_diagram* d, std::size_t i) : m_diagram(d), m_index(i) {}

    std::size_t node() const { return m_diagram->m_node_of_vertex[m_index]; }

    const Surface_mesh_geodesic_Voronoi_diagram* m_diagram = nullptr;
    std::size_t m_index = 0;
  };

  /*!
  An arc of the diagram: a piece of the curve between two cells in one face, along which the same image of
  each of the two sites is the nearest one. All functions but `sample()` take constant time (that of `length()` depends
  on the shape of the arc, as it is the time of a quadrature).
  */
  class Arc
  {
  public:
    /// constructs a handle of no arc, which can be assigned to and compared, and nothing else.
    Arc() = default;

    /// returns whether two handles refer to the same arc of the same diagram.
    friend bool operator==(const Arc& a, const Arc& b)
    {
      return a.m_diagram == b.m_diagram && a.m_index == b.m_index;
    }
    /// returns whether they do not.
    friend bool operator!=(const Arc& a, const Arc& b) { return !(a == b); }

    /// returns the face of the mesh that holds the arc.
    face_descriptor face() const { return m_diagram->m_solver.user_face(arc().face); }

    /// returns the two sites: the one whose cell is on the left of the arc (as seen from outside), and the other.
    std::pair<Site_index, Site_index> sites() const
    {
      return {m_diagram->m_solver.source_at(arc().left_site), m_diagram->m_solver.source_at(arc().right_site)};
    }

    /// returns the location at the parameter `t`. Points are not evenly spaced in general.
    ///
    /// \param t where the point is: 0 for the beginning of the arc, 1 for its end
    /// \pre `0 <= t` and `t <= 1`. (A smaller number is taken for 0, a larger one for 1.)
    Face_location point(double t) const
    {
      return m_diagram->location_in(arc().face, Curve(arc()).point(t));
    }

    /// returns the distance of the two sites from `point(t)`, less their weights, in the unit of the mesh.
    ///
    /// \param t where the point is, as for `point()`
    /// \pre `0 <= t` and `t <= 1`. (A smaller number is taken for 0, a larger one for 1.)
    FT distance(double t) const
    {
      return m_diagram->user_distance(arc().left.distance_to(Curve(arc()).point(t)));
    }

    /// returns whether the arc is a segment; else it is a piece of a hyperbola.
    bool is_segment() const { return Curve(arc()).is_segment(); }

    /// returns the length, in the unit of the mesh, with an error of about \f$ 10^{-13} \f$ of it.
    FT length() const { return FT(m_diagram->m_solver.unit() * Curve(arc()).length()); }

    /// writes the locations of points from `point(0)` to `point(1)` to an output iterator; the segments between
    /// them are not farther from the arc than `tolerance`. Takes time linear in the number of points.
    ///
    /// \tparam OutputIterator a model of `OutputIterator` that takes `Face_location`
    /// \param tolerance the largest distance, in the unit of the mesh
    /// \param output gets the locations, two for a segment. No interval of a piece of a hyperbola is halved more than
    ///        24 times.
    /// \return the output iterator past the last location
    /// \pre `tolerance > 0`
    template <typename OutputIterator>
    OutputIterator sample(double tolerance, OutputIterator output) const
    {
      CGAL_precondition_msg(tolerance > 0, "the tolerance is not positive");
      const auto face = arc().face;
      *output++ = m_diagram->location_in(face, arc().first);
      Curve(arc()).sample(tolerance / m_diagram->m_solver.unit(), [&](const Planar& p)
      { *output++ = m_diagram->location_in(face, p); });
      return output;
    }

    /// returns the number of the vertex of the diagram at the beginning, or `null_site()` if there is none.
    std::size_t source_vertex() const { return m_diagram->vertex_at(arc().first_node); }

    /// returns the number of the vertex of the diagram at the end, or `null_site()`.
    std::size_t target_vertex() const { return m_diagram->vertex_at(arc().last_node); }

    /// returns the number of the arc: its position in `Surface_mesh_geodesic_Voronoi_diagram::arcs()`.
    std::size_t index() const { return m_index; }

  private:
    friend class Surface_mesh_geodesic_Voronoi_diagram;
    Arc(const Surface_mesh_geodesic_Voronoi_diagram* d, std::size_t i) : m_diagram(d), m_index(i) {}

    const Internal_arc& arc() const { return m_diagram->m_complex.arcs()[m_diagram->m_arc_ids[m_index]]; }

    const Surface_mesh_geodesic_Voronoi_diagram* m_diagram = nullptr;
    std::size_t m_index = 0;
  };

  /*!
  An edge of the diagram: the arcs of two cells from one vertex of the diagram to the next one or to the border of
  the mesh, or all around. All functions but `length()` and `polyline()` take constant time.
  */
  class Edge
  {
  public:
    /// constructs a handle of no edge, which can be assigned to and compared, and nothing else.
    Edge() = default;

    /// returns whether two handles refer to the same edge of the same diagram.
    friend bool operator==(const Edge& a, const Edge& b)
    {
      return a.m_diagram == b.m_diagram && a.m_index == b.m_index;
    }
    /// returns whether they do not.
    friend bool operator!=(const Edge& a, const Edge& b) { return !(a == b); }

    /// returns the two sites: the one whose cell is on the left of the edge, and the other.
    std::pair<Site_index, Site_index> sites() const
    {
      return {m_diagram->m_solver.source_at(chain().left_site),
              m_diagram->m_solver.source_at(chain().right_site)};
    }

    /// returns the arcs from the beginning to the end, and whether each is run through from its end to its beginning.
    /// The reference is valid as long as the edge.
    const std::vector<std::pair<Arc, bool>>& arcs() const { return m_diagram->m_edge_arcs[m_index]; }

    /// returns the number of the vertex of the diagram at the beginning, or `null_site()` if the edge is closed or
    /// begins at the border of the mesh.
    std::size_t source_vertex() const
    {
      return is_closed() ? null_site() : m_diagram->vertex_at(chain().first_node);
    }

    /// returns the number of the vertex of the diagram at the end, or `null_site()`.
    std::size_t target_vertex() const
    {
      return is_closed() ? null_site() : m_diagram->vertex_at(chain().last_node);
    }

    /// returns whether the edge has no ends.
    bool is_closed() const { return chain().is_closed; }

    /// returns the length, in the unit of the mesh. Takes time linear in the number of arcs.
    FT length() const
    {
      FT sum = 0;
      for(const std::pair<Arc, bool>& a : arcs())
        sum += a.first.length();
      return sum;
    }

    /// writes the points of a polyline along the edge to an output iterator; a closed edge ends with its first point.
    /// Takes time linear in the number of points.
    ///
    /// \tparam OutputIterator a model of `OutputIterator` that takes `Point_3`
    /// \param tolerance the largest distance of the polyline from the arcs, in the unit of the mesh, as for
    ///        `Arc::sample()`
    /// \param output gets the points
    /// \return the output iterator past the last point
    /// \pre `tolerance > 0`
    template <typename OutputIterator>
    OutputIterator polyline(double tolerance, OutputIterator output) const
    {
      std::vector<Face_location> locations;
      bool is_first = true;
      for(const std::pair<Arc, bool>& a : arcs())
      {
        locations.clear();
        a.first.sample(tolerance, std::back_inserter(locations));
        if(a.second)
          std::reverse(locations.begin(), locations.end());
        for(std::size_t i = is_first ? 0 : 1; i < locations.size(); ++i)
          *output++ = m_diagram->point(locations[i]);
        is_first = false;
      }
      return output;
    }

    /// returns the number of the edge: its position in `Surface_mesh_geodesic_Voronoi_diagram::edges()`.
    std::size_t index() const { return m_index; }

  private:
    friend class Surface_mesh_geodesic_Voronoi_diagram;
    Edge(const Surface_mesh_geodesic_Voronoi_diagram* d, std::size_t i) : m_diagram(d), m_index(i) {}

    const Chain& chain() const { return m_diagram->m_complex.chains()[m_diagram->m_chain_ids[m_index]]; }

    const Surface_mesh_geodesic_Voronoi_diagram* m_diagram = nullptr;
    std::size_t m_index = 0;
  };

  /// A part of the boundary of a cell: edges one behind the other, with the cell on their left. It is valid as long as
  /// its edges.
  struct Boundary
  {
    /// the edges, and whether each is run through from its end to its beginning.
    std::vector<std::pair<Edge, bool>> edges;

    /// whether the last edge ends where the first one begins; else both ends are at the border of the mesh.
    bool is_closed;
  };

  /// \name Constructors
  /// They take constant time. Diagrams can neither be copied nor moved.
  /// @{

  /// creates the diagram of no sites on a mesh, with the index maps and the point map of the mesh.
  ///
  /// \param tm the mesh, which is referred to, not copied, and must not change before `clear()`
  /// \param traits an instance of the traits class, which is copied
  /// \pre The faces of `tm` are triangles. (`build()` throws otherwise.)
  explicit Surface_mesh_geodesic_Voronoi_diagram(const Triangle_mesh& tm, const Traits& traits = Traits())
    : Surface_mesh_geodesic_Voronoi_diagram(tm, get(boost::vertex_index, tm), get(boost::halfedge_index, tm),
                                            get(boost::face_index, tm), get(CGAL::vertex_point, tm), traits)
  {}

  /// creates the diagram of no sites on a mesh, with the maps given.
  ///
  /// \param tm the mesh, which is referred to, not copied, and must not change before `clear()`
  /// \param vertex_index_map gives each vertex an index from 0 to `num_vertices(tm) - 1`
  /// \param halfedge_index_map is not used
  /// \param face_index_map gives each face an index from 0 to `num_faces(tm) - 1`
  /// \param vertex_point_map gives the point of each vertex
  /// \param traits an instance of the traits class, which is copied
  /// \pre The faces of `tm` are triangles. (`build()` throws otherwise.)
  Surface_mesh_geodesic_Voronoi_diagram(const Triangle_mesh& tm, Vertex_index_map vertex_index_map,
                                        Halfedge_index_map halfedge_index_map, Face_index_map face_index_map,
                                        Vertex_point_map vertex_point_map, const Traits& traits = Traits())
    : m_traits(traits), m_tm(tm), m_vertex_index_map(vertex_index_map), m_face_index_map(face_index_map),
      m_vertex_point_map(vertex_point_map), m_solver(tm, vertex_index_map, face_index_map)
  {
    static_cast<void>(halfedge_index_map);
    use_points();
  }

  Surface_mesh_geodesic_Voronoi_diagram(const Surface_mesh_geodesic_Voronoi_diagram&) = delete;
  Surface_mesh_geodesic_Voronoi_diagram& operator=(const Surface_mesh_geodesic_Voronoi_diagram&) = delete;

  /// @}

  /// \name Sites
  /// Changes forget the diagram; it is computed again when it is needed. Adding a site takes constant time.
  /// @{

  /// adds a vertex as a site. Whether it is one of the mesh is checked by `build()`.
  ///
  /// \param v a vertex of the mesh
  /// \param weight its weight, in the unit of the mesh; it may be negative
  /// \return the number of the site
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the weight is not finite
  Site_index add_site(vertex_descriptor v, const FT& weight = FT(0))
  {
    return insert(Site{true, v, Face_location(), finite(weight)});
  }

  /// adds a point of a face as a site. Whether it is one is checked by `build()`.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \param weight its weight, in the unit of the mesh; it may be negative
  /// \return the number of the site
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the weight is not finite
  Site_index add_site(const Face_location& location, const FT& weight = FT(0))
  {
    return insert(Site{false, Graph_traits::null_vertex(), location, finite(weight)});
  }

  /// adds all elements of a range as sites, with the weight 0.
  ///
  /// \tparam Sites a range of `vertex_descriptor` or `Face_location`
  /// \param sites the sites
  /// \return the number of the first one that was added, `number_of_sites()` if the range is empty; the others follow
  template <typename Sites>
  Site_index add_sites(const Sites& sites)
  {
    const Site_index first = m_sites.size();
    for(const auto& s : sites)
      add_site(s);
    return first;
  }

  /// removes all sites, and forgets all that was computed. To be called if the mesh has changed.
  void clear()
  {
    m_sites.clear();
    forget_mesh();
  }

  /// removes all sites, and keeps what has been read of the mesh: for other sites on the same mesh, without the time to
  /// read it once more. Iterators and descriptors of the diagram become invalid. Takes time linear in what had been
  /// computed.
  /// \pre The mesh, its points and its lengths have not changed since they were read; call `clear()` otherwise.
  void remove_all_sites()
  {
    m_sites.clear();
    forget_diagram();
  }

  /// takes the lengths of the edges from a map instead of from points. They are used until the next call of
  /// `use_points()`, and read and checked when the mesh is read, by `build()`. Sites are kept. Takes constant time.
  ///
  /// \tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edge descriptor as key type and a number
  ///         type as value type
  /// \param edge_length_map gives the length of each edge, as for
  ///        `Surface_mesh_geodesics::geodesic_distances_from_edge_lengths()`; it is copied
  template <typename EdgeLengthMap>
  void use_edge_lengths(EdgeLengthMap edge_length_map)
  {
    m_build_mesh = [this, edge_length_map](Solver& solver)
    {
      solver.build_mesh(
        Surface_mesh_geodesics::internal::Shape_from_edge_lengths<double, Triangle_mesh, EdgeLengthMap>(
          m_tm, edge_length_map));
    };
    forget_mesh();
  }

  /// takes the lengths of the edges from the points of the vertices, as it is done unless they are given. Sites are
  /// kept.
  void use_points()
  {
    m_build_mesh = [this](Solver& solver)
    {
      solver.build_mesh(
        Surface_mesh_geodesics::internal::Shape_from_points<double, Triangle_mesh, Vertex_point_map>(
          m_tm, m_vertex_point_map));
    };
    forget_mesh();
  }

  /// returns the number of sites.
  std::size_t number_of_sites() const { return m_sites.size(); }

  /// returns the place of a site, in a face around it if it is a vertex; the face is the null face for a vertex without
  /// faces, and for what is no vertex of the mesh.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  Face_location site(Site_index i) const
  {
    CGAL_precondition_msg(i < m_sites.size(), "there is no site with this number");
    const Site& s = m_sites[i];
    if(!s.is_vertex)
      return s.location;
    // (What is no vertex is refused by build(), which need not have been called.)
    return Surface_mesh_geodesics::internal::is_vertex_of(s.vertex, m_tm, m_vertex_index_map)
             ? Paths::face_location(s.vertex, m_tm, m_traits)
             : Face_location(Graph_traits::null_face(), coordinates({0., 0., 0.}));
  }

  /// returns the weight of a site, in the unit of the mesh.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  FT weight(Site_index i) const
  {
    CGAL_precondition_msg(i < m_sites.size(), "there is no site with this number");
    return m_sites[i].weight;
  }

  /// @}

  /// \name Building
  /// @{

  /// computes the diagram, if that has not been done since sites were changed.
  ///
  /// Takes the time of a propagation from all sites, in the worst case \cgalBigO{n^2} for \f$ n \f$ vertices, and for
  /// each face that curves cross time polynomial in the number of windows on its edges; in practice both together are a
  /// small multiple of the time of the distances (\ref Surface_mesh_geodesics_performance). The memory is that of the
  /// mesh, of the windows near the wavefront, and of the arcs (\cgalCite{qin2017voronoi}; thesis, chapter 5). The mesh
  /// is read by the first call only.
  ///
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a site is invalid; this holds for each
  ///         function that builds. Nothing has been computed then; sites stay as they are.
  /// \throws std::bad_alloc if there is not enough memory
  void build() const
  {
    Surface_mesh_geodesics::Geodesic_default_visitor visitor;
    build(visitor);
  }

  /// does the same and tells a visitor of the progress of the propagation, which is most of the work. The visitor is
  /// not called if the diagram has been computed before.
  ///
  /// \tparam Visitor a model of `GeodesicPropagationVisitor`
  /// \param visitor the visitor, called by this thread. It must not use the diagram. Distances that it is told are less
  ///        the largest weight.
  /// \return `true`, or `false` if the visitor cancelled the propagation: nothing has been computed then
  ///
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a site is invalid, and what the visitor
  ///         throws; nothing has been computed then
  template <typename Visitor>
  bool build(Visitor& visitor) const
  {
    if(m_is_built.load(std::memory_order_acquire))
      return true;
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_is_built.load(std::memory_order_relaxed))
      return true;
    if(!propagate_for_diagram(visitor))
      return false;
    collect();
    m_is_built.store(true, std::memory_order_release);
    return true;
  }

  /// returns whether the diagram has been computed for the sites as they are.
  bool is_built() const { return m_is_built.load(std::memory_order_acquire); }

  /// returns what the propagation did. The diagram is computed if that has not been done.
  const Surface_mesh_geodesics::Propagation_statistics& statistics() const
  {
    build();
    return m_statistics;
  }

  /// returns how many windows were kept for the diagram at most at a time, and how many would have been kept without
  /// the removal of redundant windows. The diagram is computed if that has not been done.
  std::pair<std::size_t, std::size_t> number_of_kept_windows() const
  {
    build();
    return m_kept_windows;
  }

  /// @}

  /// \name Queries
  /// The diagram is computed if that has not been done. A vertex, a face or a location that is not in the mesh throws
  /// `Surface_mesh_geodesics::Invalid_geodesic_input`, unless there are no sites: then nothing is checked, and the
  /// answer is that for a point that no site reaches.
  /// @{

  /// returns the site whose cell holds a vertex. Takes constant time.
  ///
  /// \param v a vertex of the mesh
  /// \return the number of the site, or `null_site()` if no site reaches `v`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v` is not a vertex of the mesh (null, removed, or with
  ///         an index out of range) and there is a site
  Site_index nearest_site(vertex_descriptor v) const
  {
    build();
    if(m_sites.empty())
      return null_site();
    return site_at(m_complex.owner(m_solver.query(v).vertex));
  }

  /// returns the site whose cell holds a point of a face. Takes time linear in the number of arcs in the face if these
  /// are few, as is usual; in the worst case quadratic.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \return the number of the site, any of the nearest ones if there are several, or `null_site()` if no site reaches
  ///         the point
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `f` is not a face of the mesh, or the point is not in
  ///         it, and there is a site
  Site_index nearest_site(face_descriptor f, const Barycentric_coordinates& location) const
  {
    build();
    if(m_sites.empty())
      return null_site();
    const typename Solver::Query q = m_solver.query(f, weights(location));
    if(q.vertex != Surface_mesh_geodesics::internal::null_id)
      return site_at(m_complex.owner(q.vertex));
    const auto corner = m_complex.layout(q.face);
    Planar p;
    for(unsigned int k = 0; k < 3; ++k)
    {
      p.x += q.coordinates[k] * corner[k].x;
      p.y += q.coordinates[k] * corner[k].y;
    }
    return site_at(Surface_mesh_geodesics::internal::Cell_locator<double>(m_complex, q.face, p).cell());
  }

  /// does the same.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \return the number of the site, or `null_site()`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input as above
  Site_index nearest_site(const Face_location& location) const
  {
    return nearest_site(location.first, location.second);
  }

  /// returns the distance of a vertex from its nearest site, less the weight of that. Takes constant time.
  ///
  /// \param v a vertex of the mesh
  /// \return the distance, in the unit of the mesh, or -1 if no site reaches `v`. (With positive weights a distance may
  ///         be negative, too; ask `nearest_site()` then.)
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v` is not a vertex of the mesh and there is a site
  FT distance_to_nearest_site(vertex_descriptor v) const
  {
    build();
    if(m_sites.empty())
      return FT(-1);
    return user_distance(m_solver.arrival(m_solver.query(v)));
  }

  /// returns the distance of a point of a face from its nearest site, less the weight of that. The first call for a
  /// point that is not a vertex propagates once more and keeps all windows, as those that the diagram does not need
  /// have been removed; each takes time linear in the number of windows on the edges of the face.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \return the distance, in the unit of the mesh, or -1 if no site reaches the point
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `f` is not a face of the mesh, or the point is not in
  ///         it, and there is a site
  FT distance_to_nearest_site(face_descriptor f, const Barycentric_coordinates& location) const
  {
    build();
    if(m_sites.empty())
      return FT(-1);
    const typename Solver::Query q = m_solver.query(f, weights(location));
    if(!m_solver.needs_windows(q))
      return user_distance(m_solver.arrival(q));
    keep_windows();
    return user_distance(m_solver.arrival(q));
  }

  /// does the same.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \return the distance, in the unit of the mesh, or -1
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input as above
  FT distance_to_nearest_site(const Face_location& location) const
  {
    return distance_to_nearest_site(location.first, location.second);
  }

  /// @}

  /// \name Elements of the Diagram
  /// The diagram is computed if that has not been done. References are valid until it is forgotten. Ranges of elements
  /// take constant time; their order is not specified (a mesh of another size may have another one).
  /// @{

  /// returns the vertices of the diagram.
  const std::vector<Vertex>& vertices() const
  {
    build();
    return m_vertices;
  }

  /// returns the edges of the diagram.
  const std::vector<Edge>& edges() const
  {
    build();
    return m_edges;
  }

  /// returns the arcs of the diagram.
  const std::vector<Arc>& arcs() const
  {
    build();
    return m_arcs;
  }

  /// returns the arcs in a face. Takes time proportional to the logarithm of the number of arcs, and to the number
  /// of those returned.
  ///
  /// \param f a face of the mesh
  /// \pre `f` is a face of the mesh (this is not checked).
  std::vector<Arc> arcs(face_descriptor f) const
  {
    build();
    std::vector<Arc> result;
    const std::size_t key = static_cast<std::size_t>(get(m_face_index_map, f));
    auto it = std::lower_bound(m_arcs_by_face.begin(), m_arcs_by_face.end(), Arcs_of_face{key, 0, 0});
    for(; it != m_arcs_by_face.end() && it->face_index == key; ++it)
      result.insert(result.end(), m_arcs.begin() + it->first, m_arcs.begin() + it->last);
    return result;
  }

  /// returns the arcs around the cell of a site, in the order of `boundary()`. Takes time proportional to their number.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  std::vector<Arc> arcs(Site_index i) const
  {
    std::vector<Arc> result;
    for(const Boundary& b : boundary(i))
      for(const std::pair<Edge, bool>& e : b.edges)
        for(const std::pair<Arc, bool>& a : e.first.arcs())
          result.push_back(a.first);
    return result;
  }

  /// @}

  /// \name Cells
  /// The diagram is computed if that has not been done. Where nothing else is said, functions take time linear in the
  /// number of edges around the cell.
  /// @{

  /// returns whether no point is nearest to the site: another one has the same place, or nearly, or hides it by its
  /// weight. Takes constant time.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  bool is_empty(Site_index i) const
  {
    build();
    check(i);
    return !has_cell(i);
  }

  /// returns the sites whose cells have an edge with that of site `i`, in ascending order. Takes \cgalBigO{k \log k}
  /// time for \f$ k \f$ edges around the cell.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  std::vector<Site_index> adjacent_sites(Site_index i) const
  {
    build();
    check(i);
    std::vector<Site_index> result;
    for(const Boundary& b : boundary(i))
      for(const std::pair<Edge, bool>& e : b.edges)
      {
        const std::pair<Site_index, Site_index> s = e.first.sites();
        result.push_back(e.second ? s.first : s.second);
      }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// returns the edges around the cell, with the cell on the left. What the border of the mesh adds to the boundary is
  /// left out: parts that it interrupts are not closed.
  ///
  /// \param i the number of the site
  /// \return the parts, in no particular order; none for an empty cell, and for one that is a whole component
  /// \pre `i < number_of_sites()`
  std::vector<Boundary> boundary(Site_index i) const
  {
    build();
    check(i);
    std::vector<Boundary> result;
    if(!has_cell(i))
      return result;
    for(const auto& loop : m_complex.boundary(m_solver.source_vertex(i)))
    {
      Boundary b;
      b.is_closed = loop.is_closed;
      for(const std::pair<std::uint32_t, bool>& c : loop.chains)
        if(m_edge_of_chain[c.first] != null_site())
          b.edges.emplace_back(m_edges[m_edge_of_chain[c.first]], c.second);
      if(!b.edges.empty())
        result.push_back(b);
    }
    return result;
  }

  /// returns the area of the cell, in the square of the unit of the mesh; 0 if it is empty. The first call of this
  /// function, or of `centroid()`, measures all cells, in time linear in the size of the mesh and of the diagram; after
  /// that, it takes constant time.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  FT area(Site_index i) const
  {
    check(i);
    const double u = unit();
    return FT(measures().area(cell_vertex(i)) * u * u);
  }

  /// returns the mean of the points of the cell, which need not be on the surface; the site if the cell is empty or
  /// has no area. The time is that of `area()`.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  Point_3 centroid(Site_index i) const
  {
    check(i);
    const std::array<double, 3> c = measures().centroid(cell_vertex(i));
    return std::isfinite(c[0]) ? Point_3(c[0], c[1], c[2]) : point_of_site(i);
  }

  /// returns the vertex of the mesh, among those in the cell, that is nearest in space to the centroid of the cell; the
  /// null vertex if there is none; the first one in the order of `vertices(tm)` if several are equally near. Takes time
  /// linear in the number of vertices of the mesh.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  vertex_descriptor central_vertex(Site_index i) const
  {
    const Point_3 c = centroid(i);
    vertex_descriptor best = Graph_traits::null_vertex();
    double best_distance = std::numeric_limits<double>::infinity();
    for(vertex_descriptor v : Surface_mesh_geodesics::internal::vertices_of(m_tm))
      if(nearest_site(v) == i)
      {
        const double d
          = Surface_mesh_geodesics::internal::distance_in_space<Point_3>(c, get(m_vertex_point_map, v));
        if(d < best_distance)
        {
          best = v;
          best_distance = d;
        }
      }
    return best;
  }

  /// returns the Euler characteristic of the cell with its boundary; 0 if it is empty. The boundary is taken as a
  /// curve that does not touch itself; but a vertex at which the mesh is pinched counts once.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  int Euler_characteristic(Site_index i) const
  {
    build();
    check(i);
    return has_cell(i) ? m_complex.Euler_characteristic(m_solver.source_vertex(i)) : 0;
  }

  /// returns whether the cell is a topological disk, as its Euler characteristic is 1; `false` if it is empty. (A cell
  /// with a vertex at which the mesh is pinched, and one that is a vertex without faces, may have 1, too.)
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  bool is_disk(Site_index i) const { return Euler_characteristic(i) == 1; }

  /// writes the triangles of the dual, as `std::array<Site_index, 3>`, to an output iterator: one for each vertex of
  /// the diagram with three cells, `n - 2` for one with `n` cells, oriented like the faces of the mesh. They need not
  /// form a manifold: cells that are not disks, or that have several edges or none in common, make others of it. Takes
  /// time linear in the number of arcs.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `std::array<Site_index, 3>`
  /// \param output gets the triangles
  /// \return the output iterator past the last triangle
  template <typename OutputIterator>
  OutputIterator dual(OutputIterator output) const
  {
    build();
    for(const auto& node : m_complex.nodes())
      if(node.is_vertex())
        *output++ = std::array<Site_index, 3>{site_at(node.sites[0]), site_at(node.sites[1]),
                                              site_at(node.sites[2])};
    return output;
  }

  /*!
  adds the mesh, cut along the arcs, to a mesh: each face lies in one cell.

  Faces are cut into triangles. Vertices and edges of the mesh are kept, edges divided where arcs cross them; the two
  faces at an edge share the new vertices, so the output has a border only where the mesh has one, and the
  Euler characteristic of the mesh. Arcs that end at a vertex of the mesh, up to rounding, end at that vertex of the
  output, and arcs along an edge of the mesh are that edge. Sites inside faces and on edges become vertices. Pieces of
  hyperbolas become polylines. Where several curves in a face are nearer to each other than the tolerance,
  they are approximated more closely, so that they do not cross.

  The vertices of the mesh come first in the output, in an unspecified order.

  \tparam OutputMesh a model of `MutableFaceGraph` with an internal property for `CGAL::vertex_point_t`, unless a map
          is given
  \tparam FaceSiteMap a model of `WritablePropertyMap` with the face descriptor of `OutputMesh` as key type and
          `Site_index` as value type; values are put for the faces that are added
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param output the mesh to which the faces are added
  \param face_site_map gets the site of each face, `null_site()` for faces that no site reaches
  \param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh; the smaller, the more
         faces
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below

  \cgalNamedParamsBegin
    \cgalParamNBegin{vertex_point_map}
      \cgalParamDescription{a property map associating points to the vertices of `output`}
      \cgalParamType{a class model of `WritablePropertyMap` with the vertex descriptor of `OutputMesh` as key type and
                     a type that is constructible from three coordinates of type `double` as value type}
      \cgalParamDefault{`boost::get(CGAL::vertex_point, output)`}
    \cgalParamNEnd
  \cgalNamedParamsEnd

  \pre `tolerance > 0`

  \throws Surface_mesh_geodesics::Invalid_geodesic_input if the diagram has to be computed, and the mesh or a site is
          invalid. Nothing has been added then.

  Takes time linear in the size of the mesh and of the diagram; in a face with many arcs or samples, the time grows with
  the cube of the number of vertices around a piece of a cell.
  */
  template <typename OutputMesh, typename FaceSiteMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  void cut(OutputMesh& output, FaceSiteMap face_site_map, double tolerance,
           const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    using Surface_mesh_geodesics::internal::Face_id;
    using parameters::choose_parameter;
    using parameters::get_parameter;
    CGAL_precondition_msg(tolerance > 0, "the tolerance is not positive");
    build();
    auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                get_property_map(CGAL::vertex_point, output));
    using Output_point = typename boost::property_traits<decltype(vpm)>::value_type;
    const auto output_point = [](const Point_3& p)
    { return Output_point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())); };
    const auto point_in_face = [&](Face_id f, const Planar& p) { return output_point(point(location_in(f, p))); };
    Surface_mesh_geodesics::internal::Voronoi_cut_mesh<OutputMesh, decltype(vpm)> cut_mesh(
      m_solver.mesh(), m_complex, output, vpm);
    cut_mesh.build(
      tolerance / m_solver.unit(), [&](Vertex_id v) { return output_point(point_of_vertex(v)); }, point_in_face,
      [&](const typename boost::graph_traits<OutputMesh>::face_descriptor& f, Vertex_id s)
      { put(face_site_map, f, site_at(s)); });
  }

  /// @}

  /// \name Points
  /// They come from the point map, also where the lengths come from a map of their own.
  /// @{

  /// returns the point at a location. Takes constant time.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \pre The face is one of the mesh (this is not checked).
  Point_3 point(const Face_location& location) const
  {
    return Paths::point(location.first, location.second, m_tm, m_vertex_point_map, m_traits);
  }

  /// returns the mesh.
  const Triangle_mesh& triangle_mesh() const { return m_tm; }

  /// @}

private:
  struct Site
  {
    bool is_vertex; // or a location
    vertex_descriptor vertex;
    Face_location location;
    FT weight;
  };

  // Arcs that follow each other in a face. (A face with sites in it may have several.)
  struct Arcs_of_face
  {
    std::size_t face_index;
    std::ptrdiff_t first, last;

    bool operator<(const Arcs_of_face& other) const
    {
      return face_index != other.face_index ? face_index < other.face_index : first < other.first;
    }
  };

  Site_index insert(const Site& s)
  {
    m_sites.push_back(s);
    forget_diagram();
    return m_sites.size() - 1;
  }

  static void check_offset(double offset, std::size_t i)
  {
    using Surface_mesh_geodesics::Invalid_geodesic_input;
    if(!std::isfinite(offset))
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                   "the weight of site " + std::to_string(i) + " is too far from the largest one", i);
  }

  FT finite(const FT& weight) const
  {
    using Surface_mesh_geodesics::Invalid_geodesic_input;
    if(!std::isfinite(CGAL::to_double(weight)))
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::INVALID_OFFSET,
                                   "the weight of site " + std::to_string(m_sites.size()) + " is not finite",
                                   m_sites.size());
    return weight;
  }

  void forget_mesh()
  {
    m_solver.forget();
    m_statistics = Surface_mesh_geodesics::Propagation_statistics();
    forget_diagram();
  }

  // (Nothing is done for each of the sites that are added to a diagram that is not built: emptying tables takes time
  // that depends on their size of old.)
  void forget_diagram()
  {
    m_has_windows = false;
    if(!m_is_built)
      return;
    m_is_built = false;
    m_has_measures = false;
    m_complex.clear();
    m_vertices.clear();
    m_arcs.clear();
    m_edges.clear();
  }

  // 0 without sites.
  double largest_weight() const
  {
    double largest = m_sites.empty() ? 0. : CGAL::to_double(m_sites.front().weight);
    for(const Site& s : m_sites)
      largest = (std::max)(largest, CGAL::to_double(s.weight));
    return largest;
  }

  // Gives the mesh, unless it is known, and the sites to a solver. Requires: the largest weight is set.
  void prepare(Solver& solver) const
  {
    if(!solver.has_mesh())
      m_build_mesh(solver);
    solver.begin_sources();
    std::size_t i = 0;
    for(const Site& s : m_sites)
    {
      const double offset = m_largest_weight - CGAL::to_double(s.weight);
      check_offset(offset / solver.unit(), i++);
      if(s.is_vertex)
        solver.add_source(s.vertex, offset);
      else
        solver.add_source_location(std::make_pair(s.location.first, weights(s.location.second)), offset);
    }
  }

  // returns false if the visitor cancels.
  template <typename Visitor>
  bool propagate_for_diagram(Visitor& visitor) const
  {
    m_largest_weight = largest_weight();
    prepare(m_solver);
    Removal removal;
    const auto start = [&]
    {
      removal.reset(m_solver.mesh(), m_solver.field(), m_complex);
      m_solver.for_each_equal_source([&](Vertex_id v, Vertex_id first) { removal.unite(v, first); });
      m_complex.start(m_solver.mesh());
      return Surface_mesh_geodesics::internal::Redundant_window_remover<Removal>(removal);
    };
    const bool is_complete = Surface_mesh_geodesics::internal::run_with_visitor(visitor, num_vertices(m_tm), [&](auto go_on)
    {
      return m_solver.run_with_keeper(start, [&](std::size_t number_of_visits, double reached)
      { return go_on(number_of_visits, reached - m_largest_weight); });
    });
    if(!is_complete)
    {
      m_complex.clear();
      return false;
    }
    removal.finish();
    m_complex.finish(removal.owners());
    m_statistics = m_solver.statistics();
    m_kept_windows = {removal.windows().maximum_size(), removal.number_of_kept_windows()};
    return true;
  }

  // makes the elements that users see of those of the complex, without what has no length.
  void collect() const
  {
    const auto& arcs = m_complex.arcs();
    const auto& chains = m_complex.chains();
    m_arcs.clear();
    m_arc_ids.clear();
    m_arcs_by_face.clear();
    m_edges.clear();
    m_edge_arcs.clear();
    m_chain_ids.clear();
    m_edge_of_chain.assign(chains.size(), null_site());
    std::vector<std::size_t> arc_of(arcs.size(), null_site());
    for(std::size_t a = 0; a < arcs.size(); ++a)
      if(m_complex.has_length(arcs[a]))
      {
        arc_of[a] = m_arcs.size();
        if(m_arcs.empty() || arcs[a].face != arcs[m_arc_ids.back()].face)
          m_arcs_by_face.push_back(
            Arcs_of_face{static_cast<std::size_t>(get(m_face_index_map, m_solver.user_face(arcs[a].face))),
                         static_cast<std::ptrdiff_t>(m_arcs.size()), 0});
        m_arcs.push_back(Arc(this, m_arcs.size()));
        m_arcs_by_face.back().last = static_cast<std::ptrdiff_t>(m_arcs.size());
        m_arc_ids.push_back(a);
      }
    std::sort(m_arcs_by_face.begin(), m_arcs_by_face.end());
    for(std::size_t c = 0; c < chains.size(); ++c)
    {
      if(!chains[c].has_length)
        continue;
      m_edge_of_chain[c] = m_edges.size();
      m_edges.push_back(Edge(this, m_edges.size()));
      m_chain_ids.push_back(c);
      m_edge_arcs.emplace_back();
      for(const std::pair<std::uint32_t, bool>& a : chains[c].arcs)
        if(arc_of[a.first] != null_site())
          m_edge_arcs.back().emplace_back(m_arcs[arc_of[a.first]], a.second);
    }
    collect_vertices();
  }

  // Vertices with nothing but chains without length between them are one.
  void collect_vertices() const
  {
    const auto& nodes = m_complex.nodes();
    std::vector<std::size_t> rank(nodes.size()), parent(nodes.size());
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    for(std::size_t n = 0; n < nodes.size(); ++n)
      sets.make_set(n);
    for(const Chain& c : m_complex.chains())
      if(!c.has_length && nodes[c.first_node].is_vertex() && nodes[c.last_node].is_vertex())
        sets.union_set(c.first_node, c.last_node);
    m_vertices.clear();
    m_node_of_vertex.clear();
    m_vertex_sites.clear();
    m_vertex_of_node.assign(nodes.size(), null_site());
    for(std::size_t n = 0; n < nodes.size(); ++n)
    {
      if(!nodes[n].is_vertex())
        continue;
      std::size_t& v = m_vertex_of_node[sets.find_set(n)];
      if(v == null_site())
      {
        v = m_vertices.size();
        m_vertices.push_back(Vertex(this, v));
        m_node_of_vertex.push_back(n);
        m_vertex_sites.emplace_back();
      }
      for(Vertex_id s : nodes[n].sites)
        m_vertex_sites[v].push_back(site_at(s));
      m_vertex_of_node[n] = v;
    }
    for(std::vector<Site_index>& s : m_vertex_sites)
    {
      std::sort(s.begin(), s.end());
      s.erase(std::unique(s.begin(), s.end()), s.end());
    }
  }

  // Makes the solver know the windows: repeats its run on the same mesh with the same sites. Requires: is_built().
  void keep_windows() const
  {
    if(m_has_windows.load(std::memory_order_acquire))
      return;
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_has_windows.load(std::memory_order_relaxed))
      return;
    m_solver.add_windows([](std::size_t, double) { return true; });
    m_has_windows.store(true, std::memory_order_release);
  }

  const Measures& measures() const
  {
    build();
    if(!m_has_measures.load(std::memory_order_acquire))
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if(!m_has_measures.load(std::memory_order_relaxed))
      {
        measure();
        m_has_measures.store(true, std::memory_order_release);
      }
    }
    return m_measures;
  }

  void measure() const
  {
    using Surface_mesh_geodesics::internal::Face_id;
    m_measures.clear();
    const std::size_t n = m_sites.empty() ? 0 : m_solver.mesh().number_of_faces();
    for(Face_id f = 0; f < n; ++f)
    {
      std::array<std::array<double, 3>, 3> corner;
      for(unsigned int k = 0; k < 3; ++k)
      {
        std::array<double, 3> b{};
        b[k] = 1;
        const auto l = m_solver.user_location(f, b);
        const Point_3 p = point(Face_location(l.first, coordinates(l.second)));
        corner[k] = {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
      }
      m_measures.add_face(m_complex, f, corner);
    }
  }

  double unit() const
  {
    build();
    return m_sites.empty() ? 1. : m_solver.unit();
  }

  Vertex_id cell_vertex(Site_index i) const
  {
    build();
    return has_cell(i) ? m_solver.source_vertex(i) : Surface_mesh_geodesics::internal::null_id;
  }

  void check(Site_index i) const
  {
    CGAL_precondition_msg(i < m_sites.size(), "there is no site with this number");
    static_cast<void>(i);
  }

  bool has_cell(Site_index i) const
  {
    const Vertex_id v = m_solver.source_vertex(i);
    return m_complex.owner(v) == v && m_solver.source_at(v) == i;
  }

  Site_index site_at(Vertex_id v) const
  {
    return v == Surface_mesh_geodesics::internal::null_id ? null_site() : m_solver.source_at(v);
  }

  std::size_t vertex_at(std::size_t node) const { return m_vertex_of_node[node]; }

  FT user_distance(double d) const { return FT(d * m_solver.unit() - m_largest_weight); }

  FT user_distance(const typename Solver::Arrival& a) const
  {
    return a.root == Surface_mesh_geodesics::internal::null_id ? FT(-1) : user_distance(a.distance);
  }

  Face_location location_in(Surface_mesh_geodesics::internal::Face_id f, const Planar& p) const
  {
    const auto l = m_solver.user_location(f, m_complex.coordinates(f, p));
    return Face_location(l.first, coordinates(l.second));
  }

  Face_location location_of_node(std::size_t node) const
  {
    const auto& n = m_complex.nodes()[node];
    return location_in(n.face, n.point);
  }

  // the point of a vertex of the mesh with the sites.
  Point_3 point_of_vertex(Vertex_id v) const
  {
    const vertex_descriptor user = m_solver.user_vertex(v);
    return user != Graph_traits::null_vertex() ? Point_3(get(m_vertex_point_map, user))
                                               : point(site(m_solver.source_at(v)));
  }

  // also of a vertex that is in no face.
  Point_3 point_of_site(Site_index i) const
  {
    const Site& s = m_sites[i];
    return s.is_vertex ? Point_3(get(m_vertex_point_map, s.vertex)) : point(s.location);
  }

  std::array<double, 3> weights(const Barycentric_coordinates& location) const
  {
    auto weight = m_traits.construct_barycentric_coordinates_weight_object();
    return {CGAL::to_double(weight(location, 0)), CGAL::to_double(weight(location, 1)),
            CGAL::to_double(weight(location, 2))};
  }

  Barycentric_coordinates coordinates(const std::array<double, 3>& b) const
  {
    return m_traits.construct_barycentric_coordinates_object()(FT(b[0]), FT(b[1]), FT(b[2]));
  }

  const Traits m_traits;
  const Triangle_mesh& m_tm;
  Vertex_index_map m_vertex_index_map;
  Face_index_map m_face_index_map;
  Vertex_point_map m_vertex_point_map;
  std::vector<Site> m_sites;
  std::function<void(Solver&)> m_build_mesh;

  // What is computed on demand, guarded by the mutex.
  mutable std::mutex m_mutex;
  mutable std::atomic<bool> m_is_built{false}, m_has_measures{false}, m_has_windows{false};
  mutable Solver m_solver;
  mutable Complex m_complex;
  mutable double m_largest_weight = 0;
  mutable std::pair<std::size_t, std::size_t> m_kept_windows;
  // Of the propagation for the diagram; that of the solver also counts the one that keeps the windows.
  mutable Surface_mesh_geodesics::Propagation_statistics m_statistics;
  mutable Measures m_measures;
  mutable std::vector<Vertex> m_vertices;
  mutable std::vector<std::size_t> m_node_of_vertex, m_vertex_of_node;
  mutable std::vector<std::vector<Site_index>> m_vertex_sites;
  mutable std::vector<Arc> m_arcs;
  mutable std::vector<std::size_t> m_arc_ids;                          // in the complex
  mutable std::vector<Arcs_of_face> m_arcs_by_face;                    // sorted
  mutable std::vector<Edge> m_edges;
  mutable std::vector<std::size_t> m_chain_ids, m_edge_of_chain;       // in the complex
  mutable std::vector<std::vector<std::pair<Arc, bool>>> m_edge_arcs;
};

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_SURFACE_MESH_GEODESIC_VORONOI_DIAGRAM_H
