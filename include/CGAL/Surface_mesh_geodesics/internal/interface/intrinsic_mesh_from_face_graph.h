// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_INTRINSIC_MESH_FROM_FACE_GRAPH_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_INTRINSIC_MESH_FROM_FACE_GRAPH_H

// The intrinsic mesh of a model of FaceListGraph, with points or with edge lengths, and the tables
// between the elements of both. This is the only place that walks over a mesh of the user.
//
// Faces are numbered breadth first, and vertices in the order in which the faces meet them: the
// wavefront then works on a part of the records that lies together in memory.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/Intrinsic_mesh.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The largest length for which distances, which are sums of lengths, stay finite.
inline double largest_extent() { return std::ldexp(1., 960); }

// The smallest component, relative to the unit of its mesh: products of four of its lengths do not underflow.
inline double smallest_component() { return std::ldexp(1., -200); }

// The exponent of a power of two that is about as large as the extent of a mesh, and whose inverse is
// finite.
inline int scaling_exponent(double extent)
{
  int exponent = 0;
  std::frexp(extent, &exponent);
  return (std::max)(exponent, -960);
}

// The elements of a mesh of the user and those of its intrinsic mesh.
template <typename TriangleMesh>
struct Face_graph_correspondence
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  std::vector<vertex_descriptor> vertices; // of a vertex of the intrinsic mesh
  std::vector<face_descriptor> faces;      // of a face of the intrinsic mesh
  std::vector<Vertex_id> vertex_of_index;  // by the index of the user's map, null_id if unused
  // By the index of the user's map: the halfedge of the intrinsic mesh that is halfedge(f, tm).
  std::vector<Halfedge_id> halfedge_of_face_index;

  std::size_t memory() const
  {
    return vertices.capacity() * sizeof(vertex_descriptor) + faces.capacity() * sizeof(face_descriptor)
         + vertex_of_index.capacity() * sizeof(Vertex_id)
         + halfedge_of_face_index.capacity() * sizeof(Halfedge_id);
  }
};

// Sets halfedge 0 of a face to the shortest of the edges with the given lengths, and the lengths; returns
// which of the edges became halfedge 0.
template <typename FT>
unsigned int set_lengths(const std::array<FT, 3>& length, Intrinsic_face<FT>& f)
{
  // (by a table: no processor predicts which edge is the shortest)
  constexpr unsigned int shortest[8] = {2, 1, 2, 1, 2, 2, 0, 0};
  const unsigned int shift = shortest[4u * (length[0] <= length[1]) + 2u * (length[0] <= length[2])
                                      + 1u * (length[1] <= length[2])];
  for(unsigned int k = 0; k < 3; ++k)
    f.length[k] = length[corner_after(k, shift)];
  return shift;
}

// The shape of a face from the points of its vertices. The points are read once, in the order in which
// the faces will ask for them, and scaled by a power of two.
template <typename FT, typename TriangleMesh, typename VertexPointMap>
class Shape_from_points
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using Vector = std::array<FT, 3>;

