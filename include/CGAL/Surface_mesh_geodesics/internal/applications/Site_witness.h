// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_SITE_WITNESS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_SITE_WITNESS_H

// What the certifier of diagrams knows of distances by itself. The mesh is read again, with all sites as vertices, and
// curves as edges. One propagation from all sites, with what each weight lacks to the largest one as the offset, gives
// paths and proposes a function on the edges; prove() checks both as the certificate of distances does. Then the
// function is a lower bound of the distance of each point from the nearest site, less its weight.
//
// Paths from a site that is not the nearest one anywhere around a point, and of two that tie, may be missing.
// run_from() propagates from one site alone.
//
// Who proposes, and who judges: the propagations propose paths by their windows, and the function. Distance_checks
// measures the paths to the vertices and compares their lengths with what the diagram states; Lower_bound_check
// verifies the function. Paths to other points are not measured again: they are the straight pieces behind windows,
// from vertices whose paths are, and the rays of strips.
//
// With curves, the witness knows of ties what Source_curves says: a vertex or an edge of several curves belongs to one
// of them. A run from one curve starts at the edges that belong to it. These are a part of the curve, so that its paths
// are right, but may be longer than others from the same curve. Then a right diagram may be refused, and never a wrong
// one accepted. It does not happen in general: points that are nearest to an edge of two curves belong to the one that
// the edge belongs to, in the diagram as well.
//
// Faces that the diagram avoids are left out when the mesh is read. There are no walls: diagrams with walls
// go without a witness (Diagram_certifier::run()).
//
// Unit: lengths and distances are those of the intrinsic mesh. A distance here includes the offset of its site;
// user_distance() has the distance of the user, less the weight.

#include <CGAL/Surface_mesh_geodesics/internal/applications/Diagram_conditions.h>
#include <CGAL/Surface_mesh_geodesics/Propagation_statistics.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Distance_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Edge_distance_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Face_paths.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Lower_bound_check.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Lower_bound_function.h>
#include <CGAL/Surface_mesh_geodesics/internal/certificate/Worst_violation.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Surface_with_sources.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/source_range.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/One_block.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/planar_geometry.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Distance_propagation.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/curves/Path_run_from_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/curves/Source_curves.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Face_parts.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Location_in_part.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/equal_sources.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Edge_window_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/Pruning_rules.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Curve_arrivals.h>
#include <CGAL/Surface_mesh_geodesics/internal/window/strips/Strip.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// A point of the surface: a point in the layout of a face of the refined mesh, which may be a vertex of it. A vertex
// without faces has the face null_id.
struct Witness_place
{
  Face_id face = null_id;
  Planar_point<double> point;
  Barycentric<double> coordinates{}; // of the point in the face
  Vertex_id vertex = null_id;
};

// Use: prove(), then the rest. The diagram is referred to; it tells its mesh, its sites and their weights, and which
// faces it avoids. The index maps are copied.
template <typename Diagram, typename VertexIndexMap, typename FaceIndexMap>
class Site_witness
{
  using Triangle_mesh = typename Diagram::Triangle_mesh;
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Face_location = typename Diagram::Face_location;
  using Paths = Face_paths<double>;

public:
  static constexpr std::size_t no_site() { return Paths::none; }

  // Reads the mesh. Shape is described in Face_shapes.h. Throws Invalid_geodesic_input for an invalid mesh or site. A
  // site at a vertex without faces has no location, and is left out.
  template <typename Shape>
  Site_witness(const Diagram& diagram, VertexIndexMap vim, FaceIndexMap fim, Shape shape)
    : m_diagram(diagram), m_surface(diagram.triangle_mesh(), vim, fim),
      m_function(m_surface.mesh(), m_field.distance, m_windows, &m_curves.strips)
  {
    const auto avoids = boost::make_function_property_map<face_descriptor, bool>(
      [&](face_descriptor f) { return diagram.avoids_face(f); });
    m_surface.avoid(Obstacles{flags_of_avoided_faces(diagram.triangle_mesh(), fim, avoids), {}});
    m_surface.read(std::move(shape), One_block());
    m_largest_weight = -std::numeric_limits<double>::infinity();
    for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
      m_largest_weight = (std::max)(m_largest_weight, weight(i));
    for(std::size_t i = 0; i < diagram.number_of_sites(); ++i)
      if(diagram.site(i).first != Graph_traits::null_face())
      {
        if(diagram.site_curve(i) != nullptr)
          m_surface.add_source_curve(*diagram.site_curve(i), offset(i), "site");
        else
          m_surface.add_source(diagram.site(i), offset(i), "site");
        m_site_of_source.push_back(i);
      }
    insert_sources();
  }

