// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_ARGUMENT_CHECKS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_ARGUMENT_CHECKS_H

// Checks of the arguments that are no named parameters: a mesh, a class of traits, a range, an output iterator, a
// diagram. Without them the first message of the compiler is about a line of Boost, or of an algorithm.
//
// A class `Checked_...` has the messages, so that several functions share them: its member `value` is always true, if
// it compiles. A trait `Is_...` asks without a message: where it is false, the code that would fail is left out, so
// one message is the only one.
//
// Where to put a check: compilers read the body of a function template when they are done with what they have begun,
// unless the type of its result is `auto`. So a check is in the public function, or in a class whose type is named
// there, before any call of a function of type `auto`. What is read later comes too late: its message is not the first.
//
// A check may ask for less than the concept does, never for more: a call that works today has to compile tomorrow. So
// traits look for one member or function that the usual mistakes lack.

#include <CGAL/Surface_mesh_geodesics/internal/interface/parameters/map_checks.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// --- ranges ---

// What a range-based loop finds: members, or functions in the namespace of the range; arrays, too.
namespace beginning_of_range {
using std::begin;
using std::end;

template <typename Range>
auto element(const Range& range) -> decltype(static_cast<void>(end(range)), *begin(range));
} // namespace beginning_of_range

template <typename Range>
using Element_of_range = decltype(beginning_of_range::element(std::declval<const Range&>()));

// True for a range whose elements convert to Element.
template <typename Range, typename Element, typename = void>
struct Is_range_of
  : std::false_type
{};

template <typename Range, typename Element>
struct Is_range_of<Range, Element, std::void_t<Element_of_range<Range>>>
  : std::is_convertible<Element_of_range<Range>, Element>
{};

// A range of vertices that is no range of sources: targets of a matrix, or vertices of a symmetric one. Locations are
// no targets, as a propagation knows distances at vertices only.
template <typename Vertices, typename Vertex>
struct Checked_vertices
{
  static_assert(Is_range_of<Vertices, Vertex>::value,
                "the vertices or targets are not a range of vertices of the mesh");
  static constexpr bool value = true;
};

// --- meshes and what stands for them ---

// True for a mesh, as far as this package knows: it has a number of faces. (boost::graph_traits cannot be asked: for a
// type that is no graph, its error is not one that a trait could catch.)
template <typename TriangleMesh, typename = void>
struct Is_mesh
  : std::false_type
{};

template <typename TriangleMesh>
struct Is_mesh<TriangleMesh, std::void_t<decltype(num_faces(std::declval<const TriangleMesh&>()))>>
  : std::true_type
{};

// What a function or a class asks before it reads types of the mesh.
template <typename TriangleMesh>
struct Checked_mesh
{
  static_assert(Is_mesh<TriangleMesh>::value,
                "the type of the mesh is not a model of FaceListGraph, such as CGAL::Surface_mesh");
  static constexpr bool value = true;
};

// True for a mesh to which vertices can be added: it is not const, and no other thing. What else CGAL's algorithms need
// of an output differs, so nothing else is asked.
template <typename OutputMesh, typename = void>
struct Is_output_mesh
  : std::false_type
{};

template <typename OutputMesh>
struct Is_output_mesh<OutputMesh, std::void_t<decltype(add_vertex(std::declval<OutputMesh&>()))>>
  : std::true_type
{};

// Asked first, as CGAL's algorithms would fail far inside.
template <typename OutputMesh>
struct Checked_output_mesh
{
  static_assert(Is_output_mesh<OutputMesh>::value,
                "the output is not a mesh to which faces can be added: it is const, or not a model of "
                "MutableFaceGraph, such as CGAL::Surface_mesh");
  static constexpr bool value = true;
};

// Does a map take a Value, converted or assigned? Maps that ignore their keys ignore values of any type. Anything but a
// map is rejected for its keys, so it passes here.
template <typename Map, typename Key, typename Value>
constexpr bool takes_value()
{
  if constexpr(Has_keys<Map, Key>::value && !std::is_void<typename boost::property_traits<Map>::key_type>::value)
  {
    using Own = typename boost::property_traits<Map>::value_type;
    return std::is_convertible<Value, Own>::value
        || std::is_assignable<std::add_lvalue_reference_t<Own>, Value>::value;
  }
  else
    return true;
}

// Checks an output mesh, as above, and a map that receives a Value for each of its new faces. (The type `auto` is not
// idle: the compiler has to read the body at once, before the rest of the caller.)
template <typename OutputMesh, typename FaceMap, typename Value>
auto check_output_mesh()
{
  static_assert(Checked_output_mesh<OutputMesh>::value, "always true, if it compiles");
  if constexpr(Is_output_mesh<OutputMesh>::value)
  {
    using face_descriptor = typename boost::graph_traits<OutputMesh>::face_descriptor;
    static_assert(Has_keys<FaceMap, face_descriptor>::value && !Is_read_only<FaceMap>::value,
                  "the map of faces cannot be written: it is not a property map of the faces of the output");
    static_assert(takes_value<FaceMap, face_descriptor, Value>(), "the map of faces does not take the type 'Value'");
  }
}

// True for the traits of the classes. A mesh and a kernel, which users give in their place, lack one of these types.
// (The first argument of CGAL's other classes on meshes is a mesh, so the mistake is near.)
template <typename Traits, typename = void>
struct Is_traits_class
  : std::false_type
{};

template <typename Traits>
struct Is_traits_class<Traits, std::void_t<typename Traits::Triangle_mesh, typename Traits::Barycentric_coordinates>>
  : std::true_type
{};

