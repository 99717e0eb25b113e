// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_RANGE_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_RANGE_H

// What a user may give as a source: a vertex descriptor, a location in a face, or a range of these; what as obstacles;
// and how a descriptor that is not valid is rejected. Intrinsic_surface::source_set() turns a range into a Source_set.

#include <CGAL/Surface_mesh_geodesics/Invalid_geodesic_input.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/Parameter_sequence.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/argument_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/parameter_checks.h>
#include <CGAL/Surface_mesh_geodesics/internal/numeric/Index_types.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/barycentric_coordinates.h>
#include <CGAL/Surface_mesh_geodesics/internal/surface/walls/Wall_cut.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// --- kinds of sources ---

// True for a vertex descriptor and what converts to one. It is tried first, so a type that is both counts as a vertex.
template <typename TriangleMesh, typename Source>
struct Is_vertex
  : std::is_convertible<Source, typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
{};

// True for a pair of a face descriptor and three numbers. Anything with members `first` and `second` will do whose
// `second` has an operator[], such as std::pair with std::array or with the coordinates of a traits class; but no two
// numbers.
template <typename TriangleMesh, typename Source, typename = void>
struct Is_face_location
  : std::false_type
{};

template <typename TriangleMesh, typename Source>
struct Is_face_location<TriangleMesh, Source,
                        std::void_t<decltype(std::declval<const Source&>().first),
                                    decltype(std::declval<const Source&>().second[0])>>
  : std::integral_constant<bool, std::is_convertible<decltype(std::declval<const Source&>().first),
                                                     typename boost::graph_traits<TriangleMesh>::face_descriptor>::value
                                   && Is_triple<std::decay_t<decltype(std::declval<const Source&>().second)>>::value>
{};

// Is a source a curve? (Surface_curve has the type `Surface_curve_tag`; the public header is above this room.)
// Computations of distances, their certificates and isolines take curves. All other users of a source set reject them
// when they are compiled.
template <typename Source, typename = void>
struct Is_curve
  : std::false_type
{};

template <typename Source>
struct Is_curve<Source, std::void_t<typename Source::Surface_curve_tag>>
  : std::true_type
{};

// True for a curve on a mesh with the same faces: not on a mesh of another type, unless it shares the descriptors, as a
// filtered graph does. So the faces are compared, and not the meshes: the curve of a part may be a source on the whole.
template <typename TriangleMesh, typename Source, typename = void>
struct Is_curve_on
  : std::false_type
{};

template <typename TriangleMesh, typename Source>
struct Is_curve_on<TriangleMesh, Source, std::void_t<typename Source::Surface_curve_tag>>
  : std::is_convertible<typename Source::face_descriptor, typename boost::graph_traits<TriangleMesh>::face_descriptor>
{};

// Asked where a curve is given: what follows of it would fail at each of its descriptors. Points of another mesh need
// no such question, as they are no sources then.
template <typename TriangleMesh, typename Curve>
struct Checked_curve
{
  static_assert(!Is_curve<Curve>::value || Is_curve_on<TriangleMesh, Curve>::value,
                "the curve is on a mesh of another type");
  static constexpr bool value = true;
};

// True for a single source of any kind. Anything else is taken for a range.
template <typename TriangleMesh, typename Source>
struct Is_source
  : std::integral_constant<bool, Is_vertex<TriangleMesh, Source>::value
                                   || Is_face_location<TriangleMesh, Source>::value || Is_curve<Source>::value>
{};

// Are the sources a curve or a range of curves? One range has sources of one type; a point among curves is a curve with
// one location. So the type of the range decides which propagation runs.
template <typename Sources, typename = void>
struct Are_curves
  : Is_curve<Sources>
{};

// A range: what its elements are decides. (A curve itself is no range.)
template <typename Sources>
struct Are_curves<Sources, std::void_t<Element_of_range<Sources>>>
  : Is_curve<std::decay_t<Element_of_range<Sources>>>
{};

