// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PATH_VISITORS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PATH_VISITORS_H

// Receivers of paths and isolines. `Path_sequence_sink` turns the elements that the solver reports into the calls of a
// `SurfaceMeshShortestPathVisitor`. `Path_point_writer` and `Path_polyline_writer` are such visitors; they write
// points. `Isoline_writer` writes the points of isolines.

#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Computes the points of the elements of a path, one after the other, with `paths.point()`.
//
// `Paths` is Surface_mesh_geodesic_paths: it has Point_3, which has a default constructor and operator!=, and the
// functions point(v), point(he, t) and point(f, coordinates). It is referred to, and must outlive the object.
template <typename Paths>
class Path_points
{
public:
  using Point_3 = typename Paths::Point_3;

  explicit Path_points(const Paths& paths) : m_paths(paths) {}

  // Moves to a vertex, a halfedge and a parameter, or a face and coordinates. Returns false if rounding makes the point
  // equal to the one before.
  template <typename... Element>
  bool next(const Element&... element)
  {
    const Point_3 p = m_paths.point(element...);
    // The first point always counts, whatever a default point is.
    const bool is_new = m_is_first || p != m_point;
    m_is_first = false;
    m_point = p;
    return is_new;
  }

  // Returns the point of the last element.
  // Requires: next() has been called.
  const Point_3& point() const { return m_point; }

private:
  const Paths& m_paths;
  bool m_is_first = true;
  Point_3 m_point = Point_3();
};

// Writes the points of a path, none twice in a row. The output iterator is copied; the position that it reaches is not
// returned. If it is no iterator, or one that takes something else, this class has the message, and writes nothing; so
// do the classes below. They are where the type of what is written is known.
template <typename Paths, typename OutputIterator>
class Path_point_writer
{
public:
  Path_point_writer(const Paths& paths, OutputIterator output) : m_points(paths), m_output(output) {}

  template <typename... Element>
  void operator()(const Element&... element)
  {
    if(m_points.next(element...))
      if constexpr(Is_output_iterator<OutputIterator, const Point_3&>::value)
        *m_output++ = m_points.point();
  }

private:
  using Point_3 = typename Paths::Point_3;
  static_assert(Checked_output_iterator<OutputIterator, const Point_3&>::value, "always true, if it compiles");

  Path_points<Paths> m_points;
  OutputIterator m_output;
};

// Writes the points of a path, each with the face of the segment that leads to it. enter() sets that face. The first
// point has the null face, as nothing leads to it.
template <typename Paths, typename OutputIterator>
class Path_polyline_writer
{
public:
  using face_descriptor = typename Paths::face_descriptor;

  Path_polyline_writer(const Paths& paths, OutputIterator output) : m_points(paths), m_output(output) {}

  void enter(face_descriptor f) { m_face = f; }

  template <typename... Element>
  void operator()(const Element&... element)
  {
    if(m_points.next(element...))
      if constexpr(Is_output_iterator<OutputIterator, Value>::value)
        *m_output++ = std::make_pair(m_points.point(), m_face);
  }

private:
  using Value = std::pair<typename Paths::Point_3, face_descriptor>;
  static_assert(Checked_output_iterator<OutputIterator, Value>::value, "always true, if it compiles");

  Path_points<Paths> m_points;
  OutputIterator m_output;
  face_descriptor m_face = boost::graph_traits<typename Paths::Triangle_mesh>::null_face();
};

// Whether a visitor has enter(), and wants the face of each segment. It is decided by the type: a visitor of the user
// may have a member of that name for another purpose.
template <typename Visitor>
struct Wants_faces_of_segments : std::false_type
{};

template <typename Paths, typename OutputIterator>
struct Wants_faces_of_segments<Path_polyline_writer<Paths, OutputIterator>> : std::true_type
{};

// Turns what the solver reports of a path into calls of the visitor, in the order of the path from the query point to
// the source: face() before each element that is reached through a face, and source() at the end unless the source is a
// vertex. `structure` knows the source points. Structure and visitor are referred to.
//
// Path_solver::report() calls it after the path has been traced as a whole, so that a path that cannot be traced
// reaches no visitor.
template <typename Structure, typename Visitor>
class Path_sequence_sink
{
public:
  using FT = typename Structure::FT;
  using vertex_descriptor = typename Structure::vertex_descriptor;
  using halfedge_descriptor = typename Structure::halfedge_descriptor;
  using face_descriptor = typename Structure::face_descriptor;

  static constexpr bool wants_faces = Wants_faces_of_segments<Visitor>::value;

