// Copyright (c) 2026  The Surface_mesh_geodesics authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Surface_mesh_geodesics authors

#ifndef CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_MAP_CHECKS_H
#define CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_MAP_CHECKS_H

// Checks of property maps: those that classes take as template parameters, and those that functions write to. They
// judge by the types that a map declares, so that a map of another mesh, or of another type of values, is rejected
// where it is named, and not deep inside a computation.

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Surface_mesh_geodesics {
namespace internal {

// The type of the values of a property map whose keys a Key converts to; void for anything else.
template <typename Map, typename Key, typename = void>
struct Value_of_map
{
  using type = void;
};

template <typename Map, typename Key>
struct Value_of_map<Map, Key,
                    std::enable_if_t<std::is_convertible<Key, typename boost::property_traits<Map>::key_type>::value>>
{
  using type = typename boost::property_traits<Map>::value_type;
};

// True for a property map: its traits name a category, also where a user has specialized them. All other types are
// ranges. (Both may have begin().)
template <typename T, typename = void>
struct Is_property_map
  : std::false_type
{};

template <typename T>
struct Is_property_map<T, std::void_t<typename boost::property_traits<T>::category>>
  : std::true_type
{};

// True for a property map that takes a Key, also one of Boost that ignores its keys.
template <typename Map, typename Key, typename = void>
struct Has_keys
  : std::false_type
{};

template <typename Map, typename Key>
struct Has_keys<Map, Key, std::void_t<typename boost::property_traits<Map>::key_type>>
  : std::integral_constant<bool, std::is_convertible<Key, typename boost::property_traits<Map>::key_type>::value
                                   || std::is_void<typename boost::property_traits<Map>::key_type>::value>
{};

// True for a property map that cannot be written: it says so, or it has references and its put() is Boost's, which
// assigns to a reference, but the reference is one to a constant. (Boost's map of a `const std::map` does not say so.)
template <typename Map, typename = void>
struct Is_read_only
  : std::false_type
{};

template <typename Map>
struct Is_read_only<Map, std::void_t<typename boost::property_traits<Map>::category,
                                     typename boost::property_traits<Map>::reference>>
  : std::integral_constant<
      bool, std::is_same<typename boost::property_traits<Map>::category, boost::readable_property_map_tag>::value
              || (std::is_same<typename boost::property_traits<Map>::category, boost::lvalue_property_map_tag>::value
                  && std::is_const<std::remove_reference_t<typename boost::property_traits<Map>::reference>>::value
                  && std::is_base_of<boost::put_get_helper<typename boost::property_traits<Map>::reference, Map>,
                                     Map>::value)>
{};

// True for a property map to which a Value can be written at a Key. Integers would cut off the digits of distances,
// without a word: they convert like any other type of numbers.
template <typename Map, typename Key, typename Value>
struct Is_map_for
  : std::integral_constant<bool, !Is_read_only<Map>::value
                                   && std::is_convertible<Value, typename Value_of_map<Map, Key>::type>::value
                                   && (!std::is_floating_point<Value>::value
                                       || !std::is_integral<typename Value_of_map<Map, Key>::type>::value)>
{};

// True for a property map to which numbers can be written at a Key, converted explicitly: the number type of a kernel
// may have no other way. Queries of the classes write such numbers. (Is_map_for asks for an implicit conversion, as the
// functions write what the user has asked for: numbers of type double.)
template <typename Map, typename Key, typename = void>
struct Is_map_for_numbers
  : std::false_type
{};

template <typename Map, typename Key>
struct Is_map_for_numbers<Map, Key, std::void_t<typename boost::property_traits<Map>::value_type>>
  : std::integral_constant<bool, Has_keys<Map, Key>::value && !Is_read_only<Map>::value
                                   && std::is_constructible<typename boost::property_traits<Map>::value_type,
                                                            double>::value>
{};

// True for a property map from which numbers of any type that CGAL::to_double() takes can be read at a Key.
template <typename Map, typename Key, typename = void>
struct Is_map_of_numbers
  : std::false_type
{};

template <typename Map, typename Key>
struct Is_map_of_numbers<Map, Key, std::void_t<decltype(CGAL::to_double(
                                     std::declval<const typename boost::property_traits<Map>::value_type&>()))>>
  : std::integral_constant<bool, Has_keys<Map, Key>::value
                                   && std::is_convertible<decltype(CGAL::to_double(
                                        std::declval<const typename boost::property_traits<Map>::value_type&>())),
                                                          double>::value>
{};

// True for a property map from which a Value can be read at a Key.
template <typename Map, typename Key, typename Value>
struct Is_readable_map
  : std::is_convertible<typename Value_of_map<Map, Key>::type, Value>
{};

// True if the values are indices. A map of floating-point numbers, such as one of distances, has none, although they
// convert.
template <typename Map, typename Key>
struct Is_index_map
  : std::integral_constant<bool, Is_readable_map<Map, Key, std::size_t>::value
                                   && !std::is_floating_point<typename Value_of_map<Map, Key>::type>::value>
{};

// True for a point in space: of any kernel, or a class of the user with these members. The functions read nothing else
// of a point, so its traits are not asked.
template <typename Point, typename = void>
struct Is_point
  : std::false_type
{};

template <typename Point>
struct Is_point<Point, std::void_t<decltype(std::declval<const Point&>().x(), std::declval<const Point&>().y(),
                                            std::declval<const Point&>().z())>>
  : std::true_type
{};

// True if the sequence has a parameter with this tag. What a function does with a parameter that is not there is
// decided at compile time: nothing is computed for a map that nobody wants.
template <typename NamedParameters, typename Tag>
struct Has_parameter
  : std::integral_constant<bool, !CGAL::parameters::is_default_parameter<NamedParameters, Tag>::value>
{};

// The type of the value of a named parameter, without reference. (A map of the mesh in std::ref() is rejected:
// functions of CGAL do not look through it either.)
template <typename NamedParameters, typename Tag>
using Value_of_parameter = std::decay_t<decltype(CGAL::parameters::get_parameter(
  std::declval<const NamedParameters&>(), std::declval<Tag>()))>;

// Does not compile if a map of a mesh among the named parameters is wrong. Without this, the compiler would complain of
// the line where the map is read first, many calls below the one of the user; and a map of distances in the place of
// one of indices would compile.
template <typename TriangleMesh, typename NamedParameters>
auto check_maps(const NamedParameters&)
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;
  if constexpr(Has_parameter<NamedParameters, CGAL::internal_np::vertex_index_t>::value)
  {
    using Map = Value_of_parameter<NamedParameters, CGAL::internal_np::vertex_index_t>;
    static_assert(Is_index_map<Map, vertex_descriptor>::value,
                  "the named parameter vertex_index_map is not a property map from vertices of the mesh to indices");
  }
  if constexpr(Has_parameter<NamedParameters, CGAL::internal_np::face_index_t>::value)
  {
    using Map = Value_of_parameter<NamedParameters, CGAL::internal_np::face_index_t>;
    static_assert(Is_index_map<Map, face_descriptor>::value,
                  "the named parameter face_index_map is not a property map from faces of the mesh to indices");
  }
  if constexpr(Has_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>::value)
  {
    using Map = Value_of_parameter<NamedParameters, CGAL::internal_np::vertex_point_t>;
    static_assert(Is_point<typename Value_of_map<Map, vertex_descriptor>::type>::value,
                  "the named parameter vertex_point_map is not a property map from vertices of the mesh to points");
  }
}

// Does not compile if a map of a class with the points of a mesh is wrong.
template <typename TriangleMesh, typename Point, typename VertexIndexMap, typename FaceIndexMap,
          typename VertexPointMap>
struct Maps_of_class
{
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  using face_descriptor = typename boost::graph_traits<TriangleMesh>::face_descriptor;

  static_assert(Is_index_map<VertexIndexMap, vertex_descriptor>::value,
                "VIM is not a property map from the vertices of the mesh to indices");
  static_assert(Is_index_map<FaceIndexMap, face_descriptor>::value,
                "FIM is not a property map from the faces of the mesh to indices");
  static_assert(Is_readable_map<VertexPointMap, vertex_descriptor, Point>::value,
                "VPM is not a property map from the vertices of the mesh to points of the traits");
  static constexpr bool value = true;
};

} // namespace internal
} // namespace Surface_mesh_geodesics
} // namespace CGAL

#endif // CGAL_SURFACE_MESH_GEODESICS_INTERNAL_INTERFACE_PARAMETERS_MAP_CHECKS_H