// The value of the named parameter first_curves: a curve, or a range of curves, also in std::ref() or std::cref(). It
// is a reference, or a copy where CGAL returns one. Requires: the parameter is given.
template <typename NamedParameters>
decltype(auto) curves_parameter(const NamedParameters& np)
{
  using Curves = std::decay_t<decltype(parameters::get_parameter_reference(np, internal_np::first_curves))>;
  static_assert(Are_curves<Curves>::value,
                "the value of the named parameter first_curves is neither a curve nor a range of curves");
  return parameters::get_parameter_reference(np, internal_np::first_curves);
}

// True for a range of sources, an array included. Asking before the loop gives one error instead of those of the loop.
// All elements have one type, so the first one decides.
template <typename TriangleMesh, typename Sources, typename = void>
struct Is_range_of_sources
  : std::false_type
{};

template <typename TriangleMesh, typename Sources>
struct Is_range_of_sources<TriangleMesh, Sources,
                           std::void_t<Element_of_range<Sources>>>
  : Is_source<TriangleMesh, std::decay_t<Element_of_range<Sources>>>
{};

// Calls visit(source) for a single source, or for each source of a range, in its order. Callers pass the same range
// twice, to find the components that are reached and to number the sources, so it must allow several passes.
template <typename TriangleMesh, typename Sources, typename Visit>
void for_each_source(const Sources& sources, Visit visit)
{
  if constexpr(Is_source<TriangleMesh, Sources>::value)
  {
    static_assert(Checked_curve<TriangleMesh, Sources>::value, "always true, if it compiles");
    visit(sources);
  }
  else
  {
    static_assert(Is_range_of_sources<TriangleMesh, Sources>::value,
                  "a source is a vertex descriptor, a pair of a face descriptor and three barycentric coordinates, or "
                  "a curve; several sources are a range of these");
    if constexpr(Is_range_of_sources<TriangleMesh, Sources>::value)
    {
      using Source = std::decay_t<Element_of_range<Sources>>;
      static_assert(Checked_curve<TriangleMesh, Source>::value, "always true, if it compiles");
      for(const auto& source : sources)
        visit(source);
    }
  }
}

// --- vertices of the user ---

// Returns a halfedge with a face and the target v; the null halfedge if v has no face in the umbrella of halfedge(v).
// Edges without faces may be linked into the border at v, so several steps may be needed. Linear in the degree of v.
template <typename TriangleMesh>
typename boost::graph_traits<TriangleMesh>::halfedge_descriptor
halfedge_in_face(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& tm)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  const typename Graph_traits::halfedge_descriptor first = halfedge(v, tm);
  typename Graph_traits::halfedge_descriptor h = first;
  while(h != Graph_traits::null_halfedge() && is_border(h, tm))
  {
    h = opposite(next(h, tm), tm);
    if(h == first) // the edges around v have no face on either side
      return Graph_traits::null_halfedge();
  }
  return h;
}

// --- validity of descriptors, before the mesh is read ---

// Elements that have been removed keep their index, and a filtered graph lacks elements of the graph below it. Only the
// mesh can tell, and not every type of mesh can. For those that cannot, like Polyhedron_3, whose descriptors point to
// freed memory then, nothing is known to be removed.
template <typename TriangleMesh, typename = void>
struct Removed_elements
{
  template <typename Descriptor>
  static bool contain(const Descriptor&, const TriangleMesh&)
  {
    return false;
  }
};

template <typename Point>
struct Removed_elements<CGAL::Surface_mesh<Point>>
{
  template <typename Descriptor>
  static bool contain(const Descriptor& d, const CGAL::Surface_mesh<Point>& tm)
  {
    return !tm.has_valid_index(d) || tm.is_removed(d);
  }
};

// CGAL::Face_filtered_graph, known by its members. It looks up the indices of its graph in tables, so that graph is
// asked first.
template <typename TriangleMesh>
struct Removed_elements<TriangleMesh,
                        std::void_t<decltype(std::declval<const TriangleMesh&>().graph()),
                                    decltype(std::declval<const TriangleMesh&>().is_in_cc(
                                      std::declval<typename boost::graph_traits<TriangleMesh>::face_descriptor>()))>>
{
  // Requires: d is not the null descriptor.
  template <typename Descriptor>
  static bool contain(const Descriptor& d, const TriangleMesh& tm)
  {
    using Graph = std::decay_t<decltype(tm.graph())>;
    return Removed_elements<Graph>::contain(d, tm.graph()) || !tm.is_in_cc(d);
  }
};

