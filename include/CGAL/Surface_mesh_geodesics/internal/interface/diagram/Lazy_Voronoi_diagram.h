// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_LAZY_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_LAZY_VORONOI_DIAGRAM_H

// What Surface_mesh_geodesic_Voronoi_diagram knows, and when it computes it: the sites, the solver, the complex and the
// elements of the diagram, areas and centroids of cells, and the windows for distances at points of faces.
//
// One rule holds for all queries, as for shortest paths (Lazy_path_structure). A query is const, and computes what it
// needs under a mutex if that is missing. Once it is there, a query reads one atomic flag and takes no lock, so any
// number of threads may ask one object. Functions that are not const (sites, lengths, clear()) need the object for
// themselves.
//
// Results appear in three steps, each with its own flag: the diagram first, then the measures and the windows, in any
// order. Neither of these writes anything that other queries read.
//
// Who does what: Shared_computation guards each step. build_with() makes the diagram: give_sites_to_solver(),
// propagate_diagram(), and Voronoi_handles::collect(). measure_cells() and Path_solver::add_windows() are the other two
// steps.
//
// With Parallel_tag, several threads propagate and divide edges and faces, and one of them removes windows at the same
// time (Window_relay.h). The thread that computes holds the mutex, so while it waits for the others it must not start a
// query of the user (Tbb_team::run()).

#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Cell_locator.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Diagram_window_keeper.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_cell_measures.h>
#include <CGAL/Surface_mesh_geodesics/internal/Voronoi/Voronoi_complex.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Face_shapes.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Path_solver.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Surface_locations.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Cell_triangles.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Shared_computation.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/Weighted_site_list.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/measure_cells.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/diagram/propagate_diagram.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {

template <typename TriangleMesh>
class Surface_curve; // programs whose sites are points need no more

namespace internal {

// `Elements` is Voronoi_handles<Diagram>, where Diagram is the public class. The other parameters are those of the
// latter.
//
// Invariants: m_has_measures and m_has_windows imply m_is_built. While m_is_built is set, the sites, the mesh and the
// maps are those that the complex was made from; functions that change one of them call forget_diagram(). What a flag
// guards is written under a mutex before the flag is set (Shared_computation), and read after it was seen. The mesh is
// referred to, maps and traits are copied; all of them stay valid and unchanged until clear().
template <typename Traits, typename VertexIndexMap, typename FaceIndexMap, typename VertexPointMap, typename Elements,
          typename ConcurrencyTag = Sequential_tag>
class Lazy_Voronoi_diagram
{
public:
  using Locations = Surface_locations<Traits, VertexPointMap>;
  using Triangle_mesh = typename Locations::Triangle_mesh;
  using Graph_traits = typename Locations::Graph_traits;
  using vertex_descriptor = typename Locations::vertex_descriptor;
  using face_descriptor = typename Locations::face_descriptor;
  using edge_descriptor = typename Graph_traits::edge_descriptor;
  using FT = typename Locations::FT;
  using Point_3 = typename Locations::Point_3;
  using Barycentric_coordinates = typename Locations::Barycentric_coordinates;
  using Face_location = typename Locations::Face_location;
  using Coordinates = typename Locations::Coordinates;
  using Sites = Weighted_site_list<vertex_descriptor, Face_location, FT, Surface_curve<Triangle_mesh>>;
  using Solver = Path_solver<Triangle_mesh, VertexIndexMap, FaceIndexMap, ConcurrencyTag>;
  using Complex = Voronoi_complex<double>;

  // Stands for "no site" where a number of a site is returned.
  static constexpr std::size_t no_site = (std::numeric_limits<std::size_t>::max)();

  Lazy_Voronoi_diagram(const Triangle_mesh& tm, VertexIndexMap vertex_index_map, FaceIndexMap face_index_map,
                       VertexPointMap vertex_point_map, const Traits& traits, const Elements& elements)
    : m_traits(traits), m_tm(tm), m_vertex_index_map(vertex_index_map), m_face_index_map(face_index_map),
      m_vertex_point_map(vertex_point_map), m_solver(tm, vertex_index_map, face_index_map), m_elements(elements)
  {
    use_points();
  }

  Lazy_Voronoi_diagram(const Lazy_Voronoi_diagram&) = delete;
  Lazy_Voronoi_diagram& operator=(const Lazy_Voronoi_diagram&) = delete;

  const Triangle_mesh& mesh() const { return m_tm; }
  const VertexPointMap& vertex_point_map() const { return m_vertex_point_map; }

  // --- sites ---

  const Sites& sites() const { return m_sites; }

