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
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Arc_curve.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/curves/curve_segments.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Boundary_polylines.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Cell_energy.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Cell_topology.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Lazy_Voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Voronoi_cell_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Voronoi_cut_mesh.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Voronoi_handles.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/measure_cells.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/distance_in_space.h>

#include <CGAL/Default.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicsClasses

The class `Surface_mesh_geodesic_Voronoi_diagram` represents the geodesic Voronoi diagram of points and curves on a
triangle mesh, the sites. Each point of the surface belongs to the cell of the site that is nearest to it, where the
distance of two points is the length of a shortest path on the surface.

The diagram is exact: the curves between cells are computed inside the faces of the mesh; they are not approximated
along its edges. An <em>arc</em> is the piece of such a curve in one face; it is a segment, a piece of a hyperbola, or,
with curves among the sites, a piece of a parabola.
Consecutive arcs between the same two cells form an <em>edge</em> of the diagram. An edge ends at a <em>vertex</em> of
the diagram, where three or more cells meet, or at the border of the mesh, or it is closed.

Distances are propagated from all sites at once, with the algorithm of this package. A window is removed as soon as it
is known that no curve crosses its face \cgalCite{qin2017voronoi}, and faces that curves cross are cut while the
wavefront moves on (thesis, chapter 5). So the memory is that of the wavefront and of the diagram.

\code
Surface_mesh_geodesic_Voronoi_diagram<Traits> diagram(mesh);
diagram.add_site(v);                          // sites are numbered 0, 1, ...
diagram.add_site(w);
std::size_t nearest = diagram.nearest_site(u); // computes the diagram
for(const auto& edge : diagram.edges())
  std::cout << edge.length() << std::endl;
\endcode

<b>Curves.</b> A site may be a `Surface_mesh_geodesics::Surface_curve`; its distance is that of its nearest point. The
run from curves keeps all windows, and one thread divides the faces, whatever the tag. So the memory is that of
`Surface_mesh_geodesic_paths` with its windows, and `distance_to_nearest_site()` needs no second propagation.

<b>Weights.</b> A site may have a weight \f$ w \f$, which is subtracted from geodesic distances: the distance of a point
from the site is the geodesic distance minus \f$ w \f$, as in `Apollonius_graph_2`. A site in the cell of another site
has an empty cell. Distances are propagated with the differences from the largest weight, and are exact relative to
these: a very large weight in one component costs digits in the others. A difference must not be more than about
\f$ 10^{12} \f$ times the extent of the mesh.

<b>Ties.</b> Of several sites at one point with the same weight, the first one owns the cell, and the cells of the
others are empty. The same may happen to two sites whose distance, plus the difference of their weights, is less than
about \f$ 6 \cdot 10^{-14} \f$ times the extent of their component, as no distance tells which of them is nearer: the
site with the lower index owns the cell. If the distance minus the difference of the weights is as small, the site with
the smaller weight is nowhere nearer beyond rounding, and its cell may be empty, too. If two sites are equally far from
a vertex at which shortest paths bend, whole regions may be equally far from both. Such a region belongs to one of the
two, which is decided at that vertex; its boundary consists of the points beyond which the paths from the other site are
longer. Where the diagram is symmetric, arcs may run along edges and through vertices of the mesh, and more than three
cells may meet.

A point or a segment on several curves with the same weight belongs to all of them, and so do all points that are
nearest to it: where two curves meet in a corner, the whole region that is nearest to the corner. `nearest_sites()`
tells all of them. As cells do not overlap, the region is a part of the cell of the first one. A curve that lies on
earlier ones has an empty cell. The cell of a point on a curve that comes later is that point alone: it has no area, and
the cell of the curve is not a disk, as it lacks that point.

<b>Walls.</b> `avoid_edges()` makes walls of edges. The surface is cut along them: for all that this class tells, a wall
is a border of the mesh on each of its sides, and a vertex of a wall is one vertex for each sector of faces between
walls. So edges of the diagram end at walls, boundaries of cells go on along them, and what is called a border of the
mesh below includes them. A site on a wall is a site on all of its sides. The parts of its cell on these sides are one
cell; they need not be connected, and then the cell is not a disk. A point of a wall is in a cell on each side; queries
answer for the side whose site is nearest, and for any of them where several are equally near.

<b>When things are computed.</b> The diagram is computed by `build()` or by the first query that needs it. Every
function that computes it throws what `build()` throws. If computing ends early, the next query or `build()` begins
anew.

<b>Without sites.</b> A query reads the mesh like any other one. It checks its vertex or location, and answers that no
site reaches it.

<b>Thread safety.</b> One rule holds for all `const` functions, those of `Vertex`, `Arc` and `Edge` included: several
threads may call them at once on one object. If something that a query needs is missing, one thread computes it under a
mutex, and the others wait; once it is there, queries take no lock. Functions that are not `const` must not run at the
same time as any other function of the object.

<b>Parallel propagation.</b> With `Parallel_tag` as `ConcurrencyTag`, the propagation runs in the threads of the task
arena of the calling thread, as in `Surface_mesh_geodesics::geodesic_distances()`. They also divide the edges and faces
that lie in several cells, while one of them at a time removes redundant windows. So a diagram gains less from many
threads than distances do. Queries are answered in the calling thread. Vertices, arcs and edges and their order do not
depend on the number of threads, down to the last bit. From those with `Sequential_tag` they may differ by rounding and
in their order. The calling thread calls the functions of a visitor, less often than with `Sequential_tag`.
`Parallel_tag` needs TBB.

<b>Differences from `Surface_mesh_geodesic_paths`.</b> Both classes follow the rule above. The other class keeps to the
interface of `Surface_mesh_shortest_path`; its reference page lists where it therefore differs from a diagram.

<b>Units.</b> Distances, weights and lengths are in the unit of the points, or of the edge lengths; areas are in its
square.

<b>Validity.</b> Handles and references that functions return are valid until sites are changed, `clear()`,
`avoid_faces()`, `avoid_edges()`, `use_edge_lengths()` or `use_points()` is called, or the diagram is destroyed. The
mesh must not change in between.

\tparam Traits a model of `SurfaceMeshShortestPathTraits`, with the requirements of `Surface_mesh_geodesic_paths`
\tparam VIM a model of `ReadablePropertyMap` with `vertex_descriptor` as key and `unsigned int` as value type.
        The default is `boost::property_map<Triangle_mesh, boost::vertex_index_t>::%const_type`.
\tparam HIM a model of `ReadablePropertyMap` with `halfedge_descriptor` as key and `unsigned int` as value
        type. It is not read. The default is
        `boost::property_map<Triangle_mesh, boost::halfedge_index_t>::%const_type`.
\tparam FIM a model of `ReadablePropertyMap` with `face_descriptor` as key and `unsigned int` as value type.
        The default is `boost::property_map<Triangle_mesh, boost::face_index_t>::%const_type`.