  // All three calls are compiled, whatever the path is, and each would have an error of its own, in another place. The
  // first message names them together. (Visitors of the user have overloads; those of this file take everything.)
  static_assert(std::is_invocable<Visitor&, vertex_descriptor&>::value
                  && std::is_invocable<Visitor&, halfedge_descriptor&, FT>::value
                  && (std::is_invocable<Visitor&, face_descriptor&,
                                        const typename Structure::Barycentric_coordinates&>::value
                      || std::is_invocable<Visitor&, face_descriptor&,
                                           typename Structure::Barycentric_coordinates>::value),
                "the visitor of a path has no operator() for each of: a vertex; a halfedge and a number; a face and "
                "barycentric coordinates");

  Path_sequence_sink(const Structure& structure, Visitor& visitor) : m_structure(structure), m_visitor(visitor) {}

  // The path runs through a vertex.
  void vertex(vertex_descriptor v) { m_visitor(v); }

  // The path crosses an edge, at t from source to target.
  void edge(halfedge_descriptor he, double t) { m_visitor(he, FT(t)); }

  // The path arrives at the next element through face f.
  void face(face_descriptor f)
  {
    static_cast<void>(f);
    if constexpr(wants_faces)
      m_visitor.enter(f);
  }

  // Ends the path at a source point that is not a vertex. The visitor gets it as an edge if it lies on one. The
  // coordinates are snapped as for the insertion of the source, so at most one of them is zero: two zeros would have
  // made it a vertex.
  void source(std::size_t number)
  {
    const typename Structure::Face_location& location = *m_structure.sources().by_number(number);
    end_at(location.first, m_structure.weights(location.second), [&] { return location.second; });
  }

  // The same at a point of a curve, whose coordinates are in the order of the user's corners.
  void location(const std::pair<face_descriptor, std::array<double, 3>>& l)
  {
    end_at(l.first, l.second, [&] { return Structure::Locations::coordinates(l.second, m_structure.traits()); });
  }

private:
  // Coordinates in the user's type are made for points inside of faces only: few paths end there.
  template <typename User_coordinates>
  void end_at(face_descriptor f, std::array<double, 3> b, User_coordinates coordinates)
  {
    snap_coordinates(b);
    halfedge_descriptor h = halfedge(f, m_structure.mesh());
    for(std::size_t k = 0; k < 3; ++k, h = next(h, m_structure.mesh())) // h leads from corner k to corner k + 1
      if(b[(k + 2) % 3] == 0)
      {
        m_visitor(h, FT(b[(k + 1) % 3]));
        return;
      }
    m_visitor(f, coordinates());
  }

  const Structure& m_structure;
  Visitor& m_visitor;
};

// Where the elements of a path are in space, for those who write the path of a Lazy_path_structure.
template <typename Structure>
class Points_of_elements
{
public:
  using Locations = typename Structure::Locations;
  using Point_3 = typename Structure::Point_3;

  explicit Points_of_elements(const Structure& structure) : m_structure(structure) {}

  Point_3 point(typename Structure::vertex_descriptor v) const { return get(m_structure.vertex_point_map(), v); }

  // A point of an edge, at t from source to target, or of a face.
  template <typename Element, typename Parameter>
  Point_3 point(const Element& element, const Parameter& t) const
  {
    return Locations::point(element, t, m_structure.mesh(), m_structure.vertex_point_map(), m_structure.traits());
  }

private:
  const Structure& m_structure;
};

// (The class for isolines of one run, in isolines/, writes a pair to the user, and gets its lines from this one.)
//
// Writes isolines as polylines, without a point twice in a row. A closed line ends with its first point. A line of one
// point is not written. `structure.point(f, b)` gives the points, for coordinates in the order of the user's corners;
// it is referred to.
//
// Isoline_tracer calls it with located points, at least two; rounding may make their points in space equal.
template <typename Structure, typename OutputIterator>
class Isoline_writer
{
public:
  using Point_3 = typename Structure::Point_3;
  using Located_points = std::vector<std::pair<typename Structure::face_descriptor, std::array<double, 3>>>;

  Isoline_writer(const Structure& structure, OutputIterator output) : m_structure(structure), m_output(output) {}

  const OutputIterator& output() const { return m_output; }

  void operator()(const Located_points& points, bool is_closed)
  {
    std::vector<Point_3> line;
    for(const auto& p : points)
      append(line, m_structure.point(p.first, p.second));
    if(is_closed)
      append(line, Point_3(line.front()));
    if(line.size() > 1)
      if constexpr(Is_output_iterator<OutputIterator, std::vector<Point_3>&>::value)
        *m_output++ = line;
  }

private:
  static_assert(Checked_output_iterator<OutputIterator, std::vector<Point_3>&>::value, "always true, if it compiles");

  // Appends a point unless the line ends with it.
  static void append(std::vector<Point_3>& line, const Point_3& p)
  {
    if(line.empty() || p != line.back())
      line.push_back(p);
  }

  const Structure& m_structure;
  OutputIterator m_output;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PATH_VISITORS_H