  const Intrinsic_mesh<double>& mesh() const { return m_surface.mesh(); }

  // What the diagram calls the distance: that of the user, less the weight of the site. Rounds to the size of the
  // largest weight, which the comparison allows.
  double user_distance(double d) const { return d * mesh().unit() - m_largest_weight; }
  double own_distance(double user_distance) const { return (user_distance + m_largest_weight) / mesh().unit(); }

  // What is added to distances from site i, in the user's unit: 0 for the site with the largest weight. A site whose
  // weight is far smaller has a large offset, and owns nothing.
  double offset(std::size_t i) const { return m_largest_weight - weight(i); }

  // --- places ---

  // Throw Invalid_geodesic_input for a point that is not on the mesh. A point of an edge is found in one of the faces
  // there.
  Witness_place place(vertex_descriptor v) const { return place_of(m_surface.query(v)); }
  Witness_place place(const Face_location& l) const { return place_of(m_surface.query(l.first, l.second)); }

  // Finds a place in the layout of a face; returns false if it is not in that face. A place on the border between two
  // parts of a divided face is in both, up to the rounding of its coordinates (Location_in_part.h): an arc along that
  // border is in either of them.
  bool find_in_face(const Witness_place& place, Face_id f, Planar_point<double>& p) const
  {
    p = place.point;
    if(place.face == f)
      return true;
    for(unsigned int k = 0; k < 3; ++k)
      if(place.vertex != null_id && mesh().face(f).vertex[k] == place.vertex)
      {
        p = layout_of_face(mesh().face(f))[k];
        return true;
      }
    return find_in_part(place, f, p);
  }

  // --- the proof ---

  // Propagates, and checks the distances that the diagram states for the vertices of the mesh as the certificate of
  // distances does, with its loops over `chunks` (Chunk_team.h). The worst violation of all conditions is recorded; its
  // site is the nearest one of the vertex where it is. Takes the time and the memory of certify_geodesic_distances()
  // without reverse runs.
  template <typename Chunks>
  void prove(const Chunks& chunks, Diagram_violation& result)
  {
    propagate(m_field, m_windows, m_curves, [](std::size_t) { return true; });
    find_ties();
    find_sites_of_vertices();
    const double infinity = std::numeric_limits<double>::infinity();
    const auto go_on = [] { return true; };
    Distance_checks<double> checks(mesh(), stated_distances());
    Worst_violation<double> at_sources;
    for(const auto& s : m_vertices)
    {
      const Vertex_id v = s.first;
      checks.add_source(v, s.second);
      at_sources.record(m_field.distance[v] - s.second, m_field.distance[v], checks.extents()[v], v);
    }
    m_curves.curves.for_each_edge_with_length([&](Halfedge_id h, double offset_of_edge)
    { checks.add_source_edge(h, offset_of_edge); });
    const Curve_arrivals<double>* const curves = has_curves() ? &m_curves : nullptr;
    for(const Worst_violation<double>& w :
        {checks.check_reach(infinity), checks.check_sources(infinity), checks.check_edges(infinity),
         checks.check_pairs_of_faces(infinity), checks.check_paths(chunks, m_field, infinity, go_on, curves),
         checks.check_lower_bounds(m_field.distance, infinity), at_sources,
         prove_lower_bounds(chunks, m_function, checks.extents(), go_on)})
      add(w, result);
    // The function has been made; what it proves needs its values on the curves, between their vertices as well.
    Worst_violation<double> on_edges;
    m_curves.curves.for_each_edge_with_length([&](Halfedge_id h, double offset_of_edge)
    { record_excess_on_edge(m_function, h, offset_of_edge, checks.extents(), on_edges); });
    add(on_edges, result);
  }

