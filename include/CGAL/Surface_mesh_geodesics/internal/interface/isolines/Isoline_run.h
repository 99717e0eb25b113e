// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_RUN_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_RUN_H

// What geodesic_isolines() does behind its documentation: one propagation that finds the lines of given distances on
// its way, and the distances of the vertices if they are wanted. (Path_solver keeps all windows, and finds lines of any
// distance afterwards.)
//
// As for distances, only the components are read that sources can reach. As for paths, sources in faces stay vertices
// of the refined mesh after the run, and curves stay edges: points of lines lie on edges of that mesh, and Face_parts
// leads back to the faces of the user. All lines are in memory, as numbers of halfedges, before the first one is
// written.
//
// Memory. The sweep has a few bytes for each face and each vertex, windows and strips along the wavefront, and the
// points of the lines. The mesh and the distances, which every run needs, take far more.

#include <CGAL/Surface_mesh_geodesics/internal/interface/Intrinsic_surface.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/Surface_locations.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/distance_functions.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/isolines/Isoline_sources.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_values.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/path_visitors.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/run_with_visitor.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Tolerance.h>
#include <CGAL/Surface_mesh_geodesics/internal/paths/Isoline_graph.h>
#include <CGAL/Surface_mesh_geodesics/internal/propagation/Available_tag.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Vertex_distance_field.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_insertion.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/sources/Source_set.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_shortest_path/Surface_mesh_shortest_path_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Propagates once from one set of sources, and answers then: the lines, and the distances of vertices up to the maximum
// distance. The sources stay in the refined mesh, since the lines run in it. `Inserted` knows them there: it is
// Isoline_points or Isoline_curves.
//
// Use: the constructor, run() once, then the other functions. If the constructor or run() throws, nothing has been
// written anywhere. The mesh of the user is referred to, and must outlive the object; the index maps are copied.
template <typename Inserted, typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Isoline_run
{
public:
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using Coordinates = std::array<double, 3>;

  // Reads what the sources can reach, checks the sources and inserts them. `options` are Distance_options without
  // targets, whose numbers have been checked. Throws Invalid_geodesic_input. A line that comes to a wall ends there, as
  // at the border; behind the wall another one may begin.
  template <typename Shape, typename Sources, typename Options>
  Isoline_run(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim, Shape shape, const Sources& sources,
              const Options& options, Obstacles obstacles)
    : m_surface(tm, vim, fim, std::move(shape), sources, typename Blocks_for_tag<typename Inserted::Tag>::type(),
                std::move(obstacles)),
      m_insertion(m_surface.mesh()), m_sources(m_surface, sources, options.source_offsets, m_insertion),
      m_maximum_distance(options.maximum_distance / m_surface.unit())
  {}

  Isoline_run(const Isoline_run&) = delete;
  Isoline_run& operator=(const Isoline_run&) = delete;

  // Propagates, and traces the lines of the levels. These are in the user's unit, in any order; only those between 0
  // and the maximum distance have lines. Without `wants_vertices` the propagation ends behind the last of these levels,
  // and distance() and nearest_source() must not be called. Returns false if the visitor canceled.
  //
  // An edge that a line crosses twice may have ends that are farther than the line, by half of the edge: their
  // distances tell that there is something to look for.
  template <typename Visitor>
  bool run(const std::vector<double>& levels, bool wants_vertices, Visitor& visitor,
           Propagation_statistics* statistics)
  {
    for(const double level : levels)
      if(level > 0 && level < Field::infinity() && level / m_surface.unit() <= m_maximum_distance)
        m_levels.push_back(level / m_surface.unit());
    std::sort(m_levels.begin(), m_levels.end());
    m_levels.erase(std::unique(m_levels.begin(), m_levels.end()), m_levels.end());
    // Levels that come twice are traced once: for_each_line() finds them by their value.
    const double last = m_levels.empty() ? 0 : m_levels.back();
    const double limit = wants_vertices ? m_maximum_distance : (std::min)(m_maximum_distance, last);
    m_sweep.reset(m_surface.mesh(), m_field, m_levels, Tolerance<double>::isoline());
    const double farthest = (std::max)(limit, last + longest_edge());
    const bool is_complete = run_with_visitor(visitor, m_surface.number_of_vertices(), [&](auto go_on)
    { return propagate(farthest, Go_on_reference(go_on, m_surface.unit()), statistics); });
    if(is_complete)
      m_sweep.finish();
    return is_complete;
  }

  // Calls line(points, is_closed) for each line of a level, in the user's unit. A point is a pair of a face of the user
  // and three coordinates, in the order of the user's corners. No line for what was no level of the run, or no distance
  // of points. Requires: run() has returned true. Takes time linear in the number of points.
  template <typename Line>
  void for_each_line(double level, Line line) const
  {
    const auto it = std::lower_bound(m_levels.begin(), m_levels.end(), level / m_surface.unit());
    if(it == m_levels.end() || *it != level / m_surface.unit())
      return;
    const auto with_locations = [&](const std::vector<Isoline_point<double>>& points, bool is_closed)
    {
      std::vector<std::pair<face_descriptor, Coordinates>> located;
      located.reserve(points.size());
      for(const Isoline_point<double>& p : points)
        located.push_back(user_location(p));
      line(located, is_closed);
    };
    m_sweep.for_each_line(static_cast<std::size_t>(it - m_levels.begin()), with_locations);
  }

  // Returns the distance of a vertex in the user's unit; infinity if it is not reached within the maximum distance.
  double distance(vertex_descriptor v) const
  {
    const double d = m_field.distance[nearest_copy(v)];
    return d <= m_maximum_distance ? d * m_surface.unit() : Field::infinity();
  }

  // Returns the number of the source from which the distance of v is measured, or the largest std::size_t where no
  // source reaches within the maximum distance. Of several sources at one point with one offset, the first one counts.
  // All vertices together take linear time: all calls get one object from sources_of_vertices().
  std::size_t nearest_source(vertex_descriptor v, Sources_of_vertices<double>& source_of) const
  {
    return distance(v) < Field::infinity() ? m_sources.number(m_field, source_of(nearest_copy(v)))
                                           : Source_numbers::none;
  }

  Sources_of_vertices<double> sources_of_vertices() const { return Sources_of_vertices<double>(m_field); }

private:
  using Field = Vertex_distance_field<double>;

  // The vertex of the refined mesh at v; where walls divide v, the one that is nearest to the sources. Beyond the limit
  // of the run, distances may not be final; distance() does not tell these.
  Vertex_id nearest_copy(vertex_descriptor v) const
  {
    return m_surface.nearest_copy(v, [this](Vertex_id c) { return m_field.distance[c]; });
  }

  // Propagates up to a distance, in the unit of the mesh. The propagation is gone when this returns: the lines are made
  // in the memory of its windows.
  bool propagate(double limit, const Go_on_reference& go_on, Propagation_statistics* statistics)
  {
    typename Inserted::Propagation propagation(m_surface.mesh(), m_field, typename Inserted::Keeper(m_sweep));
    m_sources.start(propagation, limit, m_sweep);
    const bool is_complete = propagation.run(go_on);
    m_sources.finish(propagation);
    if(statistics != nullptr)
    {
      Propagation_statistics s = propagation.statistics();
      s.intrinsic_mesh_bytes += m_surface.memory() + m_field.memory();
      s.maximum_window_bytes += m_sweep.memory();
      statistics->add(s);
    }
    return is_complete;
  }

  // The longest side of a face, which bounds how far beyond a level the ends of an edge may be that a line of the level
  // crosses twice; in the unit of the mesh. Takes linear time.
  double longest_edge() const
  {
    double longest = 0;
    for(Face_id f = 0; f < m_surface.mesh().number_of_faces(); ++f)
      longest = (std::max)(longest, longest_side(m_surface.mesh().face(f)));
    return longest;
  }

  // Returns the user's face, and the coordinates there in the order of the user's corners. Faces with sources are
  // divided in the refined mesh.
  std::pair<face_descriptor, Coordinates> user_location(const Isoline_point<double>& p) const
  {
    Coordinates b = coordinates_on_halfedge(p.halfedge, p.t);
    const Face_id whole = m_insertion.parts().coordinates_in_whole(face_of(p.halfedge), b);
    return m_surface.location(whole, b);
  }

  // In this order, as each member refers to those above it: the insertion changes the mesh of the surface, the sources
  // are vertices and edges of that mesh, and the sweep reads the mesh and the field.
  Intrinsic_surface<double, TriangleMesh, VertexIndexMap, FaceIndexMap> m_surface;
  Source_insertion<double> m_insertion;
  Inserted m_sources;
  double m_maximum_distance;    // in the unit of the mesh
  Field m_field;                // without images, as no paths are traced
  std::vector<double> m_levels; // those that may have lines, ascending, in the unit of the mesh
  typename Inserted::Sweep m_sweep;
};