  // Adds a vertex, or a point of a face. build() rejects an invalid one.
  std::size_t add_site(vertex_descriptor v, const FT& weight) { return add({true, v, Face_location(), weight}); }

  std::size_t add_site(const Face_location& location, const FT& weight)
  {
    return add({false, Graph_traits::null_vertex(), location, weight});
  }

  // Adds a curve, which is copied. build() rejects one of another mesh. A curve of one location is a point. The list
  // keeps a function: programs without curves do not compile what runs from curves need.
  std::size_t add_site(const Surface_curve<Triangle_mesh>& curve, const FT& weight)
  {
    const auto& s = curve.segments();
    const bool is_vertex = s.empty();
    typename Sites::Site site{is_vertex, curve.vertex(), Face_location(), weight};
    if(!is_vertex)
      site.location = Face_location(s[0].face, Locations::coordinates(s[0].source, m_traits));
    if(s.size() > 1 || (!is_vertex && s[0].source != s[0].target))
    {
      const auto copy = std::make_shared<const Surface_curve<Triangle_mesh>>(curve);
      site.curve = copy;
      site.give_curve = [this, copy](double offset) { m_solver.add_source_curve(*copy, offset, "site"); };
    }
    return add(site);
  }

  // Removes the sites; the mesh that has been read stays.
  void remove_all_sites()
  {
    m_sites.clear();
    forget_diagram();
  }

  // Removes the sites, and reads the mesh again at the next build.
  void clear()
  {
    m_sites.clear();
    forget_mesh();
  }

  // Public functions return it: a site that is a curve is no single location, so users may ask for the curve, too.
  //
  // Returns the location of site i as the user gave it, for a vertex a corner of a face around it, for a curve that of
  // its first point. Returns the null location for a vertex that is in no face, or not in the mesh.
  Face_location location_of_site(std::size_t i) const
  {
    const typename Sites::Site& s = m_sites[i];
    if(!s.is_vertex)
      return s.location;
    return is_vertex_of(s.vertex, m_tm, m_vertex_index_map) ? Locations::location(s.vertex, m_tm, m_traits)
                                                            : Locations::null_location(m_traits);
  }

  // --- lengths: they are read by the next build, which rejects invalid ones. (The shortest paths read them at once.)

  template <typename EdgeLengthMap>
  void use_edge_lengths(EdgeLengthMap edge_length_map)
  {
    m_read_mesh = [this, edge_length_map]
    { m_solver.build_mesh(Shape_from_edge_lengths<double, Triangle_mesh, EdgeLengthMap>(m_tm, edge_length_map)); };
    forget_mesh();
  }

  void use_points()
  {
    m_read_mesh = [this]
    { m_solver.build_mesh(Shape_from_points<double, Triangle_mesh, VertexPointMap>(m_tm, m_vertex_point_map)); };
    forget_mesh();
  }

  // Leave faces out, or cut the surface along edges, from the next build on, in place of those of the last call. If
  // they throw Invalid_geodesic_input, nothing changes.
  template <typename Faces>
  void avoid_faces(const Faces& avoided)
  {
    avoid({flags_of_avoided_faces(m_tm, m_face_index_map, avoided), m_solver.obstacles().walls});
  }
  template <typename Edges>
  void avoid_edges(const Edges& avoided)
  {
    avoid({m_solver.obstacles().is_avoided, walls_of_edges(m_tm, m_face_index_map, avoided)});
  }
  bool avoids_face(face_descriptor f) const { return m_solver.is_avoided(f); }
  bool avoids_edge(edge_descriptor e) const { return is_wall_of(e, m_tm, m_face_index_map, m_solver.obstacles()); }
  bool has_walls() const { return !m_solver.obstacles().walls.empty(); }

  // --- building: all functions throw Invalid_geodesic_input if the mesh or a site is invalid ---

  bool is_built() const { return m_is_built.load(std::memory_order_acquire); }

  void build() const
  {
    build_with([](auto propagate) { return propagate([](std::size_t, double) { return true; }); });
  }

  // Returns false if the visitor cancels; nothing is known then, and the next query builds from the start.
  template <typename Visitor>
  bool build(Visitor& visitor) const
  {
    return build_with([&](auto propagate) { return run_with_visitor(visitor, num_vertices(m_tm), propagate); });
  }

  // What the propagation did, and how many windows the diagram kept: the largest number at one time, and the number
  // without the removal of redundant ones. Both build the diagram. Nothing that runs later in const functions changes
  // these figures.
  Propagation_statistics statistics() const
  {
    build();
    return m_statistics;
  }

  std::pair<std::size_t, std::size_t> number_of_kept_windows() const
  {
    build();
    return m_kept_windows;
  }

