// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_FACE_SHAPES_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_FACE_SHAPES_H

// Where the shapes of faces come from: the points of the vertices, or a map of edge lengths. Both classes read the
// user's maps, check the numbers, and leave the geometry to surface/face_shape.h.
//
// A model of Shape has
// - has_points: whether the surface is embedded in space;
// - prepare(vertices, n, blocks): reads and checks what is scaled; returns the exponent of the power of two by which
//   lengths are divided. `vertices` are the user's in the order of the intrinsic mesh, of which the first n are in
//   faces. Its loops may be divided into blocks (One_block.h);
// - shape(f, position, v, face): sets lengths and layout of a face of the intrinsic mesh, given as the user's face f at
//   a position of faces(tm), and by the numbers v of its corners. Edge j of f leads from corner j to corner j+1.
//   Returns the edge that has become halfedge 0, a shortest one. Several threads may call it if there are points;
// - has_length(f): whether an edge of a face has a length before scaling and rounding. It is asked only for
//   components whose lengths vanish beside the unit: they are valid if they have no lengths at all.
// They are called in this order. prepare() throws for a number that is not finite or out of range, so that shape() sees
// lengths of at most about 1 (Intrinsic_mesh.h); both faces at an edge get its length in the same bits.
//
// The unit comes from the longest edge if lengths are given. If points are given, it comes from the extent of their
// coordinates, which is known before any edge is measured: lengths are below 4 then, and may all be far smaller than 1.
//
// An object refers to the mesh, copies the map, and is needed only while the mesh is read (Face_graph_reader.h).

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/Consecutive_elements.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/memory_hints.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_face.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/face_shape.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// Returns three halfedges of a face, from halfedge(f, tm) on: all of them if the face is a triangle.
template <typename TriangleMesh>
std::array<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, 3>
halfedges_of_triangle(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& tm)
{
  const auto h = halfedge(f, tm), after = next(h, tm);
  return {h, after, next(after, tm)};
}

// Shapes from the points of the vertices. prepare() reads each point once (the first one twice), in the order in which
// the faces will ask for them, and scales it by a power of two. The values of VertexPointMap have members x(), y(), z()
// that CGAL::to_double() takes; get() may return them by value or by reference.
//
// Several threads read the points if Has_shared_points says so: each reads a block of the vertices, and writes its own
// part of m_points. The points of any other map are read by the calling thread alone; the scaling is shared then, too,
// as it sees the copies only.
template <typename FT, typename TriangleMesh, typename VertexPointMap>
class Shape_from_points
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  // Functions and classes have checked the map before, with a message that names it; the solver comes here with that of
  // its constructor. Meshes whose own points are in the plane are found here, too: nobody has given a map for them.
  static_assert(Is_point<typename Value_of_map<VertexPointMap, vertex_descriptor>::type>::value,
                "the points are not a property map from the vertices of the mesh to points in space");