  // Calls visit(i, segment, t) for points of the curves that show whether their cells are complete: the ends and the
  // middle of each piece of the lower bound on each edge, of curve i, at t of one of its segments (Surface_curve).
  // Along an edge the nearest site changes at the ends of pieces only; other curves cross it in its ends. Linear in the
  // number of pieces. Requires: prove() has been called.
  template <typename Visit>
  void for_each_point_of_curves(Visit visit) const
  {
    std::vector<Distance_piece<double>> pieces;
    for(const Source_edge<double>& e : m_curves.curves.edges)
    {
      const auto visit_at = [&](double t)
      {
        visit(m_site_of_source[e.curve], std::size_t(e.segment),
              e.first_parameter + (e.last_parameter - e.first_parameter) * t);
      };
      visit_at(0);
      visit_at(1);
      if(!(e.length > 0))
        continue;
      m_function.read(e.left != null_id ? e.left : e.right, e.left == null_id, pieces);
      for(const Distance_piece<double>& p : pieces)
      {
        if(p.begin > 0)
          visit_at(p.begin / e.length);
        visit_at((p.begin + p.end) / 2 / e.length);
      }
    }
  }

  // --- paths, once they are proved ---

  // Returns the distance of a vertex from the nearest site, and the number of that site; infinity and no_site() for a
  // vertex that none reaches.
  double distance(Vertex_id v) const { return m_field.distance[v]; }
  std::size_t site(Vertex_id v) const { return m_site_of_vertex[v]; }

  // Where the sites lie in a face, it is divided: `f` is a part of it. A read takes time linear in the number of
  // windows.
  //
  // Reads the paths into a face: those that have been found, and those of the function that is a lower bound.
  void read_paths(Face_id f, Paths& paths) const
  {
    paths.start_windows(
      mesh(), m_field, m_windows, m_curves.strips, [this](Vertex_id v) { return m_site_of_vertex[v]; },
      [this](const Strip<double>& s) { return m_site_of_source[m_curves.edge_of_side(s.side).curve]; }, f);
  }
  void read_bound(Face_id f, Paths& paths) const { paths.start_function(m_function, f); }

  // Propagates from one site, in place of the site before. Then read_paths_from_one() has the paths from it.
  void run_from(std::size_t i)
  {
    m_runs_from = i;
    const auto is_wanted = [&](std::size_t k) { return m_site_of_source[k] == i; };
    if(has_curves())
      m_curves_of_one.set_curves(part_of_curves(is_wanted));
    propagate(m_field_of_one, m_windows_of_one, m_curves_of_one, is_wanted);
  }

  void read_paths_from_one(Face_id f, Paths& paths) const
  {
    paths.start_windows(
      mesh(), m_field_of_one, m_windows_of_one, m_curves_of_one.strips, [this](Vertex_id) { return m_runs_from; },
      [this](const Strip<double>&) { return m_runs_from; }, f);
  }

  // Calls visit(i, j, is_decided) for each site i that ties with a site j, which has its cell by the rule for ties
  // (equal_sources.h): of several sites at one vertex the first one with the largest weight, and of several within
  // rounding the first one. If another site is nearer to j by the least difference, j itself has no cell; so the tie is
  // not decided, and one of the two has no cell (Vertex_owners.h). With curves, these are the sites to which no vertex
  // belongs; j is another site then, and it is decided.
  template <typename Visit>
  void for_each_tie(Visit visit) const
  {
    if(has_curves())
    {
      std::vector<char> has_vertex(m_site_of_source.size(), 0);
      for(const Source_vertex<double>& v : m_curves.curves.vertices)
        has_vertex[v.point.curve] = 1;
      for(std::size_t k = 0; k < has_vertex.size(); ++k)
        if(has_vertex[k] == 0 && !has_edge(k))
          visit(m_site_of_source[k], m_site_of_source[k], true);
      return;
    }
    const auto& sources = m_surface.sources();
    for(std::size_t k = 0; k < sources.size(); ++k)
    {
      const Vertex_id v = sources.vertices[k];
      const auto it = m_receiver.find(v);
      if(m_surface.source_at(v) != k)
        visit(m_site_of_source[k], m_site_of_source[m_surface.source_at(v)], true);
      else if(it != m_receiver.end())
        visit(m_site_of_source[k], m_site_of_source[m_surface.source_at(it->second)], m_field.is_source(it->second));
    }
  }

private:
  using Field = Vertex_distance_field<double>;
  using Windows = Edge_window_field<double>;
  using Surface = Surface_with_sources<Triangle_mesh, VertexIndexMap, FaceIndexMap>;

  double weight(std::size_t i) const { return CGAL::to_double(m_diagram.weight(i)); }

  // Does the same for another part of the user's face in which the place is.
  bool find_in_part(const Witness_place& place, Face_id f, Planar_point<double>& p) const
  {
    const Face_part<double>* const part = m_surface.parts().find_part_of(f);
    if(place.face == null_id || part == nullptr)
      return false;
    Barycentric<double> in_whole = place.coordinates;
    if(m_surface.parts().coordinates_in_whole(place.face, in_whole) != part->whole)
      return false;
    Location_in_part<double> location(part->corner, in_whole);
    if(!location.is_known())
      return false;
    location.snap();
    if(location.least_coordinate() < 0)
      return false;
    p = point_of_face(f, location.coordinates());
    return true;
  }