// Returns whether v is a vertex of the mesh, judged by its index. Takes constant time. A vertex of another mesh passes
// if its index fits. A filtered graph counts its elements in each call of num_vertices() and num_faces(), so loops read
// the number once and pass it on.
template <typename TriangleMesh, typename VertexIndexMap>
bool is_vertex_of(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& tm,
                  const VertexIndexMap& vim, std::size_t number_of_vertices)
{
  // (The maps of a filtered graph may be asked for its own elements only.)
  return v != boost::graph_traits<TriangleMesh>::null_vertex() && !Removed_elements<TriangleMesh>::contain(v, tm)
      && static_cast<std::size_t>(get(vim, v)) < number_of_vertices;
}

// The same for a single vertex. Takes the time of num_vertices().
template <typename TriangleMesh, typename VertexIndexMap>
bool is_vertex_of(typename boost::graph_traits<TriangleMesh>::vertex_descriptor v, const TriangleMesh& tm,
                  const VertexIndexMap& vim)
{
  return is_vertex_of(v, tm, vim, num_vertices(tm));
}

// Returns whether f is a face of the mesh, judged by its index. Requires: f is not the null face. (Callers reject that
// one before, for a reason of its own: INVALID_LOCATION.)
template <typename TriangleMesh, typename FaceIndexMap>
bool is_face_of(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& tm,
                const FaceIndexMap& fim, std::size_t number_of_faces)
{
  return !Removed_elements<TriangleMesh>::contain(f, tm) && static_cast<std::size_t>(get(fim, f)) < number_of_faces;
}

// The same for a single face. Takes the time of num_faces().
template <typename TriangleMesh, typename FaceIndexMap>
bool is_face_of(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const TriangleMesh& tm,
                const FaceIndexMap& fim)
{
  return is_face_of(f, tm, fim, num_faces(tm));
}

// Returns whether e is an edge of the mesh, as far as the mesh can tell: edges need no index. A null edge is the
// same in all meshes.
template <typename TriangleMesh>
bool is_edge_of(typename boost::graph_traits<TriangleMesh>::edge_descriptor e, const TriangleMesh& tm)
{
  return e != typename boost::graph_traits<TriangleMesh>::edge_descriptor()
      && !Removed_elements<TriangleMesh>::contain(e, tm)
      && halfedge(e, tm) != boost::graph_traits<TriangleMesh>::null_halfedge();
}

// --- rejections: `what` and `position` name the culprit in the message, as in "source 3"; without a number for
// no_element ---

[[noreturn]] inline void reject_descriptor(Invalid_geodesic_input::Reason reason, const char* what,
                                           std::size_t position, const char* fault)
{
  const std::string number
    = position == Invalid_geodesic_input::no_element ? std::string() : ' ' + std::to_string(position);
  throw Invalid_geodesic_input(reason, what + number + fault, position);
}

[[noreturn]] inline void reject_vertex(const char* what, std::size_t position)
{
  reject_descriptor(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, what, position,
                    " is not a vertex of the mesh");
}

[[noreturn]] inline void reject_face(const char* what, std::size_t position)
{
  reject_descriptor(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, what, position,
                    " is not a face of the mesh");
}

// The same for the face of a location.
[[noreturn]] inline void reject_face_of_location(const char* what, std::size_t position)
{
  reject_descriptor(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, what, position,
                    " has a face that is not one of the mesh");
}

// For functions that need a face to start in.
[[noreturn]] inline void reject_vertex_without_face(const char* what, std::size_t position)
{
  reject_descriptor(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, what, position, " is not in any face");
}

[[noreturn]] inline void reject_edge(const char* what, std::size_t position)
{
  reject_descriptor(Invalid_geodesic_input::Reason::INVALID_DESCRIPTOR, what, position,
                    " is not an edge of the mesh");
}

[[noreturn]] inline void reject_null_face(const char* what, std::size_t position)
{
  reject_descriptor(Invalid_geodesic_input::Reason::INVALID_LOCATION, what, position, " has a null face");
}