public:
  static constexpr bool has_points = true;

  Shape_from_points(const TriangleMesh& tm, VertexPointMap vpm) : m_tm(tm), m_vpm(vpm) {}

  // Reads the points of the vertices of the intrinsic mesh. Those behind the first `number_in_faces` are isolated; they
  // have no lengths and do not count for the scale, but are checked.
  //
  // Coordinates are compared with those of the first point, not with 0: a mesh far from the origin is as large as its
  // extent. One comparison finds all faults: the difference from a coordinate that is infinite or NaN is so itself, and
  // coordinates that are too far from each other may each be valid. The largest difference is the same for any blocks.
  template <typename Blocks>
  int prepare(const std::vector<vertex_descriptor>& numbered_vertices, std::size_t number_in_faces,
              const Blocks& blocks)
  {
    const std::size_t n = numbered_vertices.size();
    if(n == 0)
      return scaling_exponent(0.);
    reserve_large(m_points, n);
    m_points.resize(n);
    const Space_coordinates first_point = point(numbered_vertices.front());
    double largest = 0;
    std::mutex mutex; // of `largest`
    const auto read = [&](std::size_t first, std::size_t last)
    {
      double largest_of_block = 0;
      for(std::size_t v = first; v < last; ++v)
      {
        m_points[v] = point(numbered_vertices[v]);
        for(std::size_t i = 0; i < 3; ++i)
        {
          const double extent = std::abs(m_points[v][i] - first_point[i]);
          if(!(extent <= largest_extent()))
            reject_point();
          if(v < number_in_faces)
            largest_of_block = (std::max)(largest_of_block, extent);
        }
      }
      const std::lock_guard<std::mutex> lock(mutex);
      largest = (std::max)(largest, largest_of_block);
    };
    if constexpr(Has_shared_points<TriangleMesh, VertexPointMap>::value)
      blocks(n, read);
    else
      read(0, n);
    const int exponent = scaling_exponent(largest);
    blocks(n, [&](std::size_t first, std::size_t last) { scale_points(first, last, std::ldexp(1., -exponent)); });
    return exponent;
  }

  // Sets the shape of the face of three vertices, and returns which of its edges becomes halfedge 0. Reads only the
  // copy of the points, so threads may call it at once.
  unsigned int shape(face_descriptor, std::size_t, const std::array<Vertex_id, 3>& v, Intrinsic_face<FT>& f) const
  {
    return set_shape_from_sides<FT>({difference(v[1], v[0]), difference(v[2], v[1]), difference(v[0], v[2])}, f);
  }

  // Compares the points in the user's number type. If two edges have no length, the third one has none either.
  bool has_length(face_descriptor f) const
  {
    const auto h = halfedges_of_triangle(f, m_tm);
    const auto differs = [](const auto& p, const auto& q)
    { return p.x() != q.x() || p.y() != q.y() || p.z() != q.z(); };
    const auto end = [this](halfedge_descriptor g) -> decltype(auto) { return get(m_vpm, target(g, m_tm)); };
    return differs(end(h[0]), end(h[1])) || differs(end(h[1]), end(h[2]));
  }

private:
  // (Without the first constructor, a vector of points would be zeroed before they are read, by one thread.)
  struct Space_coordinates : std::array<double, 3>
  {
    Space_coordinates() {}
    Space_coordinates(double x, double y, double z) : std::array<double, 3>{{x, y, z}} {}
  };

  Space_coordinates point(vertex_descriptor v) const
  {
    const auto& p = get(m_vpm, v);
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  // If a coordinate overflows, all vertices in faces share it: the next larger number would be farther away than the
  // extent. Any number serves then. (The factor is greater than 1 for such a tiny mesh far from the origin. Isolated
  // vertices may differ, but have no lengths.)
  void scale_points(std::size_t first, std::size_t last, double factor)
  {
    for(std::size_t v = first; v < last; ++v)
      for(double& x : m_points[v])
        x = std::isfinite(x * factor) ? x * factor : 0.;
  }

  // Throws for the first vertex of vertices(tm) that has a coordinate which is not finite or too large by itself;
  // otherwise for no vertex in particular, as points are too far from each other. The map is read a second time for
  // that, in the order of the user, as the message names positions.
  [[noreturn]] void reject_point() const
  {
    std::size_t position = 0, culprit = 0;
    for(vertex_descriptor v : vertices(m_tm))
    {
      for(const double x : point(v))
        if(!(std::abs(x) <= largest_extent()) && culprit == 0)
          culprit = position + 1;
      ++position;
    }
    const std::size_t element = culprit == 0 ? Invalid_geodesic_input::no_element : culprit - 1;
    throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::NON_FINITE_POINT,
                                 culprit == 0 ? std::string("the extent of the points is too large")
                                              : "vertex " + std::to_string(element)
                                                  + " has a coordinate that is not finite, or too large",
                                 element);
  }

  // Returns the vector from vertex a to vertex b. Exact up to one rounding for each coordinate, as points are scaled by
  // a power of two.
  Space_vector<FT> difference(Vertex_id b, Vertex_id a) const
  {
    const Space_coordinates &p = m_points[a], &q = m_points[b];
    return {FT(FT(q[0]) - FT(p[0])), FT(FT(q[1]) - FT(p[1])), FT(FT(q[2]) - FT(p[2]))};
  }

  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
  std::vector<Space_coordinates> m_points; // of the numbered vertices, scaled
};