// The points of locations, for Isoline_writer. They are constructed as the class for paths does it: the same bits for
// the same location.
template <typename TriangleMesh, typename VertexPointMap>
struct Points_in_faces
{
  using Point_3 = typename boost::property_traits<VertexPointMap>::value_type;
  using Traits = Surface_mesh_shortest_path_traits<typename Kernel_traits<Point_3>::Kernel, TriangleMesh>;
  using Locations = Surface_locations<Traits, VertexPointMap>;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  const TriangleMesh& tm;
  VertexPointMap vertex_point_map; // a handle, copied

  // Returns the point with the given coordinates, in the order of the user's corners. Takes constant time.
  Point_3 point(face_descriptor f, const std::array<double, 3>& b) const
  {
    const Traits traits;
    return Locations::point(f, Locations::coordinates(b, traits), tm, vertex_point_map, traits);
  }
};

// Writes the lines in the order of the levels, then the maps of the user, as geodesic_isolines() documents. Without a
// map of distances or of nearest sources the run ends at the last level. Returns false if the visitor cancels.
template <typename ConcurrencyTag, typename TriangleMesh, typename Sources, typename OutputIterator,
          typename NamedParameters>
bool compute_isolines(const TriangleMesh& tm, const Sources& sources, const std::vector<double>& levels,
                      OutputIterator output, const NamedParameters& np)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  constexpr bool wants_distances = Has_parameter<NamedParameters, internal_np::vertex_distance_map_t>::value;
  constexpr bool wants_sources = Has_parameter<NamedParameters, internal_np::nearest_source_map_t>::value;
  // Numbers are checked before the mesh is read, as in the other functions.
  const auto options = distance_options<TriangleMesh>(np);
  check_numbers(options);
  auto vim = CGAL::get_initialized_vertex_index_map(tm, np);
  auto fim = CGAL::get_initialized_face_index_map(tm, np);
  auto vpm = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                          get_const_property_map(CGAL::vertex_point, tm));
  Visitor_parameter<NamedParameters> visitor_parameter(np);
  using Inserted = std::conditional_t<Are_curves<Sources>::value, Isoline_curves, Isoline_points<ConcurrencyTag>>;
  Isoline_run<Inserted, TriangleMesh, decltype(vim), decltype(fim)> run(
    tm, vim, fim, shape_from_points<double>(tm, np), sources, options, obstacles(tm, fim, np));
  if(!run.run(levels, wants_distances || wants_sources, visitor_parameter.visitor(), options.statistics))
    return false;
  using Points = Points_in_faces<TriangleMesh, decltype(vpm)>;
  using Numbered_line = std::pair<std::size_t, std::vector<typename Points::Point_3>>;
  static_assert(Checked_output_iterator<OutputIterator, Numbered_line>::value, "always true, if it compiles");
  const Points points{tm, vpm};
  for(std::size_t i = 0; i < levels.size(); ++i)
  {
    auto write = boost::make_function_output_iterator([&](const std::vector<typename Points::Point_3>& line)
    {
      if constexpr(Is_output_iterator<OutputIterator, Numbered_line>::value)
        *output++ = Numbered_line(i, line);
    });
    Isoline_writer<Points, decltype(write)> writer(points, write);
    run.for_each_line(levels[i], std::ref(writer));
  }
  if constexpr(wants_distances)
    write_distances(tm, run, map_parameter<vertex_descriptor, double, int>(np, internal_np::vertex_distance_map));
  write_nearest_sources(tm, run, options.nearest_source_map);
  return true;
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_ISOLINES_ISOLINE_RUN_H