  // --- what is built; all functions require is_built() ---

  const Complex& complex() const
  {
    CGAL_assertion(is_built());
    return m_complex;
  }

  const Elements& elements() const
  {
    CGAL_assertion(is_built());
    return m_elements;
  }

  // Returns the number of the site of a cell of the complex, no_site for null_id. The complex names a cell by the
  // vertex of its site in the refined mesh; with curves among the sites, or sites on walls, by the number of the site
  // (propagate_diagram.h).
  std::size_t site_at(Vertex_id cell) const
  {
    return cell == null_id ? no_site : has_numbers() ? std::size_t(cell) : m_solver.source_at(cell);
  }

  // Returns the cell of a site. Several sites may be at one vertex.
  Vertex_id cell_of_site(std::size_t i) const
  {
    return has_numbers() ? static_cast<Vertex_id>(i) : m_solver.sources().vertices[i];
  }

  // Returns whether the site has a cell: no other site is nearer to its own point, ties there and comes first, or has
  // been united with it (Redundant_window_removal::unite()). A cell with a number has a part of an edge or a vertex.
  bool has_cell(std::size_t i) const
  {
    const Vertex_id v = cell_of_site(i);
    if(has_numbers())
      return complex().cell(v).edge_intervals + complex().cell(v).vertices > 0;
    return complex().owner(v) == v && m_solver.source_at(v) == i;
  }

  // Returns which parts the cell of a site may have. Linear in the number of points on walls.
  Cell_parts parts_of_cell(std::size_t i) const
  {
    const std::vector<std::size_t>& on_walls = m_solver.sources().behind_walls;
    if(has_walls() && (m_solver.has_curves() || std::find(on_walls.begin(), on_walls.end(), i) != on_walls.end()))
      return Cell_parts::ANY;
    return m_sites[i].curve != nullptr ? Cell_parts::WITH_ARCS : Cell_parts::ONE;
  }

  // Returns the factor from lengths of the intrinsic mesh to those of the user: a power of two, 1 if there is no site.
  double unit() const { return m_sites.empty() ? 1. : m_solver.unit(); }

  // Returns a distance of the propagation in the user's unit, less the weight of its site. The offset of a site is the
  // largest weight minus its own (Weighted_site_list.h), so that only the largest weight is left to subtract.
  FT user_distance(double d) const { return FT(d * m_solver.unit() - m_largest_weight); }

  face_descriptor user_face(Face_id f) const { return m_solver.user_face(f); }

  // Returns the location on the user's mesh of a point in the layout of a face of the refined mesh.
  Face_location location(Face_id f, const Planar_point<double>& p) const
  {
    const auto l = m_solver.user_location(f, complex().coordinates(f, p));
    return Face_location(l.first, Locations::coordinates(l.second, m_traits));
  }

  // Returns the location of a corner of a face of the refined mesh.
  Face_location location_of_corner(Face_id f, unsigned int k) const
  {
    Coordinates b{};
    b[k] = 1;
    const auto l = m_solver.user_location(f, b);
    return Face_location(l.first, Locations::coordinates(l.second, m_traits));
  }

  const Intrinsic_mesh<double>& refined_mesh() const { return m_solver.mesh(); }

  // Returns the point of a vertex of the refined mesh: of the user's mesh, of a site, or of a curve.
  Point_3 point_of_vertex(Vertex_id v) const
  {
    const vertex_descriptor user = m_solver.user_vertex(v);
    if(m_solver.has_curves() && user == Graph_traits::null_vertex())
    {
      const Halfedge_id h = m_solver.mesh().halfedge(v);
      return point(location_of_corner(face_of(h), index_in_face(h)));
    }
    return user != Graph_traits::null_vertex() ? Point_3(get(m_vertex_point_map, user))
                                               : point(location_of_site(m_solver.source_at(v)));
  }

  // Returns whether the site of a cell is a curve; one of a single location is a point.
  bool is_cell_of_curve(Vertex_id cell) const { return has_numbers() && m_sites[cell].curve != nullptr; }

  // Returns the point of the site of a cell. Requires: the site is a point.
  Point_3 point_of_cell(Vertex_id cell) const { return has_numbers() ? point_of_site(cell) : point_of_vertex(cell); }

  // --- queries: they build what they need ---