// Shapes from a map of edge lengths. prepare() checks the range of all lengths, shape() the triangle inequality. The
// values of EdgeLengthMap are numbers that CGAL::to_double() takes. Both faces of an edge ask for the same edge
// descriptor, so they get the same length.
template <typename FT, typename TriangleMesh, typename EdgeLengthMap>
class Shape_from_edge_lengths
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
  using Reason = Invalid_geodesic_input::Reason;

  // Functions and classes that take lengths come here. A map of vertices or of halfedges is the usual mistake.
  static_assert(Is_map_of_numbers<EdgeLengthMap, edge_descriptor>::value,
                "the lengths are not a property map from the edges of the mesh to numbers");

public:
  static constexpr bool has_points = false;

  Shape_from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap elm) : m_tm(tm), m_elm(elm) {}

  // Checks the lengths of all edges, in the order of edges(tm). The map is read again by shape(), so that no table of
  // lengths is needed. Edges without faces are checked, too, and count for the unit.
  template <typename Vertices, typename Blocks>
  int prepare(const Vertices&, std::size_t, const Blocks&)
  {
    double largest = 0;
    std::size_t n = 0;
    for(edge_descriptor e : edges(m_tm))
    {
      const double l = CGAL::to_double(get(m_elm, e));
      if(!std::isfinite(l) || l > largest_extent())
        throw Invalid_geodesic_input(Reason::NON_FINITE_LENGTH,
                                     "the length of edge " + std::to_string(n)
                                       + " is not finite, or too large", n);
      if(l < 0)
        throw Invalid_geodesic_input(Reason::NEGATIVE_LENGTH,
                                     "the length of edge " + std::to_string(n) + " is negative", n);
      largest = (std::max)(largest, l);
      ++n;
    }
    const int exponent = scaling_exponent(largest);
    m_factor = std::ldexp(1., -exponent);
    return exponent;
  }

  // Sets the shape of the face of three halfedges, and returns which of them becomes halfedge 0. Throws if one edge is
  // longer than the two others, beyond rounding. Reads the user's map, so one thread calls it.
  // The check comes after the layout, as the layout has put the lengths in order; a mesh with such a face is not used.
  unsigned int shape(face_descriptor face, std::size_t face_position, const std::array<Vertex_id, 3>&,
                     Intrinsic_face<FT>& f) const
  {
    const auto h = halfedges_of_triangle(face, m_tm);
    std::array<FT, 3> length;
    for(std::size_t i = 0; i < 3; ++i)
      length[i] = FT(m_factor * CGAL::to_double(get(m_elm, edge(h[i], m_tm))));
    const unsigned int shift = set_shape_from_lengths(length, f);
    if(violates_triangle_inequality(f))
      throw Invalid_geodesic_input(Reason::TRIANGLE_INEQUALITY,
                                   "an edge of face " + std::to_string(face_position)
                                     + " is longer than the two others together", face_position);
    return shift;
  }

  bool has_length(face_descriptor f) const
  {
    const auto h = halfedges_of_triangle(f, m_tm);
    return std::any_of(h.begin(), h.end(),
                       [this](halfedge_descriptor g) { return CGAL::to_double(get(m_elm, edge(g, m_tm))) > 0; });
  }

private:
  const TriangleMesh& m_tm;
  EdgeLengthMap m_elm;
  // The inverse of the unit, exactly, once prepare() has been called.
  double m_factor = 1;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_FACE_SHAPES_H