public:
  static constexpr bool has_points = true;

  Shape_from_points(const TriangleMesh& tm, VertexPointMap vpm) : m_tm(tm), m_vpm(vpm) {}

  // reads the points; returns the exponent of the power of two by which lengths are divided. Isolated
  // vertices, behind the first `number_in_faces`, have no lengths.
  int prepare(const std::vector<vertex_descriptor>& numbered_vertices, std::size_t number_in_faces)
  {
    m_points.reserve(numbered_vertices.size());
    double largest = 0;
    for(vertex_descriptor v : numbered_vertices)
    {
      const auto& p = get(m_vpm, v);
      m_points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
      for(std::size_t i = 0; i < 3; ++i)
      {
        const double extent = std::abs(m_points.back()[i] - m_points.front()[i]);
        if(!(extent <= largest_extent()))
          refuse_point();
        if(m_points.size() <= number_in_faces)
          largest = (std::max)(largest, extent);
      }
    }
    const int exponent = scaling_exponent(largest);
    const double factor = std::ldexp(1., -exponent);
    // A coordinate that overflows is that of all vertices in faces: the next larger number would be farther away than
    // the extent. Then any number does.
    for(std::array<double, 3>& p : m_points)
      for(double& x : p)
        x = std::isfinite(x * factor) ? x * factor : 0.;
    return exponent;
  }

  // sets the lengths and the layout of a face with the given vertices; returns which of its halfedges
  // became halfedge 0.
  unsigned int shape(const std::array<halfedge_descriptor, 3>&, std::size_t,
                     const std::array<Vertex_id, 3>& v, Intrinsic_face<FT>& f) const
  {
    const std::array<Vector, 3> side = {difference(v[1], v[0]), difference(v[2], v[1]),
                                        difference(v[0], v[2])};
    // the same bits from both faces of an edge
    const unsigned int shift = set_lengths<FT>(
      {vector_length(side[0]), vector_length(side[1]), vector_length(side[2])}, f);
    if(!(f.length[0] > 0))
    {
      f.apex_x = f.length[2];
      f.apex_y = 0;
      return shift;
    }
    const Vector& base = side[shift];
    const Vector& from_apex = side[previous_corner(shift)]; // to corner 0
    f.apex_x = -dot(base, from_apex) / f.length[0];
    f.apex_y = vector_length(cross(base, from_apex)) / f.length[0];
    return shift;
  }

  // has an edge a length before lengths are divided, and rounded?
  bool has_length(halfedge_descriptor h) const
  {
    const auto& p = get(m_vpm, source(h, m_tm));
    const auto& q = get(m_vpm, target(h, m_tm));
    return p.x() != q.x() || p.y() != q.y() || p.z() != q.z();
  }

private:
  // throws for the first vertex whose point is not finite or too far away from that of the first.
  [[noreturn]] void refuse_point() const
  {
    std::size_t position = 0, culprit = 0;
    for(vertex_descriptor v : vertices(m_tm))
    {
      const auto& p = get(m_vpm, v);
      for(const double x : {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())})
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

  Vector difference(Vertex_id b, Vertex_id a) const
  {
    const std::array<double, 3>&p = m_points[a], &q = m_points[b];
    return {FT(FT(q[0]) - FT(p[0])), FT(FT(q[1]) - FT(p[1])), FT(FT(q[2]) - FT(p[2]))};
  }

  static FT dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Vector cross(const Vector& a, const Vector& b)
  {
    return {FT(a[1] * b[2] - a[2] * b[1]), FT(a[2] * b[0] - a[0] * b[2]),
            FT(a[0] * b[1] - a[1] * b[0])};
  }

  static FT vector_length(const Vector& a)
  {
    using std::sqrt;
    return sqrt(dot(a, a));
  }

  const TriangleMesh& m_tm;
  VertexPointMap m_vpm;
  std::vector<std::array<double, 3>> m_points; // of the numbered vertices, scaled
};

// The shape of a face from the lengths of its edges.
template <typename FT, typename TriangleMesh, typename EdgeLengthMap>
class Shape_from_edge_lengths
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  using edge_descriptor = typename boost::graph_traits<TriangleMesh>::edge_descriptor;

public:
  static constexpr bool has_points = false;

  Shape_from_edge_lengths(const TriangleMesh& tm, EdgeLengthMap elm) : m_tm(tm), m_elm(elm) {}

  template <typename Vertices>
  int prepare(const Vertices&, std::size_t)
  {
    using Reason = Invalid_geodesic_input::Reason;
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

  unsigned int shape(const std::array<halfedge_descriptor, 3>& h, std::size_t face_position,
                     const std::array<Vertex_id, 3>&, Intrinsic_face<FT>& f) const
  {
    std::array<FT, 3> length;
    for(std::size_t i = 0; i < 3; ++i)
      length[i] = FT(m_factor * CGAL::to_double(get(m_elm, edge(h[i], m_tm))));
    const unsigned int shift = set_lengths(length, f);
    const FT longest = (std::max)(f.length[1], f.length[2]);
    const FT others = f.length[0] + (std::min)(f.length[1], f.length[2]);
    if(longest - others > Tolerance<FT>::triangle_inequality() * longest)
      throw Invalid_geodesic_input(Invalid_geodesic_input::Reason::TRIANGLE_INEQUALITY,
                                   "an edge of face " + std::to_string(face_position)
                                     + " is longer than the two others together", face_position);
    const Planar_triangle<FT> t
      = planar_triangle_from_lengths(f.length[0], f.length[1], f.length[2]);
    f.apex_x = t.apex_x;
    f.apex_y = t.apex_y;
    return shift;
  }

  // has an edge a length before lengths are divided, and rounded?
  bool has_length(halfedge_descriptor h) const { return CGAL::to_double(get(m_elm, edge(h, m_tm))) > 0; }

private:
  const TriangleMesh& m_tm;
  EdgeLengthMap m_elm;
  double m_factor = 1;
};