// Asked at the beginning of a class, before its types are named.
template <typename Traits>
struct Checked_traits_class
{
  static_assert(Is_traits_class<Traits>::value,
                "the first template argument is not a model of SurfaceMeshShortestPathTraits, such as "
                "CGAL::Surface_mesh_shortest_path_traits<Kernel, Triangle_mesh>");
  static constexpr bool value = true;
};

// True for a diagram, which is known by the type of the numbers of its sites. The class is above this room. A mesh is
// the usual mistake: the functions for drawing read as if they took one.
template <typename Diagram, typename = void>
struct Is_diagram
  : std::false_type
{};

template <typename Diagram>
struct Is_diagram<Diagram, std::void_t<typename Diagram::Site_index>>
  : std::true_type
{};

// Asked by functions that take any specialization of the class.
template <typename Diagram>
struct Checked_diagram
{
  static_assert(Is_diagram<Diagram>::value, "the diagram is not a Surface_mesh_geodesic_Voronoi_diagram");
  static constexpr bool value = true;
};

// --- triples ---

// True for two coordinates: a type with x and y, but no z, or an array of fewer than three numbers. Their operator[]
// would be asked for the third one.
template <typename T, typename = void>
struct Is_of_the_plane
  : std::false_type
{};

template <typename T>
struct Is_of_the_plane<T, std::void_t<decltype(std::declval<const T&>().x()), decltype(std::declval<const T&>().y())>>
  : std::integral_constant<bool, !Is_point<T>::value>
{};

template <typename Number>
struct Is_of_the_plane<std::array<Number, 2>>
  : std::true_type
{};

// True for three coordinates: anything with an operator[] for 0, 1, 2.
template <typename T, typename = void>
struct Is_triple
  : std::false_type
{};

template <typename T>
struct Is_triple<T, std::void_t<decltype(std::declval<const T&>()[0])>>
  : std::integral_constant<bool, !Is_of_the_plane<T>::value>
{};

// --- output iterators ---

// True for what can be moved on and written at, whatever it takes. Containers are the usual mistake.
template <typename Output, typename = void>
struct Is_iterator
  : std::false_type
{};

template <typename Output>
struct Is_iterator<Output, std::void_t<decltype(*std::declval<Output&>()++)>>
  : std::true_type
{};

// True for an output iterator that takes a Value, which is a reference if an object with a name is written. It is the
// assignment of the function itself that is asked for: proxies of users may tell copies from moves.
template <typename Output, typename Value, typename = void>
struct Is_output_iterator
  : std::false_type
{};

template <typename Output, typename Value>
struct Is_output_iterator<Output, Value, std::void_t<decltype(*std::declval<Output&>()++ = std::declval<Value>())>>
  : std::true_type
{};

// (The compiler prints which types 'Output' and 'Value' are.)
template <typename Output, typename Value>
struct Checked_output_iterator
{
  static constexpr bool is_iterator = Is_iterator<Output>::value;
  static_assert(is_iterator, "the output is not an output iterator; to fill a container, pass "
                             "std::back_inserter(container)");
  static_assert(!is_iterator || Is_output_iterator<Output, Value>::value,
                "the output iterator 'Output' does not take what this function writes, which has the type 'Value'");
  static constexpr bool value = true;
};

// --- faces and edges to avoid: a range of them, or a map to bool ---

// What is known of a set, before any of it is read. The primary template is for ranges and what is neither. (A type
// that is both is taken for a map, as where it is read: traits of a map are made on purpose, begin() is a common name.)
template <typename Set, typename Descriptor, bool is_map = Is_property_map<Set>::value>
struct Set_to_avoid
{
  static constexpr bool is_map_or_range = Is_range_of<Set, Descriptor>::value;
  static constexpr bool has_keys = true;
  static constexpr bool has_flags = true;
};

// Numbers convert to bool, too: a map of patches would avoid all faces but those of patch 0.
// Boost's maps that ignore their keys are for all elements, so they are for these, too.
template <typename Set, typename Descriptor>
struct Set_to_avoid<Set, Descriptor, true>
{
  static constexpr bool is_map_or_range = true;
  static constexpr bool has_keys = Has_keys<Set, Descriptor>::value;
  static constexpr bool has_flags = std::is_same<typename boost::property_traits<Set>::value_type, bool>::value;
};

// One message of three: a set without keys is asked for nothing else.
template <typename Faces, typename Face>
struct Checked_faces_to_avoid
{
  using Set = Set_to_avoid<Faces, Face>;
  static_assert(Set::is_map_or_range,
                "the value of faces_to_avoid is neither a range of faces nor a property map of the faces of the mesh");
  static_assert(Set::has_keys, "the value of faces_to_avoid is a map, but its keys are not the faces of the mesh");
  static_assert(Set::has_flags, "the value of faces_to_avoid is a map, but its values are not of type bool");
  static constexpr bool value = true;
};

// The same for edges, with messages of its own, as a message is a literal.
template <typename Edges, typename Edge>
struct Checked_edges_to_avoid
{
  using Set = Set_to_avoid<Edges, Edge>;
  static_assert(Set::is_map_or_range,
                "the value of edges_to_avoid is neither a range of edges nor a property map of the edges of the mesh");
  static_assert(Set::has_keys, "the value of edges_to_avoid is a map, but its keys are not the edges of the mesh");
  static_assert(Set::has_flags, "the value of edges_to_avoid is a map, but its values are not of type bool");
  static constexpr bool value = true;
};

// True for a set that can be read. Where it is not, a message has said why.
template <typename Set, typename Descriptor>
constexpr bool is_set_to_avoid = Set_to_avoid<Set, Descriptor>::is_map_or_range
                                 && Set_to_avoid<Set, Descriptor>::has_keys;

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_ARGUMENT_CHECKS_H