  Planar_point<double> point_of_face(Face_id f, const Barycentric<double>& b) const
  {
    return point_of_triangle(layout_of_face(mesh().face(f)), b);
  }

  // A vertex is found in the face of one of its halfedges.
  Witness_place place_of(const Surface_query& q) const
  {
    Witness_place result;
    result.face = q.face;
    result.vertex = q.vertex;
    const Halfedge_id h = q.face == null_id ? mesh().halfedge(q.vertex) : null_id;
    if(q.face == null_id && h == null_id)
      return result;
    result.coordinates = q.coordinates;
    if(h != null_id)
    {
      result.face = face_of(h);
      result.coordinates = {0, 0, 0};
      result.coordinates[index_in_face(h)] = 1;
    }
    result.point = point_of_face(result.face, result.coordinates);
    return result;
  }

  // --- curves ---

  // Is there a curve among the sites? Then points are curves without length, and all sites are numbered by curves.
  bool has_curves() const { return m_curve_run != nullptr; }

  // Makes vertices of all sites, and edges of curves.
  void insert_sources()
  {
    if(!m_surface.has_curves())
    {
      m_surface.insert_sources();
      const auto& sources = m_surface.sources();
      for(std::size_t k = 0; k < sources.size(); ++k)
        m_vertices.emplace_back(sources.vertices[k], sources.offset(k));
      return;
    }
    m_curve_run.reset(new Strip_path_run<double>());
    m_surface.insert_curves([&](const auto& curves, Source_insertion<double>& insertion)
    { m_curve_run->insert(mesh(), insertion, curves, m_curves); });
    for(const Source_vertex<double>& v : m_curves.curves.vertices)
      m_vertices.emplace_back(v.vertex, v.offset);
  }

  // Does an edge belong to source k? A curve whose vertices all belong to others may still have an edge of its own.
  // Linear in the number of edges; few sources have no vertex.
  bool has_edge(std::size_t k) const
  {
    return std::any_of(m_curves.curves.edges.begin(), m_curves.curves.edges.end(),
                       [&](const Source_edge<double>& e) { return e.curve == k; });
  }

  // The edges and the vertices that belong to the wanted sources. Ends of an edge may belong to others; then they count
  // as points of the edge.
  template <typename IsWanted>
  Source_curves<double> part_of_curves(IsWanted is_wanted) const
  {
    Source_curves<double> result;
    for(const Source_vertex<double>& v : m_curves.curves.vertices)
      if(is_wanted(v.point.curve))
        result.vertices.push_back(v);
    for(const Source_edge<double>& e : m_curves.curves.edges)
      if(is_wanted(e.curve))
      {
        result.edges.push_back(e);
        result.vertices.push_back({e.first, e.offset, {e.curve, e.segment, e.first_parameter}});
        result.vertices.push_back({e.last, e.offset, {e.curve, e.segment, e.last_parameter}});
      }
    // Vertices that belong to the source come first, so that these copies are kept: they name the point of the curve.
    const auto by_vertex = [](const Source_vertex<double>& a, const Source_vertex<double>& b)
    { return a.vertex < b.vertex; };
    std::stable_sort(result.vertices.begin(), result.vertices.end(), by_vertex);
    result.vertices.erase(std::unique(result.vertices.begin(), result.vertices.end(),
                                      [](const Source_vertex<double>& a, const Source_vertex<double>& b)
                                      { return a.vertex == b.vertex; }),
                          result.vertices.end());
    return result;
  }

  // --- runs ---

  // Propagates from the sources k with is_wanted(k), and keeps the windows. Offsets are those of all sites, so that
  // distances from one site compare with those from all of them. With curves, `curves` has the wanted sources already,
  // and gets the strips.
  template <typename IsWanted>
  void propagate(Field& field, Windows& windows, Curve_arrivals<double>& curves, IsWanted is_wanted)
  {
    const auto& sources = m_surface.sources();
    windows.reset(mesh().number_of_faces());
    field.keeps_images = true;
    // Points and curves start in one run. Feet are written again in each run: they are those of the last one.
    if(has_curves())
    {
      Propagation_statistics statistics;
      m_curve_run->run(mesh(), field, Window_keeper<double>(windows), curves, false,
                       [](std::size_t, double) { return true; }, statistics);
      return;
    }
    Distance_propagation<double, All_pruning_rules, Window_keeper<double>> propagation(mesh(), field,
                                                                                      Window_keeper<double>(windows));
    for(std::size_t k = 0; k < sources.size(); ++k)
      if(is_wanted(k))
        propagation.add_source(sources.vertices[k], sources.offset(k));
    propagation.run([](std::size_t, double) { return true; });
  }