  // Both return the site whose cell a point is in, no_site if none reaches it. A point of a wall is in a cell on each
  // side; the side that is nearest to its site counts. They throw Invalid_geodesic_input for a vertex or location that
  // is not on the mesh, also if there are no sites. A vertex takes constant time; a location takes the time of
  // Cell_locator if arcs run through its face, constant time otherwise. Windows are needed on a wall between two cells.
  std::size_t nearest_site(vertex_descriptor v) const
  {
    build();
    const typename Solver::Query q = query(v);
    return m_sites.empty() ? no_site : site_at(m_complex.owner(q.vertex));
  }

  std::size_t nearest_site(face_descriptor f, const Barycentric_coordinates& location) const
  {
    build();
    const typename Solver::Query q = query(f, location);
    if(m_sites.empty())
      return no_site;
    const Vertex_id cell = cell_at(q);
    bool is_same = true;
    m_solver.for_each_other_side(q, [&](const auto& other) { is_same = is_same && cell_at(other) == cell; });
    if(is_same)
      return site_at(cell);
    add_windows_for(q);
    return site_at(cell_at(m_solver.nearest_side(q)));
  }

  // Returns all sites that have the nearest point, in ascending order. A place is a vertex, or a face and coordinates.
  // With curves, the path tells the point, as the run has kept its windows; without, the cell does.
  template <typename... Place>
  std::vector<std::size_t> nearest_sites(const Place&... place) const
  {
    build();
    if(m_solver.has_curves())
      return sites_at_end_of_path(m_solver, m_solver.arrival(m_solver.nearest_side(query(place...))));
    const std::size_t i = nearest_site(place...);
    return i == no_site ? std::vector<std::size_t>() : sites_at_point_of(m_solver, m_complex, i, cell_of_site(i));
  }

  // Returns the distance of a place to the nearest site, less its weight; -1 if no site reaches it. A location that is
  // neither a vertex nor a site needs windows, which the first such query computes by one more propagation. With a
  // positive weight, -1 may be a distance, too; nearest_site() tells.
  template <typename... Place>
  FT distance_to_nearest_site(const Place&... place) const
  {
    build();
    const typename Solver::Query q = query(place...);
    if(m_sites.empty())
      return FT(-1);
    add_windows_for(q);
    return user_distance(m_solver.arrival(m_solver.nearest_side(q)));
  }

  std::vector<typename Elements::Arc> arcs(face_descriptor f) const
  {
    build();
    return m_elements.arcs_in_face(face_index(f));
  }

  // Returns the area of the cell of site i, 0 for an empty cell. The first query of a measure takes linear time.
  FT area(std::size_t i) const
  {
    build();
    const double u = unit();
    return FT(measures().area(cell_or_null(i)) * u * u);
  }

  // Returns the centroid of the cell of site i, the point of the site if the cell has no area.
  Point_3 centroid(std::size_t i) const
  {
    build();
    const std::array<double, 3> c = measures().centroid(cell_or_null(i));
    return std::isfinite(c[0]) ? Point_3(c[0], c[1], c[2]) : point_of_site(i);
  }

  Point_3 point(const Face_location& location) const
  {
    return Locations::point(location.first, location.second, m_tm, m_vertex_point_map, m_traits);
  }

private:
  // What propagates and makes the complex: with Parallel_tag, all threads divide edges and faces.
  using Building
    = Diagram_propagation<double, std::is_same<typename Available_tag<ConcurrencyTag>::type, Parallel_tag>::value>;
  using Measures = Voronoi_cell_measures;

  // --- forgetting ---

  // Adds a site and forgets the diagram. If the site is rejected, nothing changes.
  std::size_t add(const typename Sites::Site& site)
  {
    const std::size_t i = m_sites.add(site);
    forget_diagram();
    return i;
  }

  // Lets the next build read the mesh again.
  void forget_mesh()
  {
    m_solver.forget();
    m_statistics = Propagation_statistics();
    forget_diagram();
  }

  void avoid(Obstacles obstacles)
  {
    forget_mesh();
    m_solver.avoid(std::move(obstacles));
  }

  // Does nothing unless the diagram is built: sites are added one after the other, and clearing tables takes time that
  // depends on their former size.
  void forget_diagram()
  {
    if(!is_built())
      return;
    m_is_built = false;
    m_has_measures = false;
    m_has_windows = false;
    clear_diagram();
  }

  void clear_diagram() const
  {
    m_complex.clear();
    m_elements.clear();
  }

  // Clears what has been made of a diagram if building ends early, by a visitor or by an exception.
  struct Unfinished_diagram
  {
    const Lazy_Voronoi_diagram* diagram;

    ~Unfinished_diagram()
    {
      if(diagram != nullptr)
        diagram->clear_diagram();
    }
  };

  // --- computing ---