[[noreturn]] inline void reject_avoided(const char* what, std::size_t position)
{
  reject_descriptor(Invalid_geodesic_input::Reason::INVALID_LOCATION, what, position,
                    " is inside of the faces to avoid");
}

// --- obstacles: faces to avoid, and walls, which are edges to avoid ---

// They are given to the reader by the index of a face: the reader meets each face once, and asks with its index at
// hand. So faces to avoid and walls cost an array of bytes each, and a mesh without them costs one test in all. A wall
// is told to both of its faces; an edge needs no index. Faces that a mesh has got since have an index beyond the
// arrays, and are free.
struct Obstacles
{
  std::vector<char> is_avoided; // by the index of a face: is it left out? Or empty: none is.
  std::vector<Wall_bits> walls; // by the index of a face: which of its edges are walls, from halfedge(f, tm). Or empty.

  bool avoids(std::size_t face) const { return face < is_avoided.size() && is_avoided[face] != 0; }
  Wall_bits walls_of(std::size_t face) const { return face < walls.size() ? walls[face] : Wall_bits(0); }
};

// An index that is out of range marks nothing here: the reader, which sees every face, rejects it with its position.
// Faces that have been removed from the mesh are not among its faces, and are rejected in a range.
//
// Returns a flag for each index of a face, set for the faces to avoid; empty if there are none. These are the faces of
// a range, or those for which a property map is true. Throws Invalid_geodesic_input if a face of the range is not one
// of the mesh; its position is that in the range. Takes linear time.
template <typename TriangleMesh, typename FaceIndexMap, typename Faces>
std::vector<char> flags_of_avoided_faces(const TriangleMesh& tm, const FaceIndexMap& fim, const Faces& avoided)
{
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  // Functions with named parameters and the classes come here, so the message does not say which of them it was.
  static_assert(Checked_faces_to_avoid<Faces, face_descriptor>::value, "always true, if it compiles");
  const std::size_t number_of_faces = num_faces(tm);
  std::vector<char> flags;
  const auto mark = [&](face_descriptor f)
  {
    flags.resize(number_of_faces, 0);
    flags[static_cast<std::size_t>(get(fim, f))] = 1;
  };
  if constexpr(!is_set_to_avoid<Faces, face_descriptor>)
    return flags;
  else if constexpr(Is_property_map<Faces>::value)
  {
    for(const face_descriptor f : faces(tm)) // an index out of range is rejected when the mesh is read
      if(get(avoided, f) && is_face_of(f, tm, fim, number_of_faces))
        mark(f);
  }
  else
  {
    std::size_t position = 0;
    for(const face_descriptor f : avoided)
    {
      if(f == boost::graph_traits<TriangleMesh>::null_face() || !is_face_of(f, tm, fim, number_of_faces))
        reject_face("the face to avoid", position);
      mark(f);
      ++position;
    }
  }
  return flags;
}

// Edges have no index among the maps of the user, so a wall is known by a face and the number of its halfedge there.
//
// The edge of the face of h that h is: 0 for halfedge(f, tm), 1 and 2 for those behind it, 3 for a halfedge that is not
// among them: the faces of an invalid mesh need not be triangles.
template <typename TriangleMesh>
unsigned int number_in_face(typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, const TriangleMesh& tm)
{
  auto g = halfedge(face(h, tm), tm);
  unsigned int k = 0;
  for(; k < 3 && g != h; ++k)
    g = next(g, tm);
  return k;
}