// Positions are those in the ranges vertices(tm) and faces(tm).
template <typename FT, typename TriangleMesh, typename VertexIndexMap, typename FaceIndexMap>
class Intrinsic_mesh_builder
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;
  using Correspondence = Face_graph_correspondence<TriangleMesh>;
  using Reason = Invalid_geodesic_input::Reason;

public:
  Intrinsic_mesh_builder(const TriangleMesh& tm, VertexIndexMap vim, FaceIndexMap fim)
    : m_tm(tm), m_vim(vim), m_fim(fim)
  {}

  // builds the mesh and the tables; throws Invalid_geodesic_input.
  template <typename Shape>
  void build(Shape& shape, Intrinsic_mesh<FT>& mesh, Correspondence& table)
  {
    read_faces();
    find_neighbours();
    number_faces();
    const std::size_t number_in_faces = number_vertices(table);
    const int exponent = shape.prepare(table.vertices, number_in_faces);
    mesh.set_unit(FT(std::ldexp(1., exponent)));
    set_faces(shape, mesh);
    set_components(shape, mesh);
    mesh.finish(table.vertices.size());
    if(!Shape::has_points)
      mesh.bound_faces_crossed_by_lengths();
    fill_face_tables(table);
  }

private:
  void read_faces()
  {
    // (Some models count their elements in each call.)
    const std::size_t range_of_indices = num_faces(m_tm), number_of_vertices = num_vertices(m_tm);
    m_faces.reserve(range_of_indices);
    m_halfedges.reserve(range_of_indices);
    m_corners.reserve(range_of_indices);
    for(face_descriptor f : faces(m_tm))
    {
      const halfedge_descriptor h0 = halfedge(f, m_tm), h1 = next(h0, m_tm), h2 = next(h1, m_tm);
      if(next(h2, m_tm) != h0 || h1 == h0 || h2 == h0)
        throw Invalid_geodesic_input(Reason::NOT_A_TRIANGLE,
                                     "face " + std::to_string(m_faces.size())
                                       + " is not a triangle", m_faces.size());
      const std::size_t index = index_of(f);
      if(index >= range_of_indices)
        throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP,
                                     "the index of face " + std::to_string(m_faces.size())
                                       + " is out of range", m_faces.size());
      if(index >= m_position_of_index.size())
        m_position_of_index.resize(range_of_indices, null_id);
      if(m_position_of_index[index] != null_id)
        throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP,
                                     "the index of face " + std::to_string(m_faces.size())
                                       + " is that of another face", m_faces.size());
      m_position_of_index[index] = static_cast<std::uint32_t>(m_faces.size());
      m_faces.push_back(f);
      m_halfedges.push_back({h0, h1, h2});
      // (Targets are nearer at hand than sources in a halfedge data structure.)
      const vertex_descriptor v0 = target(h2, m_tm), v1 = target(h0, m_tm), v2 = target(h1, m_tm);
      if(v0 == v1 || v1 == v2 || v2 == v0)
        throw Invalid_geodesic_input(Reason::NON_MANIFOLD,
                                     "face " + std::to_string(m_faces.size() - 1) + " has a vertex twice",
                                     m_faces.size() - 1);
      m_corners.push_back({vertex_index(v0, number_of_vertices), vertex_index(v1, number_of_vertices),
                           vertex_index(v2, number_of_vertices)});
      if(m_faces.size() >= maximum_number_of_faces)
        throw Invalid_geodesic_input(Reason::TOO_LARGE, "the mesh has too many faces");
    }
  }

  // m_neighbours[f][j] is 4 * (position of the neighbour) + (its halfedge), or null_id.
  void find_neighbours()
  {
    m_neighbours.resize(m_faces.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      for(unsigned int j = 0; j < 3; ++j)
        m_neighbours[f][j] = neighbour(m_halfedges[f][j]);
  }

  Halfedge_id neighbour(halfedge_descriptor h) const
  {
    const halfedge_descriptor o = opposite(h, m_tm);
    if(is_border(o, m_tm))
      return null_id;
    const std::size_t index = index_of(face(o, m_tm));
    const std::uint32_t g = index < m_position_of_index.size() ? m_position_of_index[index] : null_id;
    if(g == null_id)
      return null_id;
    // (Without branches: which one it is cannot be predicted.)
    const std::array<halfedge_descriptor, 3>& around = m_halfedges[g];
    const unsigned int j = 1u * (around[1] == o) + 2u * (around[2] == o);
    return around[j] == o ? halfedge_of(g, j) : null_id;
  }

  // breadth first, each component from its first face.
  void number_faces()
  {
    const std::size_t n = m_faces.size();
    m_order.resize(n + 1); // one more: what is written last may not count
    m_name.assign(n, null_id);
    std::size_t end = 0, next = 0; // of m_order; of what has been visited
    for(std::uint32_t first = 0; first < n; ++first)
    {
      append(first, end);
      if(next < end)
        m_first_of_component.push_back(static_cast<Face_id>(next));
      for(; next < end; ++next)
        for(const Halfedge_id o : m_neighbours[m_order[next]])
          if(o != null_id)
            append(face_of(o), end);
    }
  }

  // appends the face of a position to the order, unless it is there. (Without a branch: which of the faces around
  // have been met cannot be predicted.)
  void append(std::uint32_t position, std::size_t& end)
  {
    const bool is_new = m_name[position] == null_id;
    m_order[end] = position;
    m_name[position] = is_new ? static_cast<Face_id>(end) : m_name[position];
    end += is_new;
  }

  // in the order of the faces; the isolated vertices last. Returns how many are not isolated. From now on
  // m_corners holds these numbers.
  std::size_t number_vertices(Correspondence& table)
  {
    const std::size_t range_of_indices = num_vertices(m_tm);
    table.vertex_of_index.assign(range_of_indices, null_id);
    std::size_t n = 0;
    for(Face_id i = 0; i < m_faces.size(); ++i)
      for(std::uint32_t& corner : m_corners[m_order[i]])
        corner = vertex_id(corner, table, n);
    const std::size_t number_in_faces = n;
    table.vertices.resize(range_of_indices);
    std::vector<char> is_known(range_of_indices, 0);
    std::size_t number_known = 0;
    for(vertex_descriptor v : vertices(m_tm))
    {
      const Vertex_id id = vertex_id(vertex_index(v, range_of_indices), table, n);
      if(is_known[id] != 0)
        throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP,
                                     "two vertices have the index "
                                       + std::to_string(vertex_index(v, range_of_indices)));
      is_known[id] = 1;
      ++number_known;
      table.vertices[id] = v;
    }
    if(number_known != n)
      throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP,
                                   "a face has a vertex that is not among those of the mesh");
    table.vertices.resize(n); // num_vertices() may count vertices that have been removed
    return number_in_faces;
  }

  // the number of the vertex with this index: n, which grows then, if it has none yet.
  static Vertex_id vertex_id(std::uint32_t index, Correspondence& table, std::size_t& n)
  {
    Vertex_id& id = table.vertex_of_index[index];
    const bool is_new = id == null_id;
    id = is_new ? static_cast<Vertex_id>(n) : id;
    n += is_new;
    return id;
  }

  // the index of a vertex in the user's map, in its range.
  std::uint32_t vertex_index(vertex_descriptor v, std::size_t number_of_vertices) const
  {
    const std::size_t index = static_cast<std::size_t>(get(m_vim, v));
    if(index >= number_of_vertices)
      throw Invalid_geodesic_input(Reason::INVALID_INDEX_MAP,
                                   "the index " + std::to_string(index)
                                     + " of a vertex is out of range");
    return static_cast<std::uint32_t>(index);
  }

  // makes the faces. m_name[f] is that halfedge of the intrinsic mesh which is the first one of the user's face.
  template <typename Shape>
  void set_faces(const Shape& shape, Intrinsic_mesh<FT>& mesh)
  {
    const Face_id n = static_cast<Face_id>(m_faces.size());
    mesh.reset(n);
    for(Face_id i = 0; i < n; ++i)
    {
      const std::uint32_t f = m_order[i];
      Intrinsic_face<FT>& face = mesh.face(i);
      const std::array<Vertex_id, 3>& v = m_corners[f];
      const unsigned int shift = shape.shape(m_halfedges[f], f, v, face);
      for(unsigned int k = 0; k < 3; ++k)
        face.vertex[k] = v[corner_after(k, shift)];
      m_name[f] = halfedge_of(i, corners_to_first(shift));
    }
    for(Face_id i = 0; i < n; ++i)
    {
      const std::uint32_t f = m_order[i];
      const unsigned int first = index_in_face(m_name[f]);
      for(unsigned int j = 0; j < 3; ++j)
      {
        const Halfedge_id h = halfedge_of(i, corner_after(j, first)), o = renumbered(m_neighbours[f][j]);
        if(o != null_id && (mesh.source(o) != mesh.target(h) || mesh.target(o) != mesh.source(h)))
          throw Invalid_geodesic_input(Reason::NON_MANIFOLD,
                                       "face " + std::to_string(f) + " and its neighbour disagree about the ends of "
                                         + "their edge", f);
        mesh.face(i).opposite[index_in_face(h)] = o;
      }
    }
  }

  // finds the sizes of components, if there are several. Throws if one of them would get lost beside the others: all
  // lengths have one unit.
  template <typename Shape>
  void set_components(const Shape& shape, Intrinsic_mesh<FT>& mesh) const
  {
    const std::size_t n = m_first_of_component.size();
    if(n < 2)
      return;
    std::vector<typename Intrinsic_mesh<FT>::Component> components;
    components.reserve(n);
    for(std::size_t i = 0; i < n; ++i)
    {
      const Face_id first = m_first_of_component[i],
                    last = i + 1 < n ? m_first_of_component[i + 1] : static_cast<Face_id>(m_faces.size());
      FT longest = 0;
      for(Face_id f = first; f < last; ++f)
        longest = (std::max)(longest, longest_side(mesh.face(f)));
      if(longest < smallest_component())
        refuse_lengths(shape, first, last);
      components.push_back({first, longest});
    }
    mesh.set_components(components);
  }

  // (A component may have no lengths at all.)
  template <typename Shape>
  void refuse_lengths(const Shape& shape, Face_id first, Face_id last) const
  {
    for(Face_id i = first; i < last; ++i)
      for(const halfedge_descriptor h : m_halfedges[m_order[i]])
        if(shape.has_length(h))
          throw Invalid_geodesic_input(Reason::TOO_SMALL,
                                       "face " + std::to_string(m_order[i]) + " is in a component that is too small "
                                         + "beside the mesh", m_order[i]);
  }

  // the halfedge of the intrinsic mesh, from a position and the place in the user's face.
  Halfedge_id renumbered(Halfedge_id h) const
  {
    if(h == null_id)
      return null_id;
    const Halfedge_id first = m_name[face_of(h)];
    return halfedge_of(face_of(first), corner_after(index_in_face(h), index_in_face(first)));
  }

  void fill_face_tables(Correspondence& table) const
  {
    table.faces.resize(m_faces.size());
    for(std::size_t i = 0; i < m_faces.size(); ++i)
      table.faces[i] = m_faces[m_order[i]];
    table.halfedge_of_face_index.assign(m_position_of_index.size(), null_id);
    for(std::size_t index = 0; index < m_position_of_index.size(); ++index)
      if(m_position_of_index[index] != null_id)
        table.halfedge_of_face_index[index] = renumbered(halfedge_of(m_position_of_index[index], 0));
  }

  std::size_t index_of(face_descriptor f) const { return static_cast<std::size_t>(get(m_fim, f)); }

  const TriangleMesh& m_tm;
  VertexIndexMap m_vim;
  FaceIndexMap m_fim;
  std::vector<face_descriptor> m_faces;
  std::vector<std::array<halfedge_descriptor, 3>> m_halfedges;
  std::vector<std::array<std::uint32_t, 3>> m_corners; // indices in the user's map, then vertices
  std::vector<std::uint32_t> m_position_of_index;
  std::vector<std::array<Halfedge_id, 3>> m_neighbours;
  std::vector<std::uint32_t> m_order; // the position of a face of the intrinsic mesh
  std::vector<Face_id> m_first_of_component;
  std::vector<std::uint32_t> m_name;  // its inverse; in the end see set_faces()
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_INTRINSIC_MESH_FROM_FACE_GRAPH_H