  // `run(propagate)` calls propagate(go_on) and returns its result, which is false if go_on() ends the propagation.
  template <typename Run>
  bool build_with(Run run) const
  {
    return m_computation.run_once(m_is_built, [&]
    {
      give_sites_to_solver();
      Unfinished_diagram unfinished{this};
      if(!propagate_diagram<Building>(m_solver, m_complex, m_largest_weight, run, m_kept_windows))
        return false;
      m_statistics = m_solver.statistics();
      m_elements.collect(m_complex, [this](Vertex_id v) { return site_at(v); },
                         [this](Face_id f) { return face_index(m_solver.user_face(f)); });
      unfinished.diagram = nullptr;
      m_has_windows = m_solver.has_curves(); // a run from curves keeps them
      return true;
    });
  }

  // Reads the mesh unless that is done, and hands the sites over as sources, in their order. Throws for an invalid mesh
  // or site.
  void give_sites_to_solver() const
  {
    m_largest_weight = m_sites.largest_weight();
    if(!m_solver.has_mesh())
      m_read_mesh();
    give_sites(m_sites, m_solver, [this](const Barycentric_coordinates& b) { return weights(b); });
  }

  // Propagates once more on the same mesh and keeps all windows: the diagram has removed those that it does not need.
  void add_windows() const
  {
    m_computation.run_once(m_has_windows,
                           [&] { return m_solver.add_windows([](std::size_t, double) { return true; }); });
  }

  // Adds the windows if the distance of a point needs them on one of its sides.
  void add_windows_for(const typename Solver::Query& q) const
  {
    bool needs_windows = m_solver.needs_windows(q);
    m_solver.for_each_other_side(q, [&](const typename Solver::Query& other)
    { needs_windows = needs_windows || m_solver.needs_windows(other); });
    if(needs_windows)
      add_windows();
  }

  // Requires: the diagram is built.
  const Measures& measures() const
  {
    m_computation.run_once(m_has_measures, [&]
    {
      measure_cells(*this, m_measures);
      return true;
    });
    return m_measures;
  }

  // --- helpers ---

  // Does the complex name cells by numbers? Requires: it has been started.
  bool has_numbers() const { return m_complex.has_numbers_of_sites(); }

  typename Solver::Query query(vertex_descriptor v) const { return m_solver.query(v); }

  typename Solver::Query query(face_descriptor f, const Barycentric_coordinates& location) const
  {
    return m_solver.query(f, weights(location));
  }

  // Returns the cell of a point, on the side of a wall where the query is.
  Vertex_id cell_at(const typename Solver::Query& q) const
  {
    if(q.vertex != null_id)
      return m_complex.owner(q.vertex);
    const Planar_point<double> p = point_of_triangle(m_complex.layout(q.face), q.coordinates);
    return Cell_locator<double>(m_complex, q.face, p).cell();
  }

  // Returns the cell of site i, null_id if it has none.
  Vertex_id cell_or_null(std::size_t i) const { return has_cell(i) ? cell_of_site(i) : null_id; }

  FT user_distance(const typename Solver::Arrival& a) const
  {
    return a.is_reached() ? user_distance(a.distance) : FT(-1);
  }

  // Returns the point of site i, also for a vertex in no face, which has no location.
  Point_3 point_of_site(std::size_t i) const
  {
    const typename Sites::Site& s = m_sites[i];
    return s.is_vertex ? Point_3(get(m_vertex_point_map, s.vertex)) : point(s.location);
  }

  std::size_t face_index(face_descriptor f) const { return static_cast<std::size_t>(get(m_face_index_map, f)); }

  Coordinates weights(const Barycentric_coordinates& location) const { return Locations::weights(location, m_traits); }

  const Traits m_traits;
  const Triangle_mesh& m_tm;
  VertexIndexMap m_vertex_index_map;
  FaceIndexMap m_face_index_map;
  VertexPointMap m_vertex_point_map;
  Sites m_sites;
  // Builds the intrinsic mesh from points or from lengths, at the next build. A function object hides the type of the
  // map of lengths. It refers to this object, which can therefore be neither copied nor moved.
  std::function<void()> m_read_mesh;

  mutable Shared_computation m_computation;
  mutable std::atomic<bool> m_is_built{false}, m_has_measures{false}, m_has_windows{false};
  mutable Solver m_solver;

  // Valid if m_is_built.
  mutable Complex m_complex;
  mutable Elements m_elements;
  mutable double m_largest_weight = 0;
  mutable Propagation_statistics m_statistics;
  mutable std::pair<std::size_t, std::size_t> m_kept_windows;

  mutable Measures m_measures; // valid if m_has_measures
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_DIAGRAM_LAZY_VORONOI_DIAGRAM_H