  void find_ties()
  {
    if(has_curves())
      return;
    const auto& sources = m_surface.sources();
    std::vector<double> offsets;
    for(std::size_t k = 0; k < sources.size(); ++k)
      offsets.push_back(sources.offset(k));
    m_receiver.clear();
    for_each_equal_source(mesh(), sources.vertices, offsets,
                          [&](Vertex_id v, Vertex_id u) { m_receiver.emplace(v, u); });
  }

  // Returns the site whose cell the paths from a vertex lead through: that of the source there, or one that it ties
  // with. The paths of both are equally long up to rounding, and the diagram names one of them only.
  std::size_t owner(Vertex_id source) const
  {
    if(has_curves())
      return m_site_of_source[m_curves.point_of(m_field, source).curve];
    const auto it = m_receiver.find(source);
    const bool is_given = it != m_receiver.end() && m_field.is_source(it->second);
    return m_site_of_source[m_surface.source_at(is_given ? it->second : source)];
  }

  // Finds the site of each vertex of the refined mesh that is reached, from that of its root. Takes linear time: each
  // chain of roots ends where a chain before it has been. (A vertex that a strip has reached is its own root.)
  void find_sites_of_vertices()
  {
    m_site_of_vertex.assign(mesh().number_of_vertices(), no_site());
    std::vector<Vertex_id> chain;
    for(const Vertex_id reached : m_field.reached)
    {
      Vertex_id v = reached;
      for(; m_site_of_vertex[v] == no_site() && !m_field.is_source(v) && m_field.arrival[v].root != v;
          v = m_field.arrival[v].root)
        chain.push_back(v);
      if(m_site_of_vertex[v] == no_site())
        m_site_of_vertex[v] = owner(v);
      for(const Vertex_id w : chain)
        m_site_of_vertex[w] = m_site_of_vertex[v];
      chain.clear();
    }
  }

  // What the diagram states for the vertices of the mesh. A vertex without faces counts as not reached.
  std::vector<double> stated_distances() const
  {
    std::vector<double> values(m_surface.surface().number_of_vertices(), std::numeric_limits<double>::infinity());
    for(Vertex_id v = 0; v < values.size(); ++v)
    {
      const vertex_descriptor u = m_surface.surface().descriptor(v);
      if(mesh().halfedge(v) != null_id && m_diagram.nearest_site(u) != Diagram_violation::no_site())
        values[v] = own_distance(CGAL::to_double(m_diagram.distance_to_nearest_site(u)));
    }
    return values;
  }

  // Adds one condition to the record of all: its worst violation, and its number of checks.
  void add(const Worst_violation<double>& w, Diagram_violation& result) const
  {
    const std::size_t before = result.number_of_checks;
    result.record(w.size, w.vertex == null_id ? no_site() : m_site_of_vertex[w.vertex]);
    result.number_of_checks = before + w.number_of_checks;
  }

  // The function refers to the mesh of the surface, and to the field, the windows and the strips of the run from all
  // sites.
  const Diagram& m_diagram;
  Surface m_surface;
  double m_largest_weight = 0;
  std::vector<std::size_t> m_site_of_source; // by number of the source; a site without a location is no source
  std::unordered_map<Vertex_id, Vertex_id> m_receiver; // of the cell of a source that ties with another one
  Field m_field, m_field_of_one;             // of the runs from all sites, and from one
  Windows m_windows, m_windows_of_one;
  Curve_arrivals<double> m_curves, m_curves_of_one; // with curves, all sites are curves: points are some without length
  std::unique_ptr<Path_run_from_curves<double>> m_curve_run; // set if there are curves
  std::vector<std::pair<Vertex_id, double>> m_vertices;      // at which sites are, with offsets
  std::size_t m_runs_from = 0;               // the site of the run from one
  std::vector<std::size_t> m_site_of_vertex; // of the refined mesh
  Lower_bound_function<double> m_function;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_APPLICATIONS_SITE_WITNESS_H