\tparam VPM a model of `ReadablePropertyMap` with `vertex_descriptor` as key and `Traits::Point_3` as value
        type. The default is `boost::property_map<Triangle_mesh, CGAL::vertex_point_t>::%const_type`.

\tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`: whether the propagation uses
        several threads, see above

\sa `Surface_mesh_geodesic_paths`
*/
template <typename Traits, typename VIM = Default, typename HIM = Default, typename FIM = Default,
          typename VPM = Default, typename ConcurrencyTag = Sequential_tag>
class Surface_mesh_geodesic_Voronoi_diagram
{
  static_assert(Surface_mesh_geodesics::internal::Checked_traits_class<Traits>::value, "always true, if it compiles");

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

  /// the edge descriptor type.
  using edge_descriptor = typename Graph_traits::edge_descriptor;

  /// the face descriptor type.
  using face_descriptor = typename Graph_traits::face_descriptor;

#ifndef DOXYGEN_RUNNING
  using Vertex_index_map = typename Default::Get<
    VIM, typename boost::property_map<Triangle_mesh, boost::vertex_index_t>::const_type>::type;
  using Halfedge_index_map = typename Default::Get<
    HIM, typename boost::property_map<Triangle_mesh, boost::halfedge_index_t>::const_type>::type;
  using Face_index_map = typename Default::Get<
    FIM, typename boost::property_map<Triangle_mesh, boost::face_index_t>::const_type>::type;
  using Vertex_point_map = typename Default::Get<
    VPM, typename boost::property_map<Triangle_mesh, CGAL::vertex_point_t>::const_type>::type;
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

  /// the number of a site. The site that was added first has the number 0.
  using Site_index = std::size_t;

  /// @}

  /// returns the number that stands for "no site", and for "no vertex" of the diagram: the largest `std::size_t`.
  static constexpr std::size_t null_site() { return (std::numeric_limits<std::size_t>::max)(); }

private:
  static_assert(Surface_mesh_geodesics::internal::Maps_of_class<Triangle_mesh, Point_3, Vertex_index_map,
                                                                Face_index_map, Vertex_point_map>::value,
                "always true, if it compiles");

  template <typename Output, typename Value>
  using Is_output_iterator = Surface_mesh_geodesics::internal::Is_output_iterator<Output, Value>;
  template <typename Output, typename Value>
  using Checked_output_iterator = Surface_mesh_geodesics::internal::Checked_output_iterator<Output, Value>;

  using Self = Surface_mesh_geodesic_Voronoi_diagram;
  using Elements = Surface_mesh_geodesics::internal::Voronoi_handles<Self>;
  using Curve = Surface_mesh_geodesics::internal::Arc_curve;
  using Planar = Surface_mesh_geodesics::internal::Planar_point<double>;

public:
  /*!
  A vertex of the diagram: a point where at least three sites are equally near and no site is nearer. It is a small
  handle, like `Arc` and `Edge`. It is valid until sites are changed, `clear()`, `use_edge_lengths()`, `use_points()`,
  `avoid_faces()` or `avoid_edges()` is called, or the diagram is destroyed. All functions take constant time.
  */
  class Vertex
  {
  public:
    /// constructs a handle that refers to no vertex. It can only be assigned to and compared.
    Vertex() = default;

    /// returns whether two handles refer to the same vertex of the same diagram.
    friend bool operator==(const Vertex& a, const Vertex& b)
    {
      return a.m_diagram == b.m_diagram && a.m_index == b.m_index;
    }
    /// returns whether two handles refer to different vertices.
    friend bool operator!=(const Vertex& a, const Vertex& b) { return !(a == b); }

    /// returns the location of the vertex.
    Face_location location() const { return m_diagram->m_lazy.location(node().face, node().point); }

    /// returns the point of the vertex.
    Point_3 point() const { return m_diagram->point(location()); }

    /// returns the sites whose cells meet here, in ascending order: three, or more in symmetric diagrams.
    const std::vector<Site_index>& sites() const { return m_diagram->elements().sites_of_vertex(m_index); }

    /// returns the distance from the sites, minus their weights, in the unit of the mesh.
    FT distance() const { return m_diagram->m_lazy.user_distance(node().distance); }

    /// returns the number of the vertex: its position in `Surface_mesh_geodesic_Voronoi_diagram::vertices()`.
    std::size_t index() const { return m_index; }

  private:
    friend Elements;
    Vertex(const Self* d, std::size_t i) : m_diagram(d), m_index(i) {}

    const auto& node() const
    {
      return m_diagram->m_lazy.complex().nodes()[m_diagram->elements().node_of_vertex(m_index)];
    }

    const Self* m_diagram = nullptr;
    std::size_t m_index = 0;
  };

  /*!
  An arc of the diagram: a piece, in one face, of the curve between two cells, along which the shortest paths to each of
  the two sites cross the same edges. All functions take constant time except `sample()`. The time of `length()`, a
  quadrature, is bounded but depends on the shape of the arc.
  */
  class Arc
  {
  public:
    /// constructs a handle that refers to no arc. It can only be assigned to and compared.
    Arc() = default;

    /// returns whether two handles refer to the same arc of the same diagram.
    friend bool operator==(const Arc& a, const Arc& b)
    {
      return a.m_diagram == b.m_diagram && a.m_index == b.m_index;
    }
    /// returns whether two handles refer to different arcs.
    friend bool operator!=(const Arc& a, const Arc& b) { return !(a == b); }

    /// returns the face of the mesh that holds the arc.
    face_descriptor face() const { return m_diagram->m_lazy.user_face(arc().face); }

    /// returns the site whose cell is on the left of the arc, as seen from outside, and the site on its right.
    std::pair<Site_index, Site_index> sites() const
    {
      return {m_diagram->m_lazy.site_at(arc().left_site), m_diagram->m_lazy.site_at(arc().right_site)};
    }

    /// returns the location at the parameter `t`. Points are not evenly spaced in general.
    ///
    /// \param t the position of the point: 0 at the start of the arc, 1 at its end
    /// \pre `0 <= t` and `t <= 1`. (A smaller number counts as 0, a larger one as 1.)
    Face_location point(double t) const { return m_diagram->m_lazy.location(arc().face, Curve(arc()).point(t)); }

    /// returns the distance of the two sites from `point(t)`, minus their weights, in the unit of the mesh.
    ///
    /// \param t the position of the point, as for `point()`
    /// \pre `0 <= t` and `t <= 1`. (A smaller number counts as 0, a larger one as 1.)
    FT distance(double t) const
    {
      return m_diagram->m_lazy.user_distance(arc().left.distance_to(Curve(arc()).point(t)));
    }

    /// returns whether the arc is a segment. Otherwise it is a piece of a hyperbola, or of a parabola.
    bool is_segment() const { return Curve(arc()).is_segment(); }

    /// returns the length in the unit of the mesh, with a relative error of about \f$ 10^{-13} \f$.
    FT length() const { return FT(m_diagram->m_lazy.unit() * Curve(arc()).length()); }

    /// writes the locations of points from `point(0)` to `point(1)`; the segments between them are at most `tolerance`
    /// away from the arc. Takes time linear in the number of points.
    ///
    /// \tparam OutputIterator a model of `OutputIterator` that takes `Face_location`
    /// \param tolerance the largest distance, in the unit of the mesh
    /// \param output receives the locations: two for a segment. A piece of another curve is halved at most 24 times in
    ///        a row.
    /// \return the output iterator past the last location
    /// \pre `tolerance > 0`
    template <typename OutputIterator>
    OutputIterator sample(double tolerance, OutputIterator output) const
    {
      CGAL_precondition_msg(tolerance > 0, "the tolerance is not positive");
      const auto& lazy = m_diagram->m_lazy;
      const auto face = arc().face;
      static_assert(Checked_output_iterator<OutputIterator, Face_location>::value, "always true, if it compiles");
      *output++ = lazy.location(face, arc().first);
      Curve(arc()).sample(tolerance / lazy.unit(), [&](const Planar& p) { *output++ = lazy.location(face, p); });
      return output;
    }

    /// returns the number of the vertex of the diagram at the start, or `null_site()` if there is none.
    std::size_t source_vertex() const { return m_diagram->elements().vertex_of_node(arc().first_node); }

    /// returns the number of the vertex of the diagram at the end, or `null_site()` if there is none.
    std::size_t target_vertex() const { return m_diagram->elements().vertex_of_node(arc().last_node); }

    /// returns the number of the arc: its position in `Surface_mesh_geodesic_Voronoi_diagram::arcs()`.
    std::size_t index() const { return m_index; }

  private:
    friend Elements;
    Arc(const Self* d, std::size_t i) : m_diagram(d), m_index(i) {}

    const auto& arc() const
    {
      return m_diagram->m_lazy.complex().arcs()[m_diagram->elements().complex_arc(m_index)];
    }

    const Self* m_diagram = nullptr;
    std::size_t m_index = 0;
  };

  /*!
  An edge of the diagram: the arcs between two cells from one vertex of the diagram to the next one or to the border of
  the mesh, or all arcs of a closed curve. All functions take constant time except `length()` and `polyline()`.
  */
  class Edge
  {
  public:
    /// constructs a handle that refers to no edge. It can only be assigned to and compared.
    Edge() = default;

    /// returns whether two handles refer to the same edge of the same diagram.
    friend bool operator==(const Edge& a, const Edge& b)
    {
      return a.m_diagram == b.m_diagram && a.m_index == b.m_index;
    }
    /// returns whether two handles refer to different edges.
    friend bool operator!=(const Edge& a, const Edge& b) { return !(a == b); }

    /// returns the site whose cell is on the left of the edge, as seen from outside, and the site on its right.
    std::pair<Site_index, Site_index> sites() const
    {
      return {m_diagram->m_lazy.site_at(chain().left_site), m_diagram->m_lazy.site_at(chain().right_site)};
    }

    /// returns the arcs from the start of the edge to its end, and for each arc whether the edge runs through it from
    /// its end to its start. The reference is valid as long as the edge.
    const std::vector<std::pair<Arc, bool>>& arcs() const { return m_diagram->elements().arcs_of_edge(m_index); }

    /// returns the number of the vertex of the diagram at the start, or `null_site()` if the edge is closed or starts
    /// at the border of the mesh.
    std::size_t source_vertex() const
    {
      return is_closed() ? null_site() : m_diagram->elements().vertex_of_node(chain().first_node);
    }

    /// returns the number of the vertex of the diagram at the end, or `null_site()` if the edge is closed or ends at
    /// the border of the mesh.
    std::size_t target_vertex() const
    {
      return is_closed() ? null_site() : m_diagram->elements().vertex_of_node(chain().last_node);
    }

    /// returns whether the edge is a closed curve without a vertex.
    bool is_closed() const { return chain().is_closed; }

    /// returns the length, in the unit of the mesh. Takes time linear in the number of arcs.
    FT length() const
    {
      FT sum = 0;
      for(const std::pair<Arc, bool>& a : arcs())
        sum += a.first.length();
      return sum;
    }

    /// writes the points of a polyline along the edge. The polyline of a closed edge ends with its first point. Takes
    /// time linear in the number of points.
    ///
    /// \tparam OutputIterator a model of `OutputIterator` that takes `Point_3`
    /// \param tolerance the largest distance of the polyline from the arcs, in the unit of the mesh, as for
    ///        `Arc::sample()`
    /// \param output receives the points
    /// \return the output iterator past the last point
    /// \pre `tolerance > 0`
    template <typename OutputIterator>
    OutputIterator polyline(double tolerance, OutputIterator output) const
    {
      static_assert(Checked_output_iterator<OutputIterator, Point_3>::value, "always true, if it compiles");
      if constexpr(!Is_output_iterator<OutputIterator, Point_3>::value)
        return output;
      else
        return m_diagram->elements().write_polyline(m_index, tolerance, output);
    }

    /// returns the number of the edge: its position in `Surface_mesh_geodesic_Voronoi_diagram::edges()`.
    std::size_t index() const { return m_index; }

  private:
    friend Elements;
    Edge(const Self* d, std::size_t i) : m_diagram(d), m_index(i) {}

    const auto& chain() const
    {
      return m_diagram->m_lazy.complex().chains()[m_diagram->elements().chain_of_edge(m_index)];
    }

    const Self* m_diagram = nullptr;
    std::size_t m_index = 0;
  };

  /// One curve of the boundary of a cell: consecutive edges with the cell on their left. It is valid as long as its
  /// edges.
  struct Boundary
  {
    /// the edges, and for each whether the boundary runs through it from its end to its start.
    std::vector<std::pair<Edge, bool>> edges;

    /// whether the last edge ends where the first one starts. Otherwise both ends are at the border of the mesh.
    bool is_closed;
  };

  /// One curve of the boundary of a cell as a polyline, with the cell on its left: for drawing and for cutting.
  struct Boundary_polyline
  {
    /// the points, in order. The last one is the first one again if the polyline is closed. The segment from each point
    /// to the next one lies in the face of the latter.
    std::vector<Face_location> locations;

    /// for each point the number of the vertex of the diagram that it is, or `null_site()`.
    std::vector<std::size_t> vertices;

    /// whether the polyline is closed. Otherwise both ends are at the border of the mesh.
    bool is_closed;
  };

  /// \name Constructors
  /// They take constant time. Diagrams can neither be copied nor moved.
  /// @{

  /// constructs a diagram without sites, with the index maps and the point map of the mesh.
  ///
  /// \param tm the mesh. It is referred to, not copied, and must not change before `clear()`. Nothing may be assigned
  ///        to a `Surface_mesh`, as that invalidates the maps that the object keeps.
  /// \param traits an instance of the traits class, which is copied
  /// \pre The faces of `tm` are triangles. (Otherwise `build()` throws.)
  explicit Surface_mesh_geodesic_Voronoi_diagram(const Triangle_mesh& tm, const Traits& traits = Traits())
    : Surface_mesh_geodesic_Voronoi_diagram(tm, get(boost::vertex_index, tm), get(boost::halfedge_index, tm),
                                            get(boost::face_index, tm), get(CGAL::vertex_point, tm), traits)
  {}

  /// constructs a diagram with sites, with the index maps and the point map of the mesh. Takes time linear in the
  /// number of sites.
  ///
  /// \tparam Sites a range of `vertex_descriptor`, `Face_location`, or `Surface_mesh_geodesics::Surface_curve`
  /// \param tm the mesh, as above
  /// \param sites the sites, as for `add_sites()`
  /// \param traits an instance of the traits class, which is copied
  /// \pre The faces of `tm` are triangles. (Otherwise `build()` throws.)
#ifndef DOXYGEN_RUNNING
  template <typename Sites,
            typename = std::enable_if_t<Surface_mesh_geodesics::internal::Is_range_of<Sites, vertex_descriptor>::value
                                        || Surface_mesh_geodesics::internal::Is_range_of<Sites, Face_location>::value
                                        || (Surface_mesh_geodesics::internal::Are_curves<Sites>::value
                                            && !Surface_mesh_geodesics::internal::Is_curve<Sites>::value)>>
#else
  template <typename Sites>
#endif
  Surface_mesh_geodesic_Voronoi_diagram(const Triangle_mesh& tm, const Sites& sites, const Traits& traits = Traits())
    : Surface_mesh_geodesic_Voronoi_diagram(tm, traits)
  {
    add_sites(sites);
  }

  /// constructs a diagram without sites, with given maps.
  ///
  /// \param tm the mesh. It is referred to, not copied, and must not change before `clear()`. Nothing may be assigned
  ///        to a `Surface_mesh`, as that invalidates the maps that the object keeps.
  /// \param vertex_index_map maps each vertex to an index from 0 to `num_vertices(tm) - 1`
  /// \param halfedge_index_map is not read
  /// \param face_index_map maps each face to an index from 0 to `num_faces(tm) - 1`
  /// \param vertex_point_map maps each vertex to its point
  /// \param traits an instance of the traits class, which is copied
  /// \pre The faces of `tm` are triangles. (Otherwise `build()` throws.)
  Surface_mesh_geodesic_Voronoi_diagram(const Triangle_mesh& tm, Vertex_index_map vertex_index_map,
                                        Halfedge_index_map halfedge_index_map, Face_index_map face_index_map,
                                        Vertex_point_map vertex_point_map, const Traits& traits = Traits())
    : m_lazy(tm, vertex_index_map, face_index_map, vertex_point_map, traits, Elements(*this))
  {
    static_cast<void>(halfedge_index_map);
  }

  Surface_mesh_geodesic_Voronoi_diagram(const Surface_mesh_geodesic_Voronoi_diagram&) = delete;
  Surface_mesh_geodesic_Voronoi_diagram& operator=(const Surface_mesh_geodesic_Voronoi_diagram&) = delete;

  /// @}

  /// \name Sites
  /// Changes discard the diagram; the next query computes it again.
  /// @{

  /// adds a vertex as a site. `build()` checks whether it is a vertex of the mesh. Takes constant time, plus time
  /// linear in the size of the diagram if one is built.
  ///
  /// \param v a vertex of the mesh
  /// \param weight its weight, in the unit of the mesh; it may be negative
  /// \return the number of the site
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the weight is not finite
  Site_index add_site(vertex_descriptor v, const FT& weight = FT(0)) { return m_lazy.add_site(v, weight); }

  /// adds a point of a face as a site. `build()` checks whether it is a point of the mesh. Takes constant time, plus
  /// time linear in the size of the diagram if one is built.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \param weight its weight, in the unit of the mesh; it may be negative
  /// \return the number of the site
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the weight is not finite
  Site_index add_site(const Face_location& location, const FT& weight = FT(0))
  {
    return m_lazy.add_site(location, weight);
  }

  /// adds a curve as a site: the distance of a point from the site is the smallest one from a point of the curve, and
  /// exact. `build()` checks whether it is a curve of the mesh. A curve of one location is a point. Takes time linear
  /// in the number of segments, plus time linear in the size of the diagram if one is built.
  ///
  /// \tparam Curve `Surface_mesh_geodesics::Surface_curve<Triangle_mesh>`
  /// \param curve a curve on the mesh; it is copied
  /// \param weight its weight, in the unit of the mesh; it may be negative
  /// \return the number of the site
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the weight is not finite
#ifndef DOXYGEN_RUNNING
  template <typename Curve, typename = std::enable_if_t<Surface_mesh_geodesics::internal::Is_curve<Curve>::value>>
#else
  template <typename Curve>
#endif
  Site_index add_site(const Curve& curve, const FT& weight = FT(0))
  {
    static_assert(Surface_mesh_geodesics::internal::Checked_curve<Triangle_mesh, Curve>::value,
                  "always true, if it compiles");
    return m_lazy.add_site(curve, weight);
  }

  /// adds all elements of a range as sites with the weight 0. Takes time linear in their number, plus time linear in
  /// the size of the diagram if one is built.
  ///
  /// \tparam Sites a range of `vertex_descriptor`, `Face_location`, or `Surface_mesh_geodesics::Surface_curve`
  /// \param sites the sites
  /// \return the number of the first site that was added; the others follow. `number_of_sites()` if the range is empty.
  template <typename Sites>
  Site_index add_sites(const Sites& sites)
  {
    using Surface_mesh_geodesics::internal::Is_range_of;
    constexpr bool are_sites
      = Is_range_of<Sites, vertex_descriptor>::value || Is_range_of<Sites, Face_location>::value
     || (Surface_mesh_geodesics::internal::Are_curves<Sites>::value
         && !Surface_mesh_geodesics::internal::Is_curve<Sites>::value);
    static_assert(are_sites, "the sites are not a range of vertices, of objects of the type Face_location, or of "
                             "curves; for a single site, call add_site()");
    const Site_index first = number_of_sites();
    if constexpr(are_sites) // else the errors of the loop would follow the message
      for(const auto& s : sites)
        add_site(s);
    return first;
  }

  /// removes all sites and discards everything that was computed. Call this function after the mesh has changed. Faces
  /// and edges to avoid stay, by the indices of the faces: give them again if these have changed.
  ///
  /// The maps of the constructor must still be valid. An assignment to a `Surface_mesh` invalidates its point map; then
  /// construct a new object instead.
  void clear() { m_lazy.clear(); }

  /// removes all sites and keeps what was read of the mesh, which saves time if other sites on the same mesh follow.
  /// Handles and references become invalid. Takes time linear in the size of the diagram.
  /// \pre The mesh, its points and its lengths have not changed since they were read. Otherwise call `clear()`.
  void remove_all_sites() { m_lazy.remove_all_sites(); }

  /// takes the lengths of the edges from a map instead of the points, until the next call of `use_points()`. The next
  /// `build()` reads and checks them, and throws if they are invalid, as each build does until there are other lengths.
  /// Sites are kept. Takes constant time if nothing is computed.
  ///
  /// \tparam EdgeLengthMap a model of `ReadablePropertyMap` with the edge descriptor as key type and a number
  ///         type as value type. The mesh is a model of `EdgeListGraph`, too.
  /// \param edge_length_map maps each edge to its length, as for
  ///        `Surface_mesh_geodesics::geodesic_distances_from_edge_lengths()`; it is copied
  template <typename EdgeLengthMap>
  void use_edge_lengths(EdgeLengthMap edge_length_map)
  {
    m_lazy.use_edge_lengths(edge_length_map);
  }

  /// takes the lengths of the edges from the points of the vertices, which is the default. Sites are kept.
  void use_points() { m_lazy.use_points(); }

  /// leaves faces out: no path leads through them, as if they were not in the mesh. They are in no cell. Sites may be
  /// at their rim, also if their location is given in a face to avoid; a site inside is rejected by the next build.
  /// Sites and walls are kept, and the faces stay left out until the next call.
  ///
  /// A query at a location inside of these faces is rejected; a vertex inside is in no cell.
  ///
  /// \tparam Faces a range of face descriptors, or a model of `ReadablePropertyMap` with the face descriptor as
  ///         key type and `bool` as value type
  /// \param faces_to_avoid the faces, in place of those of the last call; none if the range is empty
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if a face of the range is not one of the mesh; nothing
  ///         changes then
  template <typename Faces>
  void avoid_faces(const Faces& faces_to_avoid)
  {
    m_lazy.avoid_faces(faces_to_avoid);
  }

  /// returns whether a face is one of those that the last call of `avoid_faces()` has left out. Takes constant time.
  ///
  /// \param f a face of the mesh
  bool avoids_face(face_descriptor f) const { return m_lazy.avoids_face(f); }

  /// makes walls of edges: no path crosses them, and paths may run along them, as for
  /// `Surface_mesh_geodesic_paths::avoid_edges()`. For cells, a wall is a border of the mesh on each of its sides, see
  /// above. Sites and faces to avoid are kept, and the walls stay until the next call.
  ///
  /// \tparam Edges a range of edge descriptors, or a model of `ReadablePropertyMap` with the edge descriptor as
  ///         key type and `bool` as value type
  /// \param edges_to_avoid the edges, in place of those of the last call; none if the range is empty. An edge at the
  ///        border of the mesh changes nothing.
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if an edge of the range is not one of the mesh; nothing
  ///         changes then
  template <typename Edges>
  void avoid_edges(const Edges& edges_to_avoid)
  {
    m_lazy.avoid_edges(edges_to_avoid);
  }

  /// returns whether an edge is one of the walls that the last call of `avoid_edges()` has made. Takes constant time.
  ///
  /// \param e an edge of the mesh
  bool avoids_edge(edge_descriptor e) const { return m_lazy.avoids_edge(e); }

  /// returns the number of sites.
  std::size_t number_of_sites() const { return m_lazy.sites().size(); }

  /// returns the location of a site. For a vertex this is a corner of one of its faces, for a curve the location of its
  /// first point. The face is the null face for a vertex without faces, and for a descriptor that is not a vertex of
  /// the mesh.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  Face_location site(Site_index i) const
  {
    check(i);
    return m_lazy.location_of_site(i);
  }

  /// returns the curve of a site, or null if the site is a point. The pointer is valid as long as the site.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  const Surface_mesh_geodesics::Surface_curve<Triangle_mesh>* site_curve(Site_index i) const
  {
    check(i);
    return m_lazy.sites()[i].curve.get();
  }

  /// returns the weight of a site, in the unit of the mesh.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  FT weight(Site_index i) const
  {
    check(i);
    return m_lazy.sites()[i].weight;
  }

  /// @}

  /// \name Building
  /// @{

  /// computes the diagram unless it is computed already.
  ///
  /// The time is that of a propagation from all sites, at worst \cgalBigO{n^2} for \f$ n \f$ vertices, plus, for each
  /// face that curves cross, time polynomial in the number of windows on its edges. In practice both together are a
  /// small multiple of the time for the distances (\ref Surface_mesh_geodesics_performance). The memory is that of the
  /// mesh, of the windows near the wavefront, and of the arcs (\cgalCite{qin2017voronoi}; thesis, chapter 5). Only the
  /// first call reads the mesh.
  ///
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a site is invalid. Nothing is computed then;
  ///         sites stay as they are. All functions that build throw it.
  /// \throws std::bad_alloc if there is not enough memory
  void build() const { m_lazy.build(); }

  /// computes the diagram unless it is computed already, and informs a visitor of the progress of the propagation,
  /// which is most of the work. If the diagram is computed already, the visitor is not called.
  ///
  /// \tparam Visitor a model of `GeodesicPropagationVisitor`
  /// \param visitor the visitor, which this thread calls. It must not use the diagram. The distances that it receives
  ///        are reduced by the largest weight.
  /// \return `true`, or `false` if the visitor canceled the propagation; nothing is computed then
  ///
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the mesh or a site is invalid, and what the visitor
  ///         throws; nothing is computed then
  template <typename Visitor>
  bool build(Visitor& visitor) const
  {
    return m_lazy.build(visitor);
  }

  /// returns whether the diagram is computed for the present sites.
  bool is_built() const { return m_lazy.is_built(); }

  /// returns the counts of the propagation. The diagram is computed if necessary.
  Surface_mesh_geodesics::Propagation_statistics statistics() const { return m_lazy.statistics(); }

  /// returns the largest number of windows that were kept for the diagram at one time, and the number that would have
  /// been kept without the removal of redundant windows. The diagram is computed if necessary.
  std::pair<std::size_t, std::size_t> number_of_kept_windows() const { return m_lazy.number_of_kept_windows(); }

  /// @}

  /// \name Queries
  /// The diagram is computed if necessary. A vertex, a face or a location that is not on the mesh throws
  /// `Surface_mesh_geodesics::Invalid_geodesic_input`, also if there are no sites.
  /// @{

  /// returns the site whose cell holds a vertex. Takes constant time.
  ///
  /// \param v a vertex of the mesh
  /// \return the number of the site, or `null_site()` if no site reaches `v`
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v` is not a vertex of the mesh (null,
  ///         removed, or with an index out of range)
  Site_index nearest_site(vertex_descriptor v) const { return m_lazy.nearest_site(v); }

  /// returns the site whose cell holds a point of a face. Usually few arcs cross a face, and the time is linear in
  /// their number; at worst it is quadratic. The first call for a point on the edge of a wall between two cells
  /// propagates a second time, as `distance_to_nearest_site()` does.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \return the number of the site, or `null_site()` if no site reaches the point. If several sites are nearest, any
  ///         of them is returned.
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `f` is not a face of the mesh or the point is not in it
  Site_index nearest_site(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return m_lazy.nearest_site(f, location);
  }

  /// returns the site whose cell holds a location; the same as `nearest_site(location.first, location.second)`.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \return the number of the site, or `null_site()` if no site reaches the point
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input as above
  Site_index nearest_site(const Face_location& location) const
  {
    return nearest_site(location.first, location.second);
  }

  /// writes the sites at the nearest point: of all points of sites, the one that is nearest to a vertex. If sites with
  /// different weights are there, only those with exactly the largest weight count. So the common end of two curves
  /// belongs to both curves, and so do all points that are nearest to it. An edge on several curves belongs to all of
  /// them, also if their cells are empty. Points count as the same up to rounding.
  ///
  /// `nearest_site()` returns one of these sites, unless several points are equally near. Then the sites at one of
  /// these points are written; `arcs()` and `vertices()` know the others.
  ///
  /// Takes the time of `nearest_site()`, plus time linear in the number of sites if all of them are points, or in the
  /// number of windows on the edges of a face and of bends of the path if there are curves.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `Site_index`
  /// \param v a vertex of the mesh
  /// \param output receives the numbers of the sites in ascending order; none if no site reaches `v`
  /// \return the output iterator past the last number
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v` is not a vertex of the mesh
  template <typename OutputIterator>
  OutputIterator nearest_sites(vertex_descriptor v, OutputIterator output) const
  {
    static_assert(Checked_output_iterator<OutputIterator, const Site_index&>::value, "always true, if it compiles");
    if constexpr(Is_output_iterator<OutputIterator, const Site_index&>::value)
      for(const Site_index i : m_lazy.nearest_sites(v))
        *output++ = i;
    return output;
  }

  /// writes the sites at the nearest point of a location, as above.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `Site_index`
  /// \param location a face of the mesh and coordinates in it
  /// \param output receives the numbers of the sites in ascending order; none if no site reaches the location
  /// \return the output iterator past the last number
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if the location is not on the mesh
  template <typename OutputIterator>
  OutputIterator nearest_sites(const Face_location& location, OutputIterator output) const
  {
    static_assert(Checked_output_iterator<OutputIterator, const Site_index&>::value, "always true, if it compiles");
    if constexpr(Is_output_iterator<OutputIterator, const Site_index&>::value)
      for(const Site_index i : m_lazy.nearest_sites(location.first, location.second))
        *output++ = i;
    return output;
  }

  /// returns the distance of a vertex from its nearest site, minus the weight of the site. Takes constant time.
  ///
  /// \param v a vertex of the mesh
  /// \return the distance, in the unit of the mesh, or -1 if no site reaches `v`. With positive weights, a distance may
  ///         be negative as well; `nearest_site()` then tells whether a site reaches `v`.
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `v` is not a vertex of the mesh
  FT distance_to_nearest_site(vertex_descriptor v) const { return m_lazy.distance_to_nearest_site(v); }

  /// returns the distance of a point of a face from its nearest site, minus the weight of the site.
  ///
  /// The first call for a point that is not a vertex propagates a second time and keeps all windows, as the diagram has
  /// removed those that it does not need. Each call takes time linear in the number of windows on the edges of the
  /// face. Near an arc, the result may be the distance from the other site of the arc; both are equal up to rounding.
  ///
  /// \param f a face of the mesh
  /// \param location the coordinates of the point in `f`
  /// \return the distance, in the unit of the mesh, or -1 if no site reaches the point
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input if `f` is not a face of the mesh or the point is not in it
  FT distance_to_nearest_site(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return m_lazy.distance_to_nearest_site(f, location);
  }

  /// returns the distance of a location from its nearest site, minus the weight of the site; the same as
  /// `distance_to_nearest_site(location.first, location.second)`.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \return the distance, in the unit of the mesh, or -1 if no site reaches the point
  /// \throws Surface_mesh_geodesics::Invalid_geodesic_input as above
  FT distance_to_nearest_site(const Face_location& location) const
  {
    return distance_to_nearest_site(location.first, location.second);
  }

  /// @}

  /// \name Elements of the Diagram
  /// The diagram is computed if necessary. References are valid until the diagram is discarded. Functions that return a
  /// reference take constant time. The order of elements is not specified; it may depend on the size of the mesh.
  /// @{

  /// returns the vertices of the diagram.
  const std::vector<Vertex>& vertices() const { return built_elements().vertices(); }

  /// returns the edges of the diagram.
  const std::vector<Edge>& edges() const { return built_elements().edges(); }

  /// returns the arcs of the diagram.
  const std::vector<Arc>& arcs() const { return built_elements().arcs(); }

  /// returns the arcs in a face. Takes \cgalBigO{\log n + k} time for \f$ n \f$ arcs in all and \f$ k \f$ in the face.
  ///
  /// \param f a face of the mesh
  /// \pre `f` is a face of the mesh. (This is not checked.)
  std::vector<Arc> arcs(face_descriptor f) const { return m_lazy.arcs(f); }

  /// returns the arcs around the cell of a site, in the order of `boundary()`. Takes time linear in their number.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  std::vector<Arc> arcs(Site_index i) const { return Elements::arcs_along(boundary(i)); }

  /// @}

  /// \name Cells
  /// The diagram is computed if necessary. Unless stated otherwise, functions take time linear in the number of edges
  /// around the cell.
  /// @{

  /// returns whether the cell of a site is empty: another site is at the same point, or nearly so, or a larger weight
  /// hides it. Takes constant time.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  bool is_empty(Site_index i) const { return !has_built_cell(i); }

  /// returns the sites whose cells have an edge in common with the cell of a site, in ascending order. Takes
  /// \cgalBigO{k \log k} time for \f$ k \f$ edges around the cell.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  std::vector<Site_index> adjacent_sites(Site_index i) const { return Elements::sites_beyond(boundary(i)); }

  /// returns the edges around the cell, with the cell on their left. The pieces of the boundary along the border of the
  /// mesh are omitted: a curve that they interrupt is not closed.
  ///
  /// \param i the number of the site
  /// \return the curves of the boundary, in no particular order; none if the cell is empty or a whole component of
  ///         the mesh
  /// \pre `i < number_of_sites()`
  std::vector<Boundary> boundary(Site_index i) const
  {
    return has_built_cell(i) ? elements().boundary(m_lazy.complex().boundary(m_lazy.cell_of_site(i)))
                             : std::vector<Boundary>();
  }

  /// returns the curves around the cell as polylines, with the cell on their left.
  ///
  /// Closed along the border of the mesh, the polylines are the whole boundary of the cell, also where the cell is not
  /// a disk: it has as many loops as holes, and one more. Where the mesh is a domain of the plane, the areas of the
  /// loops add up to `area(i)`, within the tolerance, as loops around holes run clockwise.
  ///
  /// \param i the number of the site
  /// \param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh, as for
  ///        `Arc::sample()`
  /// \param closes_at_border whether polylines go on along the border of the mesh where the cell ends there, and curves
  ///        of the border that are wholly in the cell are returned, too
  /// \return the polylines, in no particular order. `point()` gives the points of space. Curves that are no longer than
  ///         rounding are left out.
  /// \pre `i < number_of_sites()` and `tolerance > 0`
  ///
  /// Takes time linear in the number of points, and in that of faces of the mesh if `closes_at_border` is `true`.
  std::vector<Boundary_polyline> boundary_polylines(Site_index i, double tolerance,
                                                    bool closes_at_border = false) const
  {
    CGAL_precondition_msg(tolerance > 0, "the tolerance is not positive");
    using Polylines = Surface_mesh_geodesics::internal::Boundary_polylines<decltype(m_lazy), Boundary_polyline>;
    return has_built_cell(i) ? Polylines(m_lazy, tolerance).around(m_lazy.cell_of_site(i), closes_at_border)
                             : std::vector<Boundary_polyline>();
  }

  /// returns the curves around the cell as polylines, with `default_tolerance()`, and without the border of the mesh.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  std::vector<Boundary_polyline> boundary_polylines(Site_index i) const
  {
    return boundary_polylines(i, default_tolerance());
  }

  /// returns the area of the cell, in the square of the unit of the mesh; 0 if the cell is empty.
  ///
  /// The first call of this function or of `centroid()` measures all cells, in time linear in the size of the mesh and
  /// of the diagram. Later calls take constant time.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  FT area(Site_index i) const
  {
    check(i);
    return m_lazy.area(i);
  }

  /// returns the mean of the points of the cell, which need not be on the surface. If the cell is empty or has no area,
  /// this is the site. Takes the time of `area()`.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  Point_3 centroid(Site_index i) const
  {
    check(i);
    return m_lazy.centroid(i);
  }

  /// returns the sum over all cells of points of the integral of \f$ |p - s|^2 \f$ over the points \f$ p \f$ of the
  /// cell, where \f$ s \f$ is the site and the distance is that in space; in the fourth power of the unit of the mesh.
  /// For given cells, a site has the smallest energy at the centroid of its cell, and among the vertices in the cell at
  /// `central_vertex()`. Weights count for the cells only. Cells of curves (those of sites with a `site_curve()`) add
  /// nothing, as no point of space stands for the site. The sum may be infinite if the points have very large
  /// coordinates. Takes time linear in the size of the mesh and of the diagram.
  double energy() const
  {
    build();
    using Energy = Surface_mesh_geodesics::internal::Cell_energy<decltype(m_lazy)>;
    return number_of_sites() == 0 ? 0. : Energy(m_lazy).sum();
  }

  /// returns the vertex of the mesh in the cell that is nearest in space to the centroid of the cell. Of equally near
  /// vertices it is the first one in the order of `vertices(tm)`; it is the null vertex if the cell holds no vertex.
  /// Takes time linear in the number of vertices of the mesh.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  vertex_descriptor central_vertex(Site_index i) const
  {
    check(i);
    return Surface_mesh_geodesics::internal::central_vertex(m_lazy, i);
  }

  /// returns the Euler characteristic of the cell with its boundary; 0 if the cell is empty. The boundary is regarded
  /// as a curve that does not touch itself. A vertex at which the mesh is pinched counts once. Of a cell with several
  /// parts it is the sum of theirs: walls may divide a cell, and so may sites that own points of a curve.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  int Euler_characteristic(Site_index i) const
  {
    return has_built_cell(i) ? m_lazy.complex().Euler_characteristic(m_lazy.cell_of_site(i)) : 0;
  }

  /// returns whether the cell, with its boundary, is a topological disk; `false` if the cell is empty, or a vertex
  /// without faces. A cell is not a disk either if it has several parts, if the mesh is pinched at a vertex in it, or
  /// if its boundary touches itself at a point, up to rounding. The function takes the time of `cell_mesh()` if that is
  /// possible: if boundaries run through vertices of the mesh, if four cells meet, if the site is on a wall, or if it
  /// is a curve whose cell has several boundaries. If there are both walls and curves, all cells take that time.
  ///
  /// \param i the number of the site
  /// \pre `i < number_of_sites()`
  bool is_disk(Site_index i) const
  {
    using Topology = Surface_mesh_geodesics::internal::Cell_topology;
    return has_built_cell(i)
        && Topology(m_lazy.refined_mesh(), m_lazy.complex())
             .is_disk(m_lazy.cell_of_site(i), m_lazy.parts_of_cell(i));
  }

  /// writes the triangles of the dual: one for each vertex of the diagram where three cells meet, and `n - 2` where `n`
  /// cells meet. They are oriented like the faces of the mesh. They need not form a manifold if a cell is not a disk,
  /// or if two cells have several edges in common or none. Takes time linear in the number of arcs.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` that takes `std::array<Site_index, 3>`
  /// \param output receives the triangles
  /// \return the output iterator past the last triangle
  template <typename OutputIterator>
  OutputIterator dual(OutputIterator output) const
  {
    using Triple = std::array<Site_index, 3>;
    static_assert(Checked_output_iterator<OutputIterator, Triple>::value, "always true, if it compiles");
    build();
    for(const auto& node : m_lazy.complex().nodes())
      if(node.is_vertex())
        if constexpr(Is_output_iterator<OutputIterator, Triple>::value)
          *output++ = Triple{m_lazy.site_at(node.sites[0]), m_lazy.site_at(node.sites[1]),
                             m_lazy.site_at(node.sites[2])};
    return output;
  }

  /*!
  adds the mesh, cut along the arcs, to a mesh: each face of the output lies in one cell.

  Faces are cut into triangles. Vertices and edges of the mesh are kept, and edges are divided where arcs cross them.
  The two faces at an edge share the new vertices, so the output has a border only where the mesh has one, and it has
  the Euler characteristic of the mesh. At walls the output is cut, too: each side has edges and vertices of its own.
  The two sides of a wall of one edge that no arc divides get a vertex in their middle, as a hole of a mesh has three
  edges. An arc that ends at a vertex of the mesh, up to rounding, ends at that vertex of the output, and an arc along
  an edge of the mesh becomes that edge. Sites inside faces and on edges become vertices, sites that are curves become
  edges. Pieces of hyperbolas and of parabolas become polylines. Where several arcs in a face are closer to each other
  than the tolerance, they are approximated more closely, so that they do not cross, as long as the face gets at most
  256 vertices. A triangle may have no area, as where an arc touches an edge.

  The vertices of the mesh come first in the output, in an unspecified order.

  \tparam OutputMesh a model of `MutableFaceGraph` with an internal property for `CGAL::vertex_point_t`, unless a map
          is given
  \tparam FaceSiteMap a model of `WritablePropertyMap` with the face descriptor of `OutputMesh` as key type and
          `Site_index` as value type
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param output the mesh to which the faces are added
  \param face_site_map receives the site of each new face, `null_site()` for faces that no site reaches
  \param tolerance the largest distance of the polylines from the arcs, in the unit of the mesh. A smaller tolerance
         makes more faces, but at most 1024 segments for each arc: the distance from the arc may be larger then, by
         about \f$ 10^{-6} \f$ of what one segment would have.
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
          invalid. Nothing has been added then. If memory runs out, or a map throws, the output is not a valid mesh: it
          has to be cleared.

  Takes time linear in the size of the mesh and of the diagram. In a face with many arcs or samples, the time grows with
  the cube of the number of vertices around a piece of a cell. A closer approximation than the tolerance asks for adds
  a bounded time for each face.
  */
  template <typename OutputMesh, typename FaceSiteMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  void cut(OutputMesh& output, FaceSiteMap face_site_map, double tolerance,
           const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    Surface_mesh_geodesics::internal::check_parameters<Surface_mesh_geodesics::internal::Output_mesh_parameters>(np);
    Surface_mesh_geodesics::internal::check_output_mesh<OutputMesh, FaceSiteMap, Site_index>();
    CGAL_precondition_msg(tolerance > 0, "the tolerance is not positive");
    build();
    auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                get_property_map(CGAL::vertex_point, output));
    Surface_mesh_geodesics::internal::add_cut_mesh(m_lazy, tolerance, output, vpm, face_site_map);
  }

  /// adds the mesh, cut along the arcs, to a mesh, with `default_tolerance()`.
  ///
  /// \param output the mesh to which the faces are added
  /// \param face_site_map receives the site of each new face
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as above
  template <typename OutputMesh, typename FaceSiteMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  void cut(OutputMesh& output, FaceSiteMap face_site_map,
           const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    cut(output, face_site_map, default_tolerance(), np);
  }

  /*!
  adds a cell to a mesh: the faces that `cut()` makes in the cell.

  The output has a border where the cell has a boundary, and at walls, as for `cut()`. If the mesh is pinched at a
  vertex in the cell, or if the boundary of the cell touches itself at a point, the output is pinched at one vertex
  there. Nothing is added if the cell is empty or has no area.

  \tparam OutputMesh as for `cut()`
  \tparam FaceFaceMap a model of `WritablePropertyMap` with the face descriptor of `OutputMesh` as key type and
          `face_descriptor` as value type
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param i the number of the site
  \param output the mesh to which the faces are added
  \param face_face_map receives, for each new face, the face of the mesh that it lies in
  \param tolerance the largest distance of the polylines from the arcs, as for `cut()`
  \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as for `cut()`

  \pre `i < number_of_sites()` and `tolerance > 0`

  \throws Surface_mesh_geodesics::Invalid_geodesic_input as for `cut()`

  Takes time linear in the number of faces that the cell is in or beside, plus the time of `cut()` for those that it is
  in. If the site is on a wall, the time is linear in the number of faces of the mesh, and if there are both walls and
  curves, it is so for all cells.
  */
  template <typename OutputMesh, typename FaceFaceMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  void cell_mesh(Site_index i, OutputMesh& output, FaceFaceMap face_face_map, double tolerance,
                 const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    Surface_mesh_geodesics::internal::check_parameters<Surface_mesh_geodesics::internal::Output_mesh_parameters>(np);
    Surface_mesh_geodesics::internal::check_output_mesh<OutputMesh, FaceFaceMap, face_descriptor>();
    CGAL_precondition_msg(tolerance > 0, "the tolerance is not positive");
    auto vpm = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                get_property_map(CGAL::vertex_point, output));
    if(has_built_cell(i))
      Surface_mesh_geodesics::internal::add_cell_mesh(m_lazy, i, tolerance, output, vpm, face_face_map);
  }

  /// adds a cell to a mesh, with `default_tolerance()`.
  ///
  /// \param i the number of the site
  /// \param output the mesh to which the faces are added
  /// \param face_face_map receives, for each new face, the face of the mesh that it lies in
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters", as above
  template <typename OutputMesh, typename FaceFaceMap, typename CGAL_NP_TEMPLATE_PARAMETERS>
  void cell_mesh(Site_index i, OutputMesh& output, FaceFaceMap face_face_map,
                 const CGAL_NP_CLASS& np = parameters::default_values()) const
  {
    cell_mesh(i, output, face_face_map, default_tolerance(), np);
  }

  /// returns the tolerance of functions that are called without one: a thousandth of the diagonal of the bounding box
  /// of the points of all vertices, in the unit of the mesh. Where all points are the same, as they may be if lengths
  /// come from a map of their own, it is a thousandth of a power of two that is about as large as the longest edge; of
  /// 1 if there are no sites.
  ///
  /// Takes time linear in the number of vertices: to draw many cells, call it once, and pass its result.
  double default_tolerance() const
  {
    const double diagonal
      = Surface_mesh_geodesics::internal::diagonal_of_bounding_box(triangle_mesh(), m_lazy.vertex_point_map());
    if(diagonal > 0 && diagonal < std::numeric_limits<double>::infinity())
      return diagonal / 1000;
    build();
    return m_lazy.unit() / 1000;
  }

  /// @}

  /// \name Points
  /// Points come from the point map, also if the lengths come from a map of their own.
  /// @{

  /// returns the point at a location. Takes constant time.
  ///
  /// \param location a face of the mesh and coordinates in it
  /// \pre The face is a face of the mesh. (This is not checked.)
  Point_3 point(const Face_location& location) const { return m_lazy.point(location); }

  /// returns the mesh.
  const Triangle_mesh& triangle_mesh() const { return m_lazy.mesh(); }

  /// @}

private:
  void check(Site_index i) const
  {
    CGAL_precondition_msg(i < number_of_sites(), "there is no site with this number");
    static_cast<void>(i);
  }

  bool has_built_cell(Site_index i) const
  {
    check(i);
    build();
    return m_lazy.has_cell(i);
  }

  const Elements& elements() const { return m_lazy.elements(); }

  const Elements& built_elements() const
  {
    build();
    return elements();
  }

  Surface_mesh_geodesics::internal::Lazy_Voronoi_diagram<Traits, Vertex_index_map, Face_index_map, Vertex_point_map,
                                                         Elements, ConcurrencyTag>
    m_lazy;
};

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_SURFACE_MESH_GEODESIC_VORONOI_DIAGRAM_H