// A map is asked for the edges of faces, not for those of edges(tm), which a model of FaceListGraph need not have. Both
// halfedges of an edge give the same edge, so both faces learn of a wall.
//
// Returns the walls by the index of a face; empty if there are none. They are the edges of a range, or those for which
// a property map is true. An edge at the border or without faces is valid, and cuts nothing. Throws
// Invalid_geodesic_input if an edge of the range is not one of the mesh; its position is that in the range. Linear.
template <typename TriangleMesh, typename FaceIndexMap, typename Edges>
std::vector<Wall_bits> walls_of_edges(const TriangleMesh& tm, const FaceIndexMap& fim, const Edges& avoided)
{
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  using edge_descriptor = typename Graph_traits::edge_descriptor;
  using halfedge_descriptor = typename Graph_traits::halfedge_descriptor;
  static_assert(Checked_edges_to_avoid<Edges, edge_descriptor>::value, "always true, if it compiles");
  const std::size_t number_of_faces = num_faces(tm);
  std::vector<Wall_bits> walls;
  const auto mark = [&](typename Graph_traits::face_descriptor f, unsigned int k)
  {
    walls.resize(number_of_faces, 0);
    Wall_bits& bits = walls[static_cast<std::size_t>(get(fim, f))];
    bits = static_cast<Wall_bits>(bits | 1u << k);
  };
  if constexpr(!is_set_to_avoid<Edges, edge_descriptor>)
    return walls;
  else if constexpr(Is_property_map<Edges>::value)
  {
    for(const auto f : faces(tm))
    {
      halfedge_descriptor h = halfedge(f, tm);
      for(unsigned int k = 0; k < 3; ++k, h = next(h, tm))
        if(get(avoided, edge(h, tm)) && is_face_of(f, tm, fim, number_of_faces)) // as for faces
          mark(f, k);
    }
  }
  else
  {
    std::size_t position = 0;
    for(const edge_descriptor e : avoided)
    {
      if(!is_edge_of(e, tm))
        reject_edge("the edge to avoid", position);
      for(const halfedge_descriptor h : {halfedge(e, tm), opposite(halfedge(e, tm), tm)})
        if(!is_border(h, tm))
        {
          const unsigned int k = number_in_face(h, tm);
          if(k == 3 || !is_face_of(face(h, tm), tm, fim, number_of_faces))
            reject_edge("the edge to avoid", position);
          mark(face(h, tm), k);
        }
      ++position;
    }
  }
  return walls;
}

// Is an edge one of the walls? A wall at the border is known to its one face, an edge without faces is none. Constant.
template <typename TriangleMesh, typename FaceIndexMap>
bool is_wall_of(typename boost::graph_traits<TriangleMesh>::edge_descriptor e, const TriangleMesh& tm,
                const FaceIndexMap& fim, const Obstacles& obstacles)
{
  if(obstacles.walls.empty() || !is_edge_of(e, tm))
    return false;
  auto h = halfedge(e, tm);
  if(is_border(h, tm))
    h = opposite(h, tm);
  return !is_border(h, tm)
      && is_wall(obstacles.walls_of(static_cast<std::size_t>(get(fim, face(h, tm)))), number_in_face(h, tm));
}

// The value is a range, or a map that is read at each face; either may be in std::ref() or std::cref(). A value of
// another type does not compile.
//
// Returns the flags of the faces to avoid among the named parameters; none if the parameter is not there, at no cost.
// Throws Invalid_geodesic_input. Takes linear time.
template <typename TriangleMesh, typename FaceIndexMap, typename NamedParameters>
std::vector<char> avoided_faces(const TriangleMesh& tm, const FaceIndexMap& fim, const NamedParameters& np)
{
  if constexpr(Has_parameter<NamedParameters, internal_np::faces_to_avoid_t>::value)
  {
    return flags_of_avoided_faces(tm, fim, parameters::get_parameter_reference(np, internal_np::faces_to_avoid));
  }
  else
    return {};
}

// Returns the walls among the named parameters, the edges to avoid, told to the faces on both sides; none if the
// parameter is not there, at no cost. Throws Invalid_geodesic_input. Takes linear time.
template <typename TriangleMesh, typename FaceIndexMap, typename NamedParameters>
std::vector<Wall_bits> walls(const TriangleMesh& tm, const FaceIndexMap& fim, const NamedParameters& np)
{
  if constexpr(Has_parameter<NamedParameters, internal_np::edges_to_avoid_t>::value)
  {
    return walls_of_edges(tm, fim, parameters::get_parameter_reference(np, internal_np::edges_to_avoid));
  }
  else
    return {};
}

// Returns the faces and the edges to avoid, for the reader of the mesh.
template <typename TriangleMesh, typename FaceIndexMap, typename NamedParameters>
Obstacles obstacles(const TriangleMesh& tm, const FaceIndexMap& fim, const NamedParameters& np)
{
  return {avoided_faces(tm, fim, np), walls(tm, fim, np)};
}

// Coordinates of a type with fewer digits than double err by the rounding of that type, which is far more than the
// tolerance of locations: no point inside a face would be valid.
//
// Returns three coordinates as numbers of type double. Those of such a type become valid if they are so up to
// Tolerance::location() with the epsilon of that type: none is negative, and the sum is 1 up to rounding.
template <typename Number>
Barycentric<double> coordinates_in_double(const Number& a, const Number& b, const Number& c)
{
  Barycentric<double> r{CGAL::to_double(a), CGAL::to_double(b), CGAL::to_double(c)};
  if constexpr(std::is_floating_point<Number>::value
               && std::numeric_limits<Number>::digits < std::numeric_limits<double>::digits)
  {
    const double tolerance = std::sqrt(static_cast<double>(std::numeric_limits<Number>::epsilon())) / 16;
    double sum = r[0] + r[1] + r[2];
    if(!(std::abs(sum - 1) <= tolerance) || !(*std::min_element(r.begin(), r.end()) >= -tolerance))
      return r;
    for(double& x : r)
      x = (std::max)(0., x);
    sum = r[0] + r[1] + r[2];
    for(double& x : r)
      x /= sum;
  }
  return r;
}

// Returns the barycentric coordinates of a location in the order of the corners of the intrinsic face. The user's order
// begins at the source of halfedge(f, tm), which is h in the intrinsic mesh. Throws if they are not valid
// (are_valid_coordinates()). Does not round them to the edges; see snap_coordinates(). Their number type is any that
// CGAL::to_double() takes.
template <typename FT, typename Coordinates>
Barycentric<FT> intrinsic_coordinates(Halfedge_id h, const Coordinates& b, const char* what, std::size_t position)
{
  const Barycentric<double> user = coordinates_in_double(b[0], b[1], b[2]);
  Barycentric<FT> r;
  for(unsigned int j = 0; j < 3; ++j)
    r[(index_in_face(h) + j) % 3] = FT(user[j]);
  if(!are_valid_coordinates(r))
    reject_descriptor(Invalid_geodesic_input::Reason::INVALID_LOCATION, what, position, " is not in its face");
  return r;
}

// The coordinates of a location in the order of the user's corners, which is that of a face whose first halfedge is
// halfedge 0. They tell whether it is at a corner or on an edge: snap_coordinates(). Throws as for locations.
template <typename FT, typename Coordinates>
Barycentric<FT> snapped_coordinates(const Coordinates& b, const char* what, std::size_t position)
{
  Barycentric<FT> c = intrinsic_coordinates<FT>(halfedge_of(0, 0), b, what, position);
  snap_coordinates(c);
  return c;
}

// An edge or a vertex at the rim of what is avoided belongs to both sides. Of several faces around a vertex, the first
// one counts in the order of halfedges_around_source(): where the vertex is pinched, this decides in which of its
// umbrellas the point is.
//
// Finds where a snapped point of a face to avoid is in one that is not avoided: is_open(h) says whether h has such a
// face. Returns its halfedge on which the point is, and the coordinates of the source and the target. Throws for a
// point inside of what is avoided. Linear in the degree for a vertex, else constant. Requires: f is a triangle.
template <typename TriangleMesh, typename FT, typename IsOpen>
std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, std::array<FT, 2>>
place_at_rim(typename boost::graph_traits<TriangleMesh>::face_descriptor f, const Barycentric<FT>& b,
             const TriangleMesh& tm, IsOpen is_open, const char* what, std::size_t position)
{
  auto h = halfedge(f, tm);
  for(unsigned int k = 0; k < 3; ++k, h = next(h, tm))
  {
    if(b[next_corner(k)] == 0 && b[previous_corner(k)] == 0)
      for(const auto g : halfedges_around_source(h, tm))
        if(is_open(g))
          return {g, {{FT(1), FT(0)}}};
    if(b[k] != 0 && b[next_corner(k)] != 0 && b[previous_corner(k)] == 0 && is_open(opposite(h, tm)))
      return {opposite(h, tm), {{b[next_corner(k)], b[k]}}};
  }
  reject_avoided(what, position);
}

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_SOURCE_RANGE_H
